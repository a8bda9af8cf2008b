// Names for the values that become wires.
//
//     what a register takes at the next clock     ->  <register>_next
//     a C++ variable                              ->  its name
//     what an output shows                        ->  the output's name, if it is free
//     what a C++ function returned                ->  the function's name
//     made of what has such names                 ->  run_and_not_held (spoken_names.hpp)
//     one bit of a set                            ->  <what it is for>_rest
//     what is gathered by OR                      ->  <what it is for>_so_far
//     a choice                                    ->  <what it is for>_by_<what decides it>, as factor_by_stage
//     what a condition lets through to one reader ->  <what it is for>_if_<condition>, or _unless_
//     one of these, extended or cut               ->  wide_<its name>, <its name>_low, <its name>_top
//     an entry of a table                         ->  entry_of_<table>
//     what only one of these is made from         ->  <its name>_operator, as limit_sum
//     what such a function works with             ->  <function>_operator, as limit_sum
//     anything else                               ->  <the first name that it is made from>_operator
//
// Test: tests/generator/backend_print_test.cpp

#pragma once

#include "generator/print/identifiers.hpp"
#include "generator/print/plan.hpp"

#include <string>
#include <vector>

namespace hlsgen {

// One per node; empty where the node is no wire.
// `instance_outputs` are the names of what instances put out, by instance and port.
std::vector<std::string> wire_names(const Module& module, const Plan& plan, FixedNames& names,
                                    const std::vector<std::vector<std::string>>& instance_outputs);

}  // namespace hlsgen
