// Whether a class is a memory: steplock::Memory<Contents>, known by its name and its one template
// argument (hls/numeric/memory.hpp).  Its module is called after the contents.
//
// Doc: docs/generator.md   Test: tests/generator/frontend/memory_test.cpp

#pragma once

#include "generator/cpp/blocks.hpp"

namespace hlsgen {

// The argument; null for any other class.
const llvm::DICompositeType* contents_of(const llvm::DICompositeType* type);

// Its module, once the reset values are known.
Module memory_of(const Block& block);

}  // namespace hlsgen
