// The value of an operator over constants, by the definitions in netlist.hpp.
//
// Test: tests/generator/backend_pass_test.cpp

#pragma once

#include "generator/netlist.hpp"

#include <vector>

namespace hlsgen {

// Not for sources.  `in` are the values of n.in.
llvm::APInt evaluate(const Module& module, const Node& n, const std::vector<llvm::APInt>& in);

}  // namespace hlsgen
