// How fast and how well, for several settings of clock and PWM:
//
//     six-step     on a rotor that turns as told (ideal comparators, no motor), from slow to beyond a million electrical revolutions
//                  per minute; also for several settings of filter and blanking
//     sinusoidal   with its motor, wound for the speed; the estimate against the rotor's true angle
//
// Doc: docs/range.md, docs/sinusoidal_range.md (printed)   Test: tests/testbench/range_test.cpp, tests/testbench/sinusoidal_range_test.cpp
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
  bool locked = false;        // over the whole span that was measured
  // Electrical: of the commutations against the ideal, late is positive; or of the true angle against the estimate.
  double mean_deg = 0;
  double worst_deg = 0;       // greatest deviation
};

struct RangeCurve {
  RangeSettings settings;
  std::vector<RangePoint> points;
  double cap_erpm() const;    // up to here all is locked; 0 if nothing is
};

// What is measured of one kind of drive, and what its page says of it.
struct RangePlan {
  std::string stem, title, command;  // of page and figure; the page's title; what prints it
  std::vector<RangeSettings> settings;
  std::vector<double> erpm;
  double shown_from = 0;             // slower ones stand in the figure alone
  // One point.  `drive` lends all that RangeSettings do not name.
  RangePoint (*measure)(const design::Settings& drive, const RangeSettings&, double erpm) = nullptr;
  std::string about, cell;           // Markdown: how it was measured; what a cell holds
  std::string figure, figure_title, caption;
};
RangePlan six_step_range();
RangePlan sinusoidal_range();

struct Range {
  std::vector<RangeCurve> curves;
};
// From `least_erpm` on.
Range measure_range(const RangePlan&, const design::Settings& drive, double least_erpm = 0,
                    const std::function<bool(double done)>& progress = {});

Figure range_figure(const RangePlan&, const Range&);
std::string range_page(const RangePlan&, const Range&);  // Markdown

}  // namespace steplock
