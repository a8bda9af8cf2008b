// The samples of a recorded run between two times, of either drive.
//
// Test: tests/testbench/summary_test.cpp, profile_test.cpp
#pragma once

#include <algorithm>
#include <vector>

#include "testbench/run/units.hpp"

namespace steplock {

template <class Sample>
struct Span {
  const Sample* first = nullptr;
  const Sample* last = nullptr;
  explicit operator bool() const { return first != nullptr && last > first; }
  double length() const { return last->time - first->time; }
  // The angle turned, over the time.
  double mean_rpm() const { return rpm((last->plant.angle - first->plant.angle) / length()); }
};

// Those that span [from, to], at least two of them, or nothing.
template <class Sample>
Span<Sample> span(const std::vector<Sample>& samples, double from, double to) {
  const auto first = std::ranges::lower_bound(samples, from, {}, &Sample::time);
  const auto end = std::ranges::upper_bound(samples, to, {}, &Sample::time);
  if (end - first < 2) return {};
  return {&*first, &*(end - 1)};
}

}  // namespace steplock
