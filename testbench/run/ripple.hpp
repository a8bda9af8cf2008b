// How far the rotor's true speed swings in a span, for a mean says nothing of it.
//
// Doc: docs/report.md   Test: tests/testbench/summary_test.cpp
#pragma once

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "testbench/run/units.hpp"

namespace steplock {

struct Ripple {
  double least_rpm = 0, greatest_rpm = 0;
  double rms_rpm = 0;  // about the mean
};

// Over the samples of either drive from `from` to `to`; zeros if there are none.
template <class Sample>
Ripple ripple(const std::vector<Sample>& samples, double from, double to) {
  Ripple r;
  double sum = 0, squares = 0, n = 0;
  for (const Sample& s : samples) {
    if (s.time < from || s.time > to) continue;
    const double now = rpm(s.plant.speed);
    r.least_rpm = n == 0 ? now : std::min(r.least_rpm, now);
    r.greatest_rpm = n == 0 ? now : std::max(r.greatest_rpm, now);
    sum += now, squares += now * now, ++n;
  }
  if (n > 0) r.rms_rpm = std::sqrt(std::max(0.0, squares / n - sum / n * sum / n));
  return r;
}

void to_json(nlohmann::ordered_json& summary, const Ripple&);  // three keys more
std::string to_text(const Ripple&);

}  // namespace steplock
