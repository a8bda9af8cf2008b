// What has a bit for each value of an enumeration: such ports and registers, and the values that go there bit by bit.
//
// Test: tests/generator/backend_print_test.cpp

#pragma once

#include "generator/netlist.hpp"

#include <vector>

namespace hlsgen {

// Per node the enumeration whose values its bits stand for, of Module::enumerations, or -1.
std::vector<int> sets_of(const Module& module);

}  // namespace hlsgen
