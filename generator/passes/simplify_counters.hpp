// Registers that count, or add, when told to.
//
//     r + {8{c}}       =>  c ? r - 1 : r      where r is a register and nobody else reads the sum
//     r + {0, c}       =>  c ? r + 1 : r
//     r + (c ? v : 0)  =>  c ? r + v : r
//
// LLVM folds the condition of a counter into its addend.  Told apart again it becomes the clock enable
// of the flip-flops, which costs nothing, instead of an operand of the adder.
//
// Test: tests/generator/backend_pass_test.cpp

#pragma once

#include "generator/netlist.hpp"

namespace hlsgen {

bool simplify_counters(Module& module);

}  // namespace hlsgen
