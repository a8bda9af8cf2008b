// Loops with a constant bound -> their iterations, one after the other.
//
//     for (i = 0; i < 3; ++i) s += a[i];     ->     s += a[0]; s += a[1]; s += a[2];
//
// A bound is enough; early exits stay as conditions.  Inner loops whose bound depends on an outer
// one are unrolled after it.
//
// Doc: docs/generator.md   Test: tests/generator/frontend/design_test.cpp

#pragma once

#include <llvm/IR/Function.h>

namespace hlsgen {

inline constexpr unsigned kMaxIterations = 4096;

// Refuses what has no bound, or a larger one.
void unroll_loops(llvm::Function& function);

}  // namespace hlsgen
