// What to change in the drive file after a run that failed, for either kind of drive: lines that name the key and a value.
//
// Doc: docs/report.md   Test: tests/testbench/advice_test.cpp
#pragma once

#include <string>
#include <vector>

#include "model/design/settings.hpp"
#include "testbench/run/units.hpp"

namespace steplock {

// Each is empty where it is not so.

// `gaining`: the speed at two times before the first disturbance, r/min in the wanted direction, while the drive was in lock.
struct Gaining {
  double from_s = 0, from_rpm = 0, to_s = 0, to_rpm = 0;
};
std::string ends_too_soon(const design::Settings&, const Gaining&);
std::string load_step_beyond(const design::Settings&);

// The last fifth of what was undisturbed.
template <class Sample>
Gaining gaining(const std::vector<Sample>& samples, double from_s, double to_s, double set_rpm) {
  Gaining g;
  for (const Sample& x : samples) {
    if (x.time > to_s) break;
    const double speed = rpm(x.plant.speed) * (set_rpm < 0 ? -1 : 1);
    if (x.time <= to_s - (to_s - from_s) / 5) g.from_s = x.time, g.from_rpm = speed;
    g.to_s = x.time, g.to_rpm = speed;
  }
  return g;
}

}  // namespace steplock
