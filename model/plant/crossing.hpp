// Where a continuous function falls below zero.
//
// Doc: docs/plant.md   Test: tests/model/plant/crossing_test.cpp
#pragma once

#include <algorithm>

namespace steplock::plant {

// f(low) >= 0 > f(high), low < high.  Returns a point x in (low, high] with f(x) < 0 and a
// non-negative value of f at most `tolerance` before it.  False position of the Illinois kind, every
// third step a bisection, so that no shape of f makes it crawl.
template <typename F>
double falls_below_zero(const F& f, double low, double f_low, double high, double f_high,
                        double tolerance) {
  for (int round = 1; high - low > tolerance && round < 100; ++round) {
    double x = (low + high) / 2;
    if (round % 3 != 0) {
      const double guess = low + (high - low) * f_low / (f_low - f_high);
      x = std::clamp(guess, low + tolerance / 2, high - tolerance / 2);
    }
    const double f_x = f(x);
    if (f_x < 0) {
      high = x;
      f_high = f_x;
      f_low /= 2;
    } else {
      low = x;
      f_low = f_x;
      f_high /= 2;
    }
  }
  return high;
}

}  // namespace steplock::plant
