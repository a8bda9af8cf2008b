// What no output and no instance depends on: nodes, registers, tables.
//
//     register r = r + 1, read by itself alone    =>  nothing
//
// Test: tests/generator/backend_pass_test.cpp

#pragma once

#include "generator/netlist.hpp"

namespace hlsgen {

bool remove_dead(Module& module);

}  // namespace hlsgen
