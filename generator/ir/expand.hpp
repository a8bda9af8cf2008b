// Accesses at a variable index -> accesses to every element, and a choice.
//
//     x = a[i];      ->   x = i[1] ? (i[0] ? a[3] : a[2]) : (i[0] ? a[1] : a[0]);
//     a[i] = x;      ->   a[0] = i == 0 ? x : a[0];  a[1] = i == 1 ? x : a[1];  ...
//     x = kTable[i]; ->   x = table(i);                               constants stay a table
//
// Elements then stand at constant offsets, and LLVM promotes them to registers.
//
// Doc: docs/generator.md   Test: tests/generator/frontend/design_test.cpp

#pragma once

#include <llvm/IR/Function.h>

#include "generator/ir/opaque.hpp"

namespace hlsgen {

inline constexpr std::uint64_t kMaxElements = 4096;

void expand_accesses(llvm::Function& function, Opaque& opaque);

}  // namespace hlsgen
