// Current-model estimator, Eqs. (12)-(20).
//
//     i_M^{n+1}     = i^n + (T / L) (v - R i - e_c [0; 1])     (14)-(15), the model's current
//     Delta i       = i^{n+1} - i_M^{n+1} = (T / L) [e d theta; -(e - e_c)]       (16)
//     e_c^{n+1}     = e_c^n - K_e Delta i_delta                                   (18)
//     theta_c^{n+1} = theta_c^n + e_c^{n+1} T / K_E + sign(speed) K_theta Delta i_gamma   (19)
//     theta_c'      = (theta_c^{n+1} - theta_c^n) / T                             (20)
//
// In (20) the paper prints a factor T too many, in (19) it leaves out the sign of the speed, which e
// has in (16).  The frame turns between two samples, so the model runs in the stationary frame (the
// cross terms L theta_c' of (14) are that turning) with the EMF along delta at the middle of the
// interval; R takes the mean of both ends.
//
// Doc: docs/sinusoidal.md   Test: tests/model/reference/sinusoidal/sinusoidal_estimators_test.cpp
#pragma once

#include "model/reference/sinusoidal/voltage_model.hpp"

namespace steplock::reference::sinusoidal {

class CurrentModelEstimator {
 public:
  CurrentModelEstimator(const design::sinusoidal::Motor& motor,
                        const design::sinusoidal::CurrentModel& p, double period)
      : motor_(motor), p_(p), period_(period) {}

  void start(double angle, double speed) {
    emf_ = motor_.k_e * speed;
    way_.start(speed);
    now_ = {.angle = angle, .speed = speed, .emf = emf_};
    previous_ = angle - speed * period_;
  }

  void set_edge(double speed) { way_.set_edge(speed); }

  const Estimate& update(const Interval& interval) {
    now_.angle = wrapped(previous_ + now_.speed * period_);
    const double middle = previous_ + 0.5 * now_.speed * period_;
    const Vector model_emf = from_frame(middle, {0, emf_});
    const double gain = period_ / motor_.inductance_q;
    const Vector mean = 0.5 * (interval.before + interval.current);
    const Vector model =
        interval.before + gain * (interval.voltage - motor_.resistance * mean - model_emf);
    const Vector error = seen_from(middle, interval.current - model);

    emf_ -= p_.k_e * error.y;
    const double step = way_.believed(emf_ / motor_.k_e) * period_ + way_.sign() * p_.k_theta * error.x;
    previous_ = now_.angle;
    now_.speed = step / period_;
    way_.update(now_.speed);
    now_.emf = emf_;
    now_.error = error.x / gain;
    return now_;
  }
  const Estimate& estimate() const { return now_; }

 private:
  design::sinusoidal::Motor motor_;
  design::sinusoidal::CurrentModel p_;
  double period_, previous_ = 0, emf_ = 0;
  Estimate now_;
  Way way_;
};

}  // namespace steplock::reference::sinusoidal
