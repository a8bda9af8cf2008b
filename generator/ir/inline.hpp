// Calls -> one function.
//
//     out = tick(state, in)     ->     the body of tick, with everything it calls in place
//
// Ticks of child blocks stay calls.  Pointer variables (`this`, references) are promoted at once,
// and a local array that is only ever a copy of a constant becomes that constant, so that it can
// print as a table.
//
// Doc: docs/generator.md   Test: tests/generator/frontend/design_test.cpp

#pragma once

#include "generator/cpp/blocks.hpp"

namespace hlsgen {

// `own` is the tick that `function` stands for, if any: the one tick that is taken in.
void inline_calls(llvm::Function& function, const llvm::Function* own, const Blocks& blocks);

}  // namespace hlsgen
