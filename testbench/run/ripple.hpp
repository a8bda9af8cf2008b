// How far the rotor's true speed and the motor's torque swing in a span, for a mean says nothing of it.
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

// Of a quantity that is sampled at equal times; zeros if it never was.
struct Swing {
  double least = 0, greatest = 0, mean = 0;
  double rms = 0;  // about the mean
};

// Of value(sample), over the samples of either drive that take part.
template <class Sample, class Value, class Takes>
Swing swing(const std::vector<Sample>& samples, Value&& value, Takes&& takes) {
  Swing w;
  double sum = 0, squares = 0, n = 0;
  for (const Sample& s : samples) {
    if (!takes(s)) continue;
    const double now = value(s);
    w.least = n == 0 ? now : std::min(w.least, now);
    w.greatest = n == 0 ? now : std::max(w.greatest, now);
    sum += now, squares += now * now, ++n;
  }
  if (n > 0) w.mean = sum / n, w.rms = std::sqrt(std::max(0.0, squares / n - w.mean * w.mean));
  return w;
}

struct Ripple {
  Swing speed_rpm;  // the rotor's
  Swing torque_nm;  // electromagnetic, all phases
};

// Speed over the samples from `from` to `to`; torque over `fine` ones, which see the PWM: two electrical turns.
template <class Sample>
Ripple ripple(const std::vector<Sample>& samples, double from, double to, const std::vector<Sample>& fine) {
  return {.speed_rpm = swing(samples, [](const Sample& s) { return rpm(s.plant.speed); },
                             [&](const Sample& s) { return s.time >= from && s.time <= to; }),
          .torque_nm = swing(fine, [](const Sample& s) { return s.plant.torque; }, [](const Sample&) { return true; })};
}

void to_json(nlohmann::ordered_json& summary, const Ripple&);  // seven keys more
std::string speed_text(const Ripple&);
std::string torque_text(const Ripple&);

}  // namespace steplock
