// Structs and arrays in memory -> one variable per number, promoted to a value.
//
//     struct { i33 x; i8 y[2]; } v;     ->     i33 v.x;  i8 v.y0;  i8 v.y1;
//
// A variable is split once every access to it is to a known number of it: after unrolling for what
// loops run over, after expansion for what is indexed.  Names of C++ variables follow their parts.
//
// Doc: docs/generator.md   Test: tests/generator/frontend/design_test.cpp

#pragma once

#include <llvm/IR/Function.h>

namespace hlsgen {

// True if anything could be split or promoted.
bool split_variables(llvm::Function& function);

}  // namespace hlsgen
