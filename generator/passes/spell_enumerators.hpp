// Choices between enumerators, found again where LLVM packed them into fewer bits.
//
//     state = zext(c ? 2'd3 : 2'd1)    =>  c ? 3'd3 : 3'd1      printed as c ? State_kA : State_kB
//     state = zext(c), sext(c)         =>  c ? 3'd1 : 3'd0, c ? 3'd7 : 3'd0
//
// Only where the value is known to be of an enumeration, and as large as before once synthesized.
//
// Test: tests/generator/backend_pass_test.cpp

#pragma once

#include "generator/netlist.hpp"

namespace hlsgen {

bool spell_enumerators(Module& module);

}  // namespace hlsgen
