// Choices.
//
//     c ? x : x                        =>  x
//     !c ? a : b, a != b ? x : y       =>  c ? b : a, a == b ? y : x
//     c ? 1 : 0, c ? 1 : x, c ? x : 0  =>  c, c | x, c & x            (one bit)
//     c ? (c ? a : b) : d              =>  c ? a : d                  also through & | !
//     c ? (d ? a : b) : b              =>  (c & d) ? a : b
//     c ? a : (d ? a : b)              =>  (c | d) ? a : b
//     (c | d) ? (c ? a : b) : e        =>  c ? a : (d ? b : e)
//     (c & d) ? a : (c ? b : e)        =>  c ? (d ? a : b) : e
//     x < 7 ? x : 7, 0 < x ? x : 0     =>  7 < x ? 7 : x, x < 0 ? 0 : x
//     c ? a + b : a + d                =>  a + (c ? b : d)            sums read once; also - * and compares
//
// Test: tests/generator/backend_pass_test.cpp

#pragma once

#include "generator/netlist.hpp"

namespace hlsgen {

bool simplify_muxes(Module& module);

}  // namespace hlsgen
