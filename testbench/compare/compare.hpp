// Holds the three forms of the drive against each other on the scenario of a drive file.
//
//   1  rtl = fixed: both on the same pins, every output on every clock
//   2  fixed against float, on the same pins, beside the error budget (shadow.hpp)
//   3  fixed against float, each with a motor of its own: what a user of either would measure
//
// Doc: docs/report.md   Test: tests/testbench/compare_test.cpp
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "model/design/parameters.hpp"
#include "testbench/run/summary.hpp"

namespace steplock {

struct Comparison {
  Lockstep lockstep;         // 1
  FloatErrors shadow;        // 2
  Summary fixed, floating;   // 3
  bool interrupted = false;  // what was not reached is empty
  bool passed() const;
};

struct CompareOptions {
  double angle_deg = 0;
  bool lockstep = true;  // false leaves out the first part, the long one
  std::function<bool(const char* what, double done)> progress = {};

  // Negative controls: in these clocks the RTL sees its comparators inverted; the shadowing reference
  // has other parameters than the design's.
  std::uint64_t wrong_from_clock = ~std::uint64_t{0}, wrong_to_clock = ~std::uint64_t{0};
  std::optional<design::Parameters> reference = {};
};

Comparison compare_engines(const design::Settings&, const CompareOptions&);
nlohmann::ordered_json to_json(const Comparison&);
std::string to_text(const Comparison&);

}  // namespace steplock
