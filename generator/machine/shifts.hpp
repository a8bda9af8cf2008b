// Shifts by a variable become choices between shifts by constants, which the datapath has.
//
// Test: tests/generator/machine_test.cpp

#pragma once

#include "generator/netlist.hpp"

namespace hlsgen::machine {

void expand_shifts(Module& sample);

}  // namespace hlsgen::machine
