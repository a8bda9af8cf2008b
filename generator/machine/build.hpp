// The datapath and its program as an ordinary module with memories as instances.
//
//     step                    0: waiting; the program's address
//     <block>_program         what every clock does
//     <block>_numbers         one copy for each operand, all written alike
//     product, sum, result    as in machine/order
//     outputs                 gathered while the program runs, shown together with done
//
// A register's cell stands beside one with its reset value, which is read until the first sample
// after a reset is done.
//
// Test: tests/generator/machine_test.cpp

#pragma once

#include "generator/machine/order.hpp"
#include "generator/machine/schedule.hpp"

namespace hlsgen::machine {

struct Built {
  std::vector<Module> memories;
  Module module;
};

Built build(const Program& program, const Order& order, const Frame& frame);

}  // namespace hlsgen::machine
