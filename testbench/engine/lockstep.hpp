// What holding the RTL against its blocks found.
//
// Test: tests/testbench/compare_test.cpp
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

namespace steplock {

struct Lockstep {
  std::uint64_t clocks = 0, differing_clocks = 0;
  std::uint64_t first_clock = 0;  // of the differing ones
  std::string first_port;
  bool equal() const { return differing_clocks == 0; }
};

std::string to_text(const Lockstep&);  // one line
nlohmann::ordered_json to_json(const Lockstep&);

}  // namespace steplock
