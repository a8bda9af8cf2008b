// The comment that stands behind a member in its header, so that the printed port carries it too.
//
//     UInt<24> step = 0;  // u0.24, turns per clock      ->  "u0.24, turns per clock"
//
// Doc: docs/generator.md   Test: tests/generator/frontend/layout_test.cpp

#pragma once

#include <string>

#include "generator/netlist.hpp"

namespace hlsgen {

// Empty when there is none, or when the file cannot be read.
std::string comment_at(const SourceLine& line);

}  // namespace hlsgen
