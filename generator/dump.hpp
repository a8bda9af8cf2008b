// The netlist as text, one node a line, for people who debug the generator.
//
// Doc: docs/generator.md   Test: tests/generator/frontend/design_test.cpp

#pragma once

#include <string>

#include "generator/netlist.hpp"

namespace hlsgen {

std::string dump(const Design& design);

}  // namespace hlsgen
