// Holds the three forms of the drive against each other on the scenario of a drive file.
//
//   1  rtl = fixed: both on the same pins, every output on every clock
//   2  fixed against float, on the same pins: the blocks drive the motor, the reference looks over their
//      shoulder; at each commutation of the steady span both are paired by instant, and the differences
//      stand beside the error budget that the design library prints (model/design/budget.hpp)
//   3  fixed against float, each with a motor of its own: what a user of either would measure
//
// Doc: docs/report.md   Test: tests/testbench/compare_test.cpp
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "testbench/run/summary.hpp"

namespace steplock {

struct Lockstep {
  std::uint64_t clocks = 0, differing_clocks = 0;
  std::uint64_t first_clock = 0;  // of the differing ones
  std::string first_port;
  bool equal() const { return differing_clocks == 0; }
};

struct SignalError {
  std::string name, unit;
  double mean = 0, rms = 0, greatest = 0;            // measured
  std::optional<double> budget_rms, budget_bound;    // allowed
  bool within() const { return !budget_bound || greatest <= *budget_bound; }
};

struct Comparison {
  Lockstep lockstep;
  std::size_t paired = 0;              // commutations
  std::vector<SignalError> shadow;     // 2
  Summary fixed, floating;             // 3
  bool passed() const;
};

struct CompareOptions {
  double angle_deg = 0;
  bool lockstep = true;  // false leaves out the first part, the long one
  std::uint64_t flip_at_clock = ~std::uint64_t{0};  // a negative control: corrupts one pin of the RTL
  std::function<bool(const char* what, double done)> progress = {};
};

Comparison compare_engines(const design::Settings&, const CompareOptions&);
nlohmann::ordered_json to_json(const Comparison&);
std::string to_text(const Comparison&);

}  // namespace steplock
