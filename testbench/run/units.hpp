// The units people read, from the units physics uses.
#pragma once

#include <numbers>

namespace steplock {

constexpr double degrees(double rad) { return rad * 180 / std::numbers::pi; }
constexpr double rpm(double rad_per_s) { return rad_per_s * 30 / std::numbers::pi; }
// Mechanical speed of a commutation rate: six steps to an electrical turn.
constexpr double rpm_of_steps(double steps_per_second, int pole_pairs) {
  return steps_per_second * 10 / pole_pairs;
}

}  // namespace steplock
