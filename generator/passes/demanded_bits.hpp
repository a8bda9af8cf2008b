// Which bits of every value can change an output, a register or an instance.
//
// Test: tests/generator/backend_pass_test.cpp

#pragma once

#include "generator/netlist.hpp"
#include "generator/passes/known_bits.hpp"

#include <vector>

namespace hlsgen {

std::vector<llvm::APInt> demanded_bits(const Module& module, const std::vector<Known>& known);

}  // namespace hlsgen
