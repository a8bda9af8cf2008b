// The netlist of a sample as a program, one instruction for each thing that a clock can do.
//
//     a + b, -, comparisons, choices, products by one multiplier (machine/integers), shifts by constants, cuts to fewer
//     bits, entries of tables; `and`, `or`, `xor` of bits as sums: (a + b) >> 1, (a + b + 1) >> 1,
//     the last bit of a + b
//     a choice between a number and two ends becomes a clamp (machine/clamps)
//
// Test: tests/generator/machine_test.cpp

#pragma once

#include "generator/machine/program.hpp"

namespace hlsgen::machine {

// `sample` has to outlive the program; shifts are by constants.
Program lower(const Module& sample, unsigned factor, unsigned second_factor);

}  // namespace hlsgen::machine
