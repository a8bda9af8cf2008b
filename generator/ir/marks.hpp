// Local variables without a value -> variables with a mark (Opaque::undefined) that no optimisation
// folds away.
//
//     int x;                 ->      int x = undefined(site);
//     if (a) x = 1;                  if (a) x = 1;
//     out.y = x;                     out.y = x;         refused: the mark reaches an output
//
// Doc: docs/generator.md   Test: tests/generator/frontend/refusal_test.cpp

#pragma once

#include <llvm/IR/Function.h>

#include "generator/ir/opaque.hpp"

namespace hlsgen {

// Before anything is promoted to registers; removes the lifetime markers, which it consumes.
void mark_variables(llvm::Function& function, Opaque& opaque);

// Refuses when a mark is left: for functions that must come to constants.
void check_marks(const llvm::Function& function, const Opaque& opaque);

}  // namespace hlsgen
