// A choice between pointers -> a choice between values.
//
//     x = *(c ? &a : &b);     ->     x = c ? a : b;
//     *(c ? &a : &b) = x;     ->     a = c ? x : a;  b = c ? b : x;
//
// Doc: docs/generator.md   Test: tests/generator/frontend/design_test.cpp

#pragma once

#include <llvm/IR/Function.h>

namespace hlsgen {

// True if there was one.
bool choose_values(llvm::Function& function);

}  // namespace hlsgen
