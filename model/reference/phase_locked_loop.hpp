// Phase detector and loop filter of the digital phase-locked loop.
//
//     error   = expected - place of the crossing      turns of a step, positive if the rotor leads
//     no crossing in the whole step: expected - 1 (it lags) or, if the level before the crossing never
//     showed, 0 (freewheeling hid it) or, after such a step or one that led by 1/8, lead_error
//
// The loop filter per second is the circuit of Fig. 4: a current into C1, beside it R and C2 in
// series; the voltage on C1 is the frequency.  Between ticks the error is constant, so the two
// capacitors' voltages have a closed form and no discretisation error is made:
//
//     mean m = (C1 V1 + C2 V2) / (C1 + C2):  m' = integral * e      (charge)
//     f = V1:   f' = (m - f) omega_p + proportional * omega_p * e   (R equalises the two)
//
// Doc: docs/theory.md   Test: tests/model/reference/reference_pll_test.cpp
#pragma once

#include <algorithm>
#include <cmath>

#include "model/design/parameters.hpp"

namespace steplock::reference {

class PhaseDetector {
 public:
  explicit PhaseDetector(const design::LoopParameters& p) : p_(p) {}

  struct In {
    bool crossing = false;
    double crossing_phase = 0;
    bool before_seen = false;  // of the step that ends, if step_ended
    bool step_ended = false;
    bool counts = true;  // the step's crossing is one that the detector looks at
    double window = 0;
  };
  void update(const In& in) {
    updated_ = good_ = missed_ = false;
    if (in.step_ended) {
      missed_ = in.counts && !found_;
      if (in.counts) {
        const bool hid = missed_ && !in.before_seen, again = hid && hid_;
        masked_lead_ = again || (hid && error_ >= 1. / 16);
        const bool leads = again || (hid && error_ >= 1. / 8);
        hid_ = hid;
        if (missed_) take(!hid ? p_.expected - 1 : leads ? p_.lead_error : 0);
      }
      found_ = false;
    }
    if (in.crossing && in.counts) {
      found_ = true;
      masked_lead_ = false;
      take(p_.expected - in.crossing_phase);
      good_ = std::abs(error_) < in.window;
    }
  }
  // A step entered in its middle is not a miss.
  void restart(double error = 0) { found_ = true, error_ = error; }

  double error() const { return error_; }
  bool updated() const { return updated_; }
  bool good() const { return good_; }
  bool missed() const { return missed_; }
  // The last crossing was hidden, and the rotor led in the step before.
  bool masked_lead() const { return masked_lead_; }

 private:
  void take(double error) {
    error_ = std::clamp(error, -0.5, 0.5);
    updated_ = true;
  }

  design::LoopParameters p_;
  double error_ = 0;
  bool updated_ = false, good_ = false, missed_ = false, masked_lead_ = false, found_ = true;
  bool hid_ = false;  // the last step that counts was on the level after from its beginning
};

class LoopFilter {
 public:
  explicit LoopFilter(const design::LoopParameters& p) : p_(p) {}

  void load(double f) { load(f, f); }
  void load(double mean, double f) { mean_ = mean, f_ = f; }

  // Run for long, and now at this frequency with this error.
  void join(double f, double error) {
    const double e = compensated_at(error, f);
    const double gained = p_.form == design::LoopForm::kPerStep ? e * f : e;
    mean_ = std::clamp(f - p_.proportional * gained, p_.minimum, p_.maximum);
    f_ = f;
  }

  // One crossing, coefficients per step.
  void step(double error) {
    const double e = compensated(error), gained = e * f_;
    if (!winds_up(gained)) mean_ += p_.integral * gained;
    const double v = mean_ + p_.proportional * gained;
    f_ = std::clamp(f_ + p_.pole * (v - f_), p_.minimum, p_.maximum);
  }
  // `dt` seconds with this error, coefficients per second.
  void run(double error, double dt) {
    const double e = compensated(error), decay = std::exp(-p_.pole * dt);
    const double slope = winds_up(e) ? 0 : p_.integral * e;
    // Exact for the ramp `slope`: where f would stand behind the mean in the long run, and the
    // rest of the distance to it.
    const double behind = p_.proportional * e - slope / p_.pole;
    const double away = f_ - mean_ - behind;
    mean_ += slope * dt;
    f_ = std::clamp(mean_ + behind + away * decay, p_.minimum, p_.maximum);
  }
  // Newton's iteration for 1 / period, from the turns that passed in the last period.
  void catch_up(double turns) {
    mean_ = std::clamp(mean_ * (1 + std::clamp(1 - turns, -0.5, 0.5)), p_.minimum, p_.maximum);
    f_ = mean_;
  }

  double frequency() const { return f_; }

 private:
  double compensated_at(double error, double f) const { return error + p_.delay * f; }
  double compensated(double error) const { return compensated_at(error, f_); }
  bool winds_up(double e) const { return (e > 0 && f_ >= p_.maximum) || (e < 0 && f_ <= p_.minimum); }

  design::LoopParameters p_;
  double mean_ = 0, f_ = 0;
};

}  // namespace steplock::reference
