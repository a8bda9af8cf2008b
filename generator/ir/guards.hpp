// Indices that the compiler cannot see -> indices that must prove to lie within their array.
//
//     p = &a[i];            ->     p = &a[index(i, 4)];       a has 4 elements
//
// Insertion happens before any optimisation, because LLVM takes every index for valid and draws
// conclusions from that.  Once the function is free of loops and memory the range of each index is
// known as well as it can be; what does not prove is refused.
//
// Doc: docs/generator.md   Test: tests/generator/frontend/refusal_test.cpp

#pragma once

#include <llvm/IR/Function.h>

#include "generator/ir/opaque.hpp"

namespace hlsgen {

void insert_guards(llvm::Function& function, Opaque& opaque);

// Takes away the guards of indices that have become valid constants.  True if there were any.
bool fold_guards(llvm::Function& function);

// The sites of the guards that do not prove, in the order of the function; the others are taken
// away.
std::vector<unsigned> prove_guards(llvm::Function& function);

}  // namespace hlsgen
