// One node per value.
//
//     p = a + b, q = b + a     =>  q = p
//
// Test: tests/generator/backend_pass_test.cpp

#pragma once

#include "generator/netlist.hpp"

namespace hlsgen {

bool share_common(Module& module);

}  // namespace hlsgen
