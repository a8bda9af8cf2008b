// Voltage-model estimator, Eqs. (6)-(11).
//
//     e           = v - (R + p L) i                      the voltage that no known part takes
//     theta_e'    = e_delta / K_E                        (7), averaged over the last samples
//     Delta v_gam = e_gamma = -theta' K_E sin(d theta)   (8)-(9)
//     n_W         = -sign(theta_c') (K_SP Delta v_gam + K_SI integral of Delta v_gam)
//     theta_c'    = theta_e' + n_W                       (11)
//
// The difference of two samples stands for p i.  e is formed in the stationary frame and turned into
// gamma-delta at the middle of the interval between the samples, where its mean belongs: there Eq. (7)'s
// L i_gamma theta' and Eq. (8)'s L i_delta theta' are the turning of the frame itself.  A salient
// motor is taken with L = L_q, whose remainder stands on delta alone: (L_d - L_q) i_gamma theta'
// joins K_E.
//
// Doc: docs/sinusoidal.md   Test: tests/model/reference/sinusoidal/sinusoidal_estimators_test.cpp
#pragma once

#include <vector>

#include "model/design/sinusoidal/parameters.hpp"
#include "model/reference/sinusoidal/vector.hpp"

namespace steplock::reference::sinusoidal {

// What one sampling interval showed, in the stationary frame.
struct Interval {
  Vector voltage;          // V, mean of what was applied
  Vector before, current;  // A, at its two ends
};

// The sign of the speed theta_c', smoothed over 32 samples.  It is not the sign of the EMF on delta:
// with that, an estimate 127 degrees astray (at a gain of 2) sees an EMF of the other sign and holds
// its place, as steady as the right one.
class Way {
 public:
  void start(double speed) { smooth_ = speed, against_ = false; }
  void update(double speed) {
    smooth_ += (speed - smooth_) / 32;
    against_ = edge_ != 0 && sign() * edge_ > 0;
  }
  double sign() const { return smooth_ < (against_ ? 0 : edge_) ? -1 : 1; }
  // An EMF's speed, or none if it is against the wanted direction while slow speeds are not believed.
  double believed(double speed) const {
    return !against_ && speed * edge_ > 0 ? 0 : speed;
  }
  void set_edge(double speed) { edge_ = speed; }

 private:
  double smooth_ = 0;
  double edge_ = 0;       // rad/s against the wanted direction, 0: all speeds are believed
  bool against_ = false;  // turning against it, since beyond the edge
};

// The estimate at the present sample, and on to the next.
struct Estimate {
  double angle = 0;      // rad, theta_c at this sample
  double speed = 0;      // rad/s, theta_c'
  double emf = 0;        // V, on delta, smoothed
  double error = 0;      // V, the gamma voltage or its like: zero in step
};

class VoltageModelEstimator {
 public:
  VoltageModelEstimator(const design::sinusoidal::Motor& motor,
                        const design::sinusoidal::VoltageModel& p, double period)
      : motor_(motor), p_(p), period_(period) {}

  void start(double angle, double speed) {
    now_ = {.angle = angle, .speed = speed, .emf = motor_.k_e * speed};
    previous_ = angle - speed * period_;
    integral_ = 0;
    way_.start(speed);
    recent_.assign(static_cast<std::size_t>(p_.samples), speed);
    next_ = 0;
  }

  // A mean speed below it is one backward: 0, or what is too slow to be believed, in rad/s.
  void set_edge(double speed) { way_.set_edge(speed); }

  // The sample has come that ends `interval`; the estimate is for its instant, theta_c' for the time
  // until the next one.
  const Estimate& update(const Interval& interval) {
    now_.angle = wrapped(previous_ + now_.speed * period_);
    const double middle = previous_ + 0.5 * now_.speed * period_;
    const Vector e = seen_from(middle, emf(interval));
    const double i_gamma = seen_from(now_.angle, interval.current).x;

    recent_[next_] = e.y / (motor_.k_e + (motor_.inductance_d - motor_.inductance_q) * i_gamma);
    next_ = (next_ + 1) % recent_.size();
    double hypothetical = 0;
    for (const double speed : recent_) hypothetical += speed / static_cast<double>(recent_.size());

    integral_ += p_.k_si * period_ * e.x;
    const double correction = -way_.sign() * (p_.k_sp * e.x + integral_);
    previous_ = now_.angle;
    now_.speed = way_.believed(hypothetical) + correction;
    way_.update(now_.speed);
    now_.emf = motor_.k_e * hypothetical;
    now_.error = e.x;
    return now_;
  }
  const Estimate& estimate() const { return now_; }

 private:
  Vector emf(const Interval& i) const {
    return i.voltage - 0.5 * motor_.resistance * (i.before + i.current) -
           (motor_.inductance_q / period_) * (i.current - i.before);
  }

  design::sinusoidal::Motor motor_;
  design::sinusoidal::VoltageModel p_;
  double period_, previous_ = 0, integral_ = 0;
  std::vector<double> recent_;
  std::size_t next_ = 0;
  Estimate now_;
  Way way_;
};

}  // namespace steplock::reference::sinusoidal
