#include "testbench/drive/six_step/judge.hpp"

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
  constexpr double kStepDeg = 60;
  const double theta = electrical_rad * 180 / std::numbers::pi;
  const int k = reverse ? (to + 3) % 6 : to;
  const double late = reverse ? 90 + kStepDeg * k - theta : theta - (30 + kStepDeg * k);
  const double error = late + advance_deg_;
  if (!following_ || reverse != reverse_) {
    following_ = true;
    confirmed_ = false;
    reverse_ = reverse;
    slot_ = 0;
    error_deg_ = std::remainder(error, 360);
    return;
  }
  if (!confirmed_) take();
  confirmed_ = true;
  // The representative nearest to the last error: one commutation cannot hide half a turn.
  error_deg_ += std::remainder(error - error_deg_, 360);
  take();
}

void Judge::take() {
  constexpr double kStepDeg = 60;
  const double astray = error_deg_ - kStepDeg * static_cast<double>(slot_);
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
