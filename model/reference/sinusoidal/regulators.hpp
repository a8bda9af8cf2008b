// The PI regulators: currents on the gamma-delta model, and speed.
//
//     v_gamma = PI(i_gamma* - i_gamma) - theta_c' L_q i_delta
//     v_delta = PI(i_delta* - i_delta) + theta_c' (L_d i_gamma + K_E)
//     i_delta* = PI(reference - speed), within +-limit, from 0 to limit until the lock; the reference moves by at most slew, the
//                integral begins at the start's current
//
// A voltage beyond the limit is shortened along its direction, and the integrals then take what was
// left of it (back-calculation), so neither winds up.
//
// Doc: docs/sinusoidal.md   Test: tests/model/reference/sinusoidal/sinusoidal_regulators_test.cpp
#pragma once

#include <algorithm>

#include "model/design/sinusoidal/parameters.hpp"
#include "model/reference/sinusoidal/vector.hpp"

namespace steplock::reference::sinusoidal {

class CurrentRegulator {
 public:
  CurrentRegulator(const design::sinusoidal::Motor& motor,
                   const design::sinusoidal::CurrentRegulator& p, double period)
      : motor_(motor), p_(p), period_(period) {}

  void reset() { integral_ = {}, saturated_ = false; }

  // Both in the gamma-delta frame; `most` is the longest voltage vector.
  Vector update(Vector wanted, Vector current, double speed, double most) {
    const Vector error = wanted - current;
    const Vector known = {-speed * motor_.inductance_q * current.y,
                          speed * (motor_.inductance_d * current.x + motor_.k_e)};
    const Vector proportional = {p_.kp_gamma * error.x, p_.kp_delta * error.y};
    Vector v = known + proportional + integral_;
    const double length = v.length();
    saturated_ = length > most;
    if (saturated_) {
      const Vector shorter = (most / length) * v;
      // The integral that would have given just this, approached as fast as it may move anyway.
      const Vector excess = shorter - v;
      integral_ = integral_ + Vector{p_.ki_gamma / p_.kp_gamma * period_ * excess.x,
                                     p_.ki_delta / p_.kp_delta * period_ * excess.y};
      v = shorter;
    }
    integral_ = integral_ +
                Vector{p_.ki_gamma * period_ * error.x, p_.ki_delta * period_ * error.y};
    return v;
  }
  bool saturated() const { return saturated_; }

 private:
  design::sinusoidal::Motor motor_;
  design::sinusoidal::CurrentRegulator p_;
  double period_;
  Vector integral_;
  bool saturated_ = false;
};

class SpeedRegulator {
 public:
  SpeedRegulator(const design::sinusoidal::SpeedRegulator& p, double period)
      : p_(p), period_(period) {}

  // `way` is the wanted direction, 1 or -1.
  void start(double speed, int way = 1) {
    way_ = way, reference_ = speed_ = speed, integral_ = way * p_.start_current, saturated_ = false;
  }

  double update(double target, double speed, bool locked = true) {
    const double move = p_.slew * period_;
    reference_ += std::clamp(target - reference_, -move, move);
    speed_ += -std::expm1(-p_.filter * period_) * (speed - speed_);
    const double error = reference_ - speed_;
    const double wanted = p_.kp * error + integral_;
    const double least = locked || way_ < 0 ? -p_.limit : 0, most = locked || way_ > 0 ? p_.limit : 0;
    const double current = std::clamp(wanted, least, most);
    saturated_ = wanted != current && current != 0;
    const bool winds_up = wanted != current && (wanted > 0) == (error > 0);
    if (!winds_up) integral_ = std::clamp(integral_ + p_.ki * period_ * error, least, most);
    return current;
  }
  bool saturated() const { return saturated_; }
  double reference() const { return reference_; }
  double speed() const { return speed_; }  // smoothed

 private:
  design::sinusoidal::SpeedRegulator p_;
  double period_, reference_ = 0, speed_ = 0, integral_ = 0;
  int way_ = 1;
  bool saturated_ = false;
};

}  // namespace steplock::reference::sinusoidal
