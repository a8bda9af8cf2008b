#include "testbench/compare/speed_shadow.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/design/sinusoidal/config.hpp"
#include "model/design/sinusoidal/design.hpp"

namespace steplock::sinusoidal {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
const double kRoot = std::sqrt(1.5);  // a power-invariant current over a phase's peak

}  // namespace

SpeedShadow::SpeedShadow(const design::Settings& s, const design::sinusoidal::Parameters& p)
    : p_(p.speed),
      period_(p.pwm.period),
      filter_(-std::expm1(-p.speed.filter * p.pwm.period)),
      target_(p.speed.target),
      rpm_(design::sinusoidal::rpm_of(s, 1)) {
  for (double* x : {&p_.kp, &p_.ki, &p_.limit}) *x /= kRoot;
  place_speed_ = std::ldexp(kTurn / 16 * s.control.pwm_hz, -15);
  place_current_ = std::ldexp(design::sinusoidal::current_range(s), -15);
  const auto q = design::sinusoidal::quantise(s);
  k_p_ = rounded(q.rows, "speed.k_p"), k_i_ = rounded(q.rows, "speed.k_i"), filter_error_ = rounded(q.rows, "speed.filter");
}

void SpeedShadow::take(const SinusoidalTop::Out& shown, double step, int way, bool span) {
  const double behind = way * step * kTurn / period_ - speed_;
  speed_ += filter_ * behind;
  const double error = target_ - speed_, current = way * place_current_ * static_cast<double>(shown.wanted.raw());
  // The reference shows in places, cut: from near on it has two and a half of them to go at most.
  const bool near = std::abs(place_speed_ * static_cast<double>(shown.reference.raw()) - target_) < 1.5 * place_speed_;
  arrived_s_ = near ? arrived_s_ + period_ : 0;
  if (!span || arrived_s_ * p_.slew < 3 * place_speed_) {
    begun_ = false;
    return;
  }
  behind_ = std::max(behind_, std::abs(behind));
  speeds_.add(rpm_ * (place_speed_ * way * static_cast<double>(shown.speed.raw()) - speed_));
  const double moved = p_.ki * period_ * error;
  if (!begun_) {
    begun_ = true;
    integral_ = std::clamp(current - p_.kp * error + moved, -p_.limit, p_.limit);
    return;
  }
  const double wanted = p_.kp * error + integral_;
  currents_.add(current - std::clamp(wanted, -p_.limit, p_.limit));
  by_k_p_ = std::max(by_k_p_, std::abs(p_.kp * error)), by_k_i_ = std::max(by_k_i_, std::abs(integral_));
  const bool winds_up = std::abs(wanted) > p_.limit && (wanted > 0) == (error > 0);
  if (!winds_up) integral_ = std::clamp(integral_ + moved, -p_.limit, p_.limit);
}

Rounding SpeedShadow::speed_error() const {
  return {rpm_ * (place_speed_ * (0.5 + std::ldexp(1, -12) / filter_) + filter_error_ * behind_), rpm_ * kUniform * place_speed_};
}

Rounding SpeedShadow::current_error() const {
  return {2 * place_current_ + k_p_ * by_k_p_ + k_i_ * by_k_i_ + p_.kp * filter_error_ * behind_,
          std::hypot(kUniform * std::sqrt(2) * place_current_, p_.kp * kUniform * place_speed_ / 16)};
}

}  // namespace steplock::sinusoidal
