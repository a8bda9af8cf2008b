// Where the power goes in a span: from the source to the load, and into heat on the way.
//
//     input = copper + switches + bus_resistance + friction + load + what is stored (rotor, windings, capacitor)
//
// Differences of the plant's running energies (model/plant/plant.hpp), so that no sample between them matters.  Iron losses are
// no part of the plant.
//
// Doc: docs/report.md   Test: tests/testbench/summary_test.cpp, run_drive_test.cpp
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "model/plant/plant.hpp"
#include "testbench/run/span.hpp"

namespace steplock {

// All in W, means over the span; zeros if it has no two samples.
struct Power {
  double from_s = 0, to_s = 0;
  double input = 0, copper = 0, switches = 0, bus_resistance = 0, friction = 0, load = 0, stored = 0;
  // Of the input, what the load gets; 0 where nothing comes in.
  double efficiency() const { return input > 0 ? load / input : 0; }
};

Power power_between(double from_s, const plant::Energy& from, double to_s, const plant::Energy& to);

// Over the samples of either drive from `from` to `to`.
template <class Sample>
Power power(const std::vector<Sample>& samples, double from, double to) {
  const Span<Sample> p = span(samples, from, to);
  return p ? power_between(p.first->time, p.first->plant.energy, p.last->time, p.last->plant.energy) : Power{};
}

nlohmann::ordered_json to_json(const Power&);
std::string to_text(const Power&);

}  // namespace steplock
