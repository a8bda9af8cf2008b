// Wires that only one branch of the always_ff reads, moved into it.
//
//     wire [7:0] sum = a + b;                 if (start) begin
//     always_ff ... if (start) begin    ->      logic [7:0] sum;
//       x <= sum; y <= sum ^ x;                 sum = a + b;
//                                               x <= sum; y <= sum ^ x;
//
// Arms of a case that read the same wires, and are not all of its arms, become a case of their own
// inside of an arm that holds the wires.
//
// Test: tests/generator/clocked_print_test.cpp

#pragma once

#include "generator/print/decide.hpp"
#include "generator/print/plan.hpp"

namespace hlsgen {

// Fills Branch::wires, in order; what stays out is the module's.
void place_wires(const Module& module, const Plan& plan, Branch& root);

}  // namespace hlsgen
