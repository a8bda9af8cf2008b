// Fewer instructions: what one clock of the datapath can do together becomes one.
//
//     p = c d;  s = p + 4;  r = s >> 3, clamped     ->  r = (c d + 4) >> 3, clamped
//     x - 0 == 0                                    ->  x == 0
//
// And the form that the datapath has: an input only as b or d, an address of the table an
// instruction of its own.
//
// Test: tests/generator/machine_test.cpp

#pragma once

#include "generator/machine/program.hpp"

namespace hlsgen::machine {

void fuse(Program& program);
void legalise(Program& program);

}  // namespace hlsgen::machine
