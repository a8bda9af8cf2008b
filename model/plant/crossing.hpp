// Where a continuous function falls below zero.
//
// Doc: docs/plant.md   Test: tests/model/plant/crossing_test.cpp
#pragma once

#include <algorithm>

namespace steplock::plant {

// f(low) >= 0 > f(high), low < high.  Returns a point x in (low, high] with f(x) < 0 and a
// non-negative value of f at most `tolerance` before it.  False position of the Illinois kind,
// which closes in from both sides; where three rounds did not gain what bisection would, it bisects
// once.
template <typename F>
double falls_below_zero(const F& f, double low, double f_low, double high, double f_high,
                        double tolerance) {
  int side = 0;               // which end moved last: -1 low, +1 high
  double width = high - low;  // three rounds ago
  for (int round = 1; high - low > tolerance && round < 200; ++round) {
    double x = low + (high - low) * f_low / (f_low - f_high);
    if (round % 4 == 0) {
      if (high - low > width / 8) x = (low + high) / 2;
      width = high - low;
    }
    x = std::clamp(x, low + tolerance / 2, high - tolerance / 2);
    const double f_x = f(x);
    if (f_x < 0) {
      high = x;
      f_high = f_x;
      if (side > 0) f_low /= 2;
      side = 1;
    } else {
      low = x;
      f_low = f_x;
      if (side < 0) f_high /= 2;
      side = -1;
    }
  }
  return high;
}

}  // namespace steplock::plant
