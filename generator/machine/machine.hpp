// A sample as a program on one datapath: the flat netlist of a tick in, an ordinary module and its
// memories out.
//
//     expand_shifts -> lower -> fuse -> legalise -> order -> build
//
// Test: tests/generator/machine_test.cpp

#pragma once

#include "generator/schedule/schedule.hpp"

namespace hlsgen::machine {

Scheduled schedule(Module sample, const Budget& budget, const scheduling::Frame& frame);

}  // namespace hlsgen::machine
