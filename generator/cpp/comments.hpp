// What a header says in comments, so that the printed module says it too.
//
//     UInt<24> step = 0;  // u0.24, turns per clock      ->  "u0.24, turns per clock", behind the port
//     // Oscillator: ...                                 ->  the contract, at the head of the module
//
// Doc: docs/generator.md   Test: tests/generator/frontend/layout_test.cpp

#pragma once

#include <string>
#include <vector>

#include "generator/netlist.hpp"

namespace hlsgen {

// Empty when there is none, or when the file cannot be read.
std::string comment_at(const SourceLine& line);

// The comment that the file begins with, without its slashes, line by line.
std::vector<std::string> contract_of(const std::string& file);

}  // namespace hlsgen
