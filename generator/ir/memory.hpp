// Memory -> values, as far as it goes: copies split, choices between pointers moved into values,
// indices that became constant freed of their guards, variables split and promoted, and what
// follows from that.  Run again whenever something has become known.
//
// Doc: docs/generator.md   Test: tests/generator/frontend/design_test.cpp

#pragma once

#include <llvm/IR/Function.h>

namespace hlsgen {

void simplify_memory(llvm::Function& function);

}  // namespace hlsgen
