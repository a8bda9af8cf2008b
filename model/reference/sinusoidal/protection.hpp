// What ends a run, or an attempt: once per sample.
//
//     over-current   any phase beyond over_current                        fault at once
//     lost sample    so many periods in a row without a reading            fault at once
//     saturated      a regulator at its limit for saturated_s             the attempt has failed
//     EMF            beyond emf_low .. emf_high times K_E speed for emf_s, above emf_speed
//     too slow       below slow_speed for slow_s longer than above, in a lock     "
//
// The EMF test is the one against speeds that only exist in the estimator.
//
// Doc: docs/sinusoidal.md   Test: tests/model/reference/sinusoidal/sinusoidal_protection_test.cpp
#pragma once

#include <algorithm>

#include "model/design/sinusoidal/parameters.hpp"
#include "model/reference/sinusoidal/signals.hpp"

namespace steplock::reference::sinusoidal {

class Protection {
 public:
  Protection(const design::sinusoidal::Protection& p, double k_e, double period)
      : p_(p), k_e_(k_e), period_(period) {}

  struct In {
    Phases current = {};
    bool regulating = false, saturated = false;
    bool locked = false;
    double speed = 0, emf = 0;  // in the wanted direction
  };
  void sampled(const In& in) {
    lost_ = 0;
    failed_ = fatal_ = Reason::kNone;
    count(saturated_s_, in.regulating && in.saturated);
    // The speed that a lost estimator shows is noise around nothing: what counts is the balance.
    const bool slow = in.speed < p_.slow_speed;
    slow_s_ = in.locked ? std::max(0.0, slow_s_ + (slow ? period_ : -period_)) : 0;
    count(emf_s_, in.locked && in.speed > p_.emf_speed && !plausible(in.emf, in.speed));
    if (p_.slow_s > 0 && slow_s_ > p_.slow_s) failed_ = Reason::kTooSlow;
    if (p_.emf_s > 0 && emf_s_ > p_.emf_s) failed_ = Reason::kEmf;
    if (p_.saturated_s > 0 && saturated_s_ > p_.saturated_s) failed_ = Reason::kSaturated;
    for (const double i : in.current) {
      if (std::abs(i) > p_.over_current) fatal_ = Reason::kOverCurrent;
    }
  }
  // A period began, and the sample of the one before never came.
  void missed() {
    if (++lost_ >= p_.lost_samples) fatal_ = Reason::kLostSample;
  }
  void reset() { *this = Protection(p_, k_e_, period_); }

  // Whether an EMF belongs to a speed.
  bool plausible(double emf, double speed) const {
    const double expected = k_e_ * speed;
    return expected > 0 && emf > p_.emf_low * expected && emf < p_.emf_high * expected;
  }

  Reason failed() const { return failed_; }
  Reason fatal() const { return fatal_; }

 private:
  void count(double& seconds, bool now) const { seconds = now ? seconds + period_ : 0; }

  design::sinusoidal::Protection p_;
  double k_e_, period_;
  double saturated_s_ = 0, slow_s_ = 0, emf_s_ = 0;
  int lost_ = 0;
  Reason failed_ = Reason::kNone, fatal_ = Reason::kNone;
};

}  // namespace steplock::reference::sinusoidal
