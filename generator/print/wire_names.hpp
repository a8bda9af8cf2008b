// Names for the values that become wires.
//
//     what a register takes at the next clock  ->  <register>_next
//     a C++ variable                           ->  its name
//     what an output shows                     ->  the output's name, if it is free
//     anything else                            ->  operator_line, as sum_42
//
// Test: tests/generator/backend_print_test.cpp

#pragma once

#include "generator/print/identifiers.hpp"
#include "generator/print/plan.hpp"

namespace hlsgen {

// One per node; empty where the node is no wire.
std::vector<std::string> wire_names(const Module& module, const Plan& plan, FixedNames& names);

}  // namespace hlsgen
