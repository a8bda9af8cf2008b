// Constants, and operands that do not matter.
//
//     3 + 4                     =>  7
//     x + 0, x - 0, x * 1       =>  x
//     x - x, x ^ x, x & 0       =>  0
//     (x + 3) + 4               =>  x + 7
//     x - 5                     =>  x + (2^w - 5)       one form for sums with a constant
//     x * 8, x << 3             =>  {x[w-4:0], 3'd0}
//     5 + x                     =>  x + 5               constants stand right
//     1-bit +, -, *             =>  ^, ^, &
//
// Test: tests/generator/backend_pass_test.cpp

#pragma once

#include "generator/netlist.hpp"

namespace hlsgen {

bool fold_constants(Module& module);

}  // namespace hlsgen
