// What a drive makes of a profile of set speeds and loads ([scenario] set_speed_s, load_s): the true speed in the last half of each
// of its pieces.
//
// Doc: docs/report.md   Test: tests/testbench/profile_test.cpp
#pragma once

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "model/design/settings.hpp"
#include "testbench/run/ripple.hpp"
#include "testbench/run/span.hpp"
#include "testbench/run/timeline.hpp"
#include "testbench/run/units.hpp"

namespace steplock {

// A piece ends with the next moment of the scenario, whatever that is, or with the run.
struct Piece {
  double from_s = 0, to_s = 0;
  double set_rpm = 0, load_nm = 0;  // signed; beside load.opposing_nm
  double mean_rpm = 0;              // angle over time, of the last half
  Swing speed_rpm;                  // likewise
  bool locked = false;              // at its end
  double error_percent() const { return 100 * (mean_rpm - set_rpm) / std::abs(set_rpm); }
};

// Without what is measured, of those that begin within the run.
std::vector<Piece> pieces(const design::Settings&, double simulated_s);

// Samples of either drive, of the whole run.
template <class Sample>
std::vector<Piece> profile(const design::Settings& s, double simulated_s, const std::vector<Sample>& samples) {
  std::vector<Piece> all = pieces(s, simulated_s);
  for (Piece& p : all) {
    const Span<Sample> half = span(samples, (p.from_s + p.to_s) / 2, p.to_s);
    if (!half) continue;
    p.mean_rpm = half.mean_rpm();
    p.speed_rpm = swing(samples, [](const Sample& x) { return rpm(x.plant.speed); },
                        [&](const Sample& x) { return x.time >= half.first->time && x.time <= half.last->time; });
    p.locked = half.last->watch.locked();
  }
  return all;
}

nlohmann::ordered_json to_json(const Piece&);
std::string to_text(const Piece&);
// What is wrong with them, a line each: a lock that was lost.
std::vector<std::string> failures(const std::vector<Piece>&);

}  // namespace steplock
