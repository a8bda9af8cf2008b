// Registers that never leave their reset value.
//
//     r = reset, r <= c ? r : reset    =>  reset
//
// Test: tests/generator/backend_pass_test.cpp

#pragma once

#include "generator/netlist.hpp"

namespace hlsgen {

bool constant_registers(Module& module);

}  // namespace hlsgen
