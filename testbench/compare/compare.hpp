// Holds the three forms of a drive against each other on the scenario of a drive file.
//
//   1  rtl = fixed: both on the same pins, every output on every clock
//   2  fixed against float, on the same pins, beside the error budget (shadow.hpp, estimator_shadow.hpp)
//   3  fixed against float, each with a motor of its own: what a user of either would measure
//
// Doc: docs/report.md   Test: tests/testbench/compare_test.cpp, sinusoidal_compare_test.cpp
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "model/design/parameters.hpp"
#include "model/design/sinusoidal/parameters.hpp"
#include "testbench/engine/lockstep.hpp"
#include "testbench/run/float_errors.hpp"

namespace steplock {

// What both engines came to, each with a motor of its own.
struct OwnFigure {
  const char* name;
  const char* unit;
  double fixed = 0, floating = 0;
};

struct Comparison {
  Lockstep lockstep;               // 1
  FloatErrors shadow;              // 2
  std::vector<OwnFigure> own;      // 3
  bool interrupted = false;        // what was not reached is empty
  bool passed() const;
};

struct CompareOptions {
  double angle_deg = 0;
  bool lockstep = true;  // false leaves out the first part, the long one
  std::function<bool(const char* what, double done)> progress = {};

  // Negative controls: in these clocks the RTL sees its comparators inverted, or is asked for an output with one wrong bit;
  // the shadowing reference has other parameters than the design's.
  std::uint64_t wrong_from_clock = ~std::uint64_t{0}, wrong_to_clock = ~std::uint64_t{0};
  std::uint64_t spoilt_clock = ~std::uint64_t{0};
  std::optional<design::Parameters> reference = {};                         // of a six-step drive
  std::optional<design::sinusoidal::Parameters> sinusoidal_reference = {};  // of a sinusoidal one
};

Comparison compare_engines(const design::Settings&, const CompareOptions&);
nlohmann::ordered_json to_json(const Comparison&);
std::string to_text(const Comparison&);

}  // namespace steplock
