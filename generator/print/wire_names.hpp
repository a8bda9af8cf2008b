// Names for the values that become wires.
//
//     what a register takes at the next clock     ->  <register>_next
//     a C++ variable                              ->  its name
//     what an output shows                        ->  the output's name, if it is free
//     what a C++ function returned                ->  the function's name
//     one of these, extended or inverted          ->  <its name>_wide, <its name>_inverse
//     what only one of these is made from         ->  <its name>_operator, as limit_choice
//     what such a function works with             ->  <function>_operator, as limit_sum
//     anything else                               ->  <the first name that it is made from>_operator
//
// Test: tests/generator/backend_print_test.cpp

#pragma once

#include "generator/print/identifiers.hpp"
#include "generator/print/plan.hpp"

namespace hlsgen {

// One per node; empty where the node is no wire.
std::vector<std::string> wire_names(const Module& module, const Plan& plan, FixedNames& names);

}  // namespace hlsgen
