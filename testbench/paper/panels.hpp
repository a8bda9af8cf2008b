// Curves over a fine span of a run, in milliseconds from its first sample.
#pragma once

#include <string>
#include <vector>

#include "testbench/report/figure.hpp"
#include "testbench/drive/six_step/record.hpp"

namespace steplock {

template <class F>
Curve curve_of(const std::vector<Sample>& samples, std::string title, const char* color, F&& value,
               std::size_t most = 1200) {
  std::vector<Point> points;
  points.reserve(samples.size());
  for (const Sample& s : samples) {
    points.push_back({1e3 * (s.time - samples.front().time), value(s)});
  }
  return {std::move(title), color, outlined(points, most), 1.1};
}

inline Curve phase_current(const std::vector<Sample>& samples, int phase, std::string title,
                           const char* color) {
  const auto k = static_cast<std::size_t>(phase);
  return curve_of(samples, std::move(title), color,
                  [k](const Sample& s) { return s.plant.current[k]; });
}

}  // namespace steplock
