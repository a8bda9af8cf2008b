// What a tick may call and touch, checked on the IR as clang wrote it, while calls and lines are
// those of the source: no recursion, no heap, no unknown callee, no pointer to a function, no
// floating point, no volatile, no assembler, no state but the block's own members.
//
// Doc: docs/generator.md   Test: tests/generator/frontend/refusal_test.cpp

#pragma once

#include "generator/cpp/blocks.hpp"

namespace hlsgen {

// Walks from `function` through everything it calls, except the ticks of blocks.
void check_callees(llvm::Function& function, const Blocks& blocks);

}  // namespace hlsgen
