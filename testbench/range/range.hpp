// How fast and how well: the drive on a rotor that turns as told (ideal comparators, no motor), from
// slow to beyond a million electrical revolutions per minute, for several settings of clock, filter,
// blanking and PWM.
//
// Doc: docs/range.md (printed)   Test: tests/testbench/range_test.cpp
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "model/design/settings.hpp"
#include "testbench/report/figure.hpp"

namespace steplock {

struct RangeSettings {
  std::string name;
  double clock_hz = 48e6, pwm_hz = 30e3;
  double blanking_s = 4e-6, sample_every_s = 2e-6;
  int samples = 4;
};

struct RangePoint {
  double erpm = 0;
  bool locked = false;        // every commutation of the measured span was there, in order
  double mean_deg = 0;        // electrical, of the commutations against the ideal; late is positive
  double worst_deg = 0;       // greatest deviation from the ideal
};

struct RangeCurve {
  RangeSettings settings;
  std::vector<RangePoint> points;
  double cap_erpm() const;    // up to here all is locked; 0 if nothing is
};

// One point.  `drive` lends all that RangeSettings do not name.
RangePoint measure_point(const design::Settings& drive, const RangeSettings&, double erpm);

struct Range {
  std::vector<RangeCurve> curves;
};
// From `least_erpm` on.
Range measure_range(const design::Settings& drive, double least_erpm = 0,
                    const std::function<bool(double done)>& progress = {});

Figure range_figure(const Range&);
std::string range_page(const Range&);  // Markdown

}  // namespace steplock
