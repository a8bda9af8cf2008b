// Pulse-width modulation and the fixed-off-time current limit, with edges at exact instants.
//
//     on while lead <= t - start < lead + duty * period,   lead = 0, or centred (1 - duty) / 2
//     the limit cuts for off_time when the comparator answers, from `blanking` after switch-on on; for a quarter of it
//     where a cut turns all gates off (a drive that runs, or looks for its rotor), so that the bus takes the current down
//
// Doc: docs/theory.md   Test: tests/model/reference/reference_pwm_test.cpp
#pragma once

#include <algorithm>
#include <limits>

#include "model/design/parameters.hpp"

namespace steplock::reference {

inline constexpr double kNever = std::numeric_limits<double>::infinity();

class Pwm {
 public:
  explicit Pwm(const design::PwmParameters& p) : p_(p) {}

  void set_duty(double duty) { wanted_ = duty; }  // taken at the next period's start

  // `t` may not pass next().
  void update(double t) {
    started_ = tick_ = false;
    if (t >= end_) start_period(t);
    on_ = t >= rise_ && t < fall_;
  }
  double next(double t) const {
    if (t < rise_) return std::min(rise_, end_);
    return t < fall_ ? std::min(fall_, end_) : end_;
  }

  bool on() const { return on_; }
  bool started() const { return started_; }  // a period began in this update
  bool tick() const { return tick_; }        // and with it a tick
  double duty() const { return duty_; }      // of this period, after the minimum pulse

 private:
  void start_period(double t) {
    started_ = true;
    end_ = t + p_.period;
    tick_ = periods_ == 0;
    periods_ = (periods_ + 1) % std::max(1, p_.tick_periods);

    double width = std::clamp(wanted_, 0.0, 1.0) * p_.period;
    if (width < p_.minimum) width = 0;
    if (width > p_.period - p_.minimum) width = p_.period;
    duty_ = width / p_.period;
    rise_ = width <= 0 ? kNever : t + (p_.centred ? (p_.period - width) / 2 : 0);
    fall_ = width >= p_.period ? kNever : rise_ + width;
  }

  design::PwmParameters p_;
  double wanted_ = 0, duty_ = 0, end_ = 0, rise_ = kNever, fall_ = kNever;
  int periods_ = 0;
  bool on_ = false, started_ = false, tick_ = false;
};

class CurrentLimit {
 public:
  explicit CurrentLimit(const design::LimitParameters& p) : p_(p) {}

  void update(double t, bool wanted, bool comparator, bool all_off = false) {
    hit_ = false;
    if (cut_) {
      released_ |= !comparator;
      if (t >= until_) {
        cut_ = false;
        stuck_ = released_ ? 0 : stuck_ + 1;
      }
    }
    const bool was_on = on_;
    on_ = wanted && !cut_;
    if (on_ && !was_on) believed_ = t + p_.blanking;
    if (on_ && comparator && p_.off_time > 0 && t >= believed_) {
      hit_ = cut_ = true;
      on_ = released_ = false;
      until_ = t + p_.off_time / (all_off ? 4 : 1);
    }
  }
  double next(double t) const {
    if (cut_) return until_;
    return on_ && t < believed_ ? believed_ : kNever;
  }

  bool on() const { return on_; }
  bool cut() const { return cut_; }     // off-time
  bool hit() const { return hit_; }     // cut in this update
  int stuck() const { return stuck_; }  // hits in a row without a release in the off-time

 private:
  design::LimitParameters p_;
  double until_ = 0, believed_ = 0;
  bool on_ = false, cut_ = false, hit_ = false, released_ = false;
  int stuck_ = 0;
};

}  // namespace steplock::reference
