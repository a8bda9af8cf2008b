// LLVM's own passes, by their names in `opt -passes=`.
//
// Doc: docs/generator.md   Test: tests/generator/frontend/design_test.cpp

#pragma once

#include <llvm/IR/Function.h>

namespace hlsgen {

void run_passes(llvm::Function& function, llvm::StringRef pipeline);

}  // namespace hlsgen
