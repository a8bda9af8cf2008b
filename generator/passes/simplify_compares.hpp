// Comparisons.
//
//     !(a == b), !(a < b)             =>  a != b, b <= a
//     x == 1, x == 0                  =>  x, !x                      (one bit)
//     x < 0, -1 < x, signed           =>  the sign, its inverse
//     x < 1, 0 < x, x <= max          =>  x == 0, x != 0, 1
//     x <= 7, 7 <= x                  =>  x < 8, 6 < x               one form for constants
//     x < 8, 7 < x                    =>  x[15:3] == 0, x[15:3] != 0
//     x < 40, 39 < x                  =>  x[15:3] < 5, 4 < x[15:3]   beyond four bits, as the next
//     x < 8, x < -8, signed           =>  sign || x[14:3] == 0, sign && x[14:3] != all ones
//     x < -2, -3 < x, three bits      =>  sign && x[1:0] < 2, !sign || 1 < x[1:0]    Yosys maps the left ones wrongly
//     a - b == 0, a ^ b == 0          =>  a == b
//     x + 3 == 7                      =>  x == 4
//     {a, b} == 4'b0110               =>  a == 2'b01 && b == 2'b10   where one side is a constant
//     (c ? 3 : 5) == 3                =>  c
//
// Test: tests/generator/backend_pass_test.cpp

#pragma once

#include "generator/netlist.hpp"

namespace hlsgen {

bool simplify_compares(Module& module);

}  // namespace hlsgen
