// Speed control, once per tick: PI from the loop's frequency to the duty, with slew limits.
//
//     duty = integral + kp (ref - f)        integral' = ki (ref - f), frozen against a limit
//     ref moves towards the target by at most slew; not upwards while the current limit cuts
//     duty = integral = max(duty, bemf f)    once, where a rotor has come down to a target that was lower
//
// Doc: docs/theory.md   Test: tests/model/reference/reference_speed_control_test.cpp
#pragma once

#include <algorithm>
#include <cmath>

#include "model/design/parameters.hpp"

namespace steplock::reference {

class SpeedControl {
 public:
  SpeedControl(const design::SpeedParameters& p, double tick) : p_(p), tick_(tick) {}

  double bemf_duty(double f) const { return p_.bemf * f; }
  double loaded_duty(double f) const { return p_.loaded * f; }

  // Not in control: what the start sequence asks for.
  void follow(double duty, double integral, double f) {
    duty_ = duty;
    integral_ = integral;
    reference_ = f;
    descends_ = resumes_ = at_low_ = at_high_ = false;
  }
  // In control for long: the reference got so far, and the next tick gives this duty at this frequency.
  void join(double duty, double reference, double f) {
    follow(duty, std::clamp(duty - (p_.kp + p_.ki * tick_) * (reference - f), p_.minimum, p_.maximum), reference);
  }
  // In control where another one stands; `descends`, `resumes`: it comes down to a lower target, and has just arrived.
  void join_at(double duty, double integral, double reference, bool descends, bool resumes) {
    duty_ = duty, integral_ = integral, reference_ = reference;
    descends_ = descends, resumes_ = resumes;
  }
  bool resumes() const { return resumes_; }
  // `limited`: the current limit cut, the duty stays; `freewheels`: the current is about to hide crossings, and the duty
  // falls, faster than its slew, if it is to rise; `masked_lead`: one of a rotor that leads is hidden, it falls by its slew.
  void tick(double target, double f, bool limited, bool masked_lead = false, bool freewheels = false) {
    if (resumes_) {
      resumes_ = false;
      const double duty = std::min(std::max(bemf_duty(f), duty_), p_.maximum);
      follow(duty, duty, f);
      return;
    }
    const double move = p_.slew * tick_, slew = p_.duty_slew * tick_;
    reference_ += std::clamp(target - reference_, -move, held_ ? 0 : move);
    const double error = reference_ - f;
    const bool yields = (limited || at_high_ || p_.ki * tick_ * error >= kAsks) && freewheels;
    const double fall = yields ? kYield * slew : slew, rise = yields || masked_lead ? -fall : limited ? 0 : slew;
    const double low = std::max(p_.minimum, duty_ - fall), high = std::max(low, std::min(p_.maximum, duty_ + rise));
    const bool far = reference_ > target;
    resumes_ = descends_ && !far && error >= 0;
    descends_ = !resumes_ && (descends_ || far);
    // The integral first, as long as what it last gave was not bounded on its side.
    const bool winds_up = error > 0 ? at_high_ || limited : at_low_;
    const double integral = winds_up ? integral_ : integral_ + p_.ki * tick_ * error;
    integral_ = std::clamp(integral, p_.minimum, p_.maximum);
    const double wanted = integral_ + p_.kp * error;
    duty_ = std::clamp(wanted, low, high);
    margin_ = std::min(std::abs(wanted - low), std::abs(wanted - high));
    at_high_ = wanted >= high || integral > p_.maximum;
    at_low_ = wanted < low || integral < p_.minimum;
    held_ = limited;
  }

  double duty() const { return duty_; }
  double reference() const { return reference_; }
  // Whether the next integral meets a bound above or below, and how near in duty that was to be otherwise.
  bool at_high() const { return at_high_; }
  bool at_low() const { return at_low_; }
  double margin() const { return margin_; }

 private:
  static constexpr double kAsks = 1.0 / 8192;  // of the duty, a tick
  static constexpr double kYield = 2;          // times its slew
  design::SpeedParameters p_;
  double tick_, duty_ = 0, integral_ = 0, reference_ = 0, margin_ = 0;
  bool at_low_ = false, at_high_ = false;  // it wanted less than it may, or more
  bool held_ = false;  // by the current limit
  bool descends_ = false;  // the reference went down, and the rotor has not been found at the target
  bool resumes_ = false;   // it has: control begins once more
};

}  // namespace steplock::reference
