#include "testbench/run/judge.hpp"

#include <cmath>
#include <cstdlib>
#include <numbers>

namespace steplock {

void Judge::commutated(double electrical_rad, int from, int to) {
  const int moved = (to - from + 6) % 6;
  if (moved != 1 && moved != 5) {
    released();
    return;
  }
  const bool reverse = moved == 5;
  // A drive that catches a spinning rotor goes to its step from anywhere, then turns with it.
  if (reverse != reverse_) released();
  reverse_ = reverse;
  constexpr double kStepDeg = 60;
  const double theta = electrical_rad * 180 / std::numbers::pi;
  const int k = reverse ? (to + 3) % 6 : to;
  const double late = reverse ? 90 + kStepDeg * k - theta : theta - (30 + kStepDeg * k);
  const double error = late + advance_deg_;
  // The representative nearest to the last error: one commutation cannot hide half a turn.
  const double near = following_ ? error_deg_ : 0;
  error_deg_ = near + std::remainder(error - near, 360);

  const double astray = error_deg_ - kStepDeg * static_cast<double>(following_ ? slot_ : 0);
  if (!following_) slot_ = 0;
  following_ = true;
  if (std::abs(astray) > kStepDeg) {
    const long slipped = std::lround(astray / kStepDeg);
    slot_ += slipped;
    step_outs_ += static_cast<std::uint64_t>(std::labs(slipped));
  }
  ++count_;
  sum_ += error_deg_;
  squares_ += error_deg_ * error_deg_;
}

}  // namespace steplock
