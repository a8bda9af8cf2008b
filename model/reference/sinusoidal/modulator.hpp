// From a voltage vector to three duties, and these to gates.
//
//     sine          d_k = 1/2 + v_k / v_dc                          up to v_dc / 2 per phase
//     space vector  the same less the mean of the greatest and least   up to v_dc / sqrt 3
//
// Pulses lie centred in the period: the high side is to conduct for (1 - d) / 2 <= t / T < (1 + d) / 2,
// the low side otherwise.  So all three low sides conduct around the period's start, where the
// currents are sampled: there the ripple passes its mean.
//
// Doc: docs/sinusoidal.md   Test: tests/model/reference/sinusoidal/sinusoidal_modulator_test.cpp
#pragma once

#include <algorithm>

#include "model/design/sinusoidal/parameters.hpp"
#include "model/reference/pwm.hpp"
#include "model/reference/signals.hpp"
#include "model/reference/sinusoidal/vector.hpp"

namespace steplock::reference::sinusoidal {

// The longest vector in the linear range, power-invariant.
inline double longest_vector(design::Modulation m, double v_dc) {
  return std::sqrt(1.5) * v_dc *
         (m == design::Modulation::kSpaceVector ? 1 / std::numbers::sqrt3 : 0.5);
}

inline Phases duties(design::Modulation m, Vector voltage, double v_dc) {
  if (v_dc <= 0) return {};
  Phases v = phases(voltage);
  if (m == design::Modulation::kSpaceVector) {
    const auto [least, greatest] = std::minmax_element(v.begin(), v.end());
    const double common = (*least + *greatest) / 2;
    for (double& x : v) x -= common;
  }
  for (double& x : v) x = std::clamp(0.5 + x / v_dc, 0.0, 1.0);
  return v;
}

class CentredPwm {
 public:
  explicit CentredPwm(const design::sinusoidal::Pwm& p) : p_(p) {}

  void set(const Phases& duty) { wanted_ = duty; }  // taken at the next period's start

  void update(double t) {
    started_ = t >= end_;
    if (!started_) return;
    start_ = t;
    end_ = t + p_.period;
    duty_ = wanted_;
    for (double& d : duty_) {
      if (d * p_.period < p_.minimum) d = 0;
      if ((1 - d) * p_.period < p_.minimum) d = 1;
    }
  }
  double next(double t) const {
    double next = end_;
    for (const double d : duty_) {
      if (d <= 0 || d >= 1) continue;
      for (const double edge : {rise(d), fall(d)}) {
        if (edge > t) next = std::min(next, edge);
      }
    }
    return next;
  }
  bool high(std::size_t leg, double t) const {
    const double d = duty_[leg];
    return d >= 1 || (d > 0 && t >= rise(d) && t < fall(d));
  }

  bool started() const { return started_; }         // a period began in this update
  const Phases& duty() const { return duty_; }      // of this period

 private:
  double rise(double d) const { return start_ + (1 - d) / 2 * p_.period; }
  double fall(double d) const { return start_ + (1 + d) / 2 * p_.period; }

  design::sinusoidal::Pwm p_;
  Phases wanted_ = {}, duty_ = {};
  double start_ = 0, end_ = 0;
  bool started_ = false;
};

}  // namespace steplock::reference::sinusoidal
