// VCO and divide-by-N in one: the phase runs at `frequency` steps/s, exact between updates, and
// each whole turn is a commutation, up (forward) or down (reverse) through the six steps.
//
// Doc: docs/theory.md   Test: tests/model/reference/reference_oscillator_test.cpp
#pragma once

#include "model/reference/pwm.hpp"

namespace steplock::reference {

class Oscillator {
 public:
  // `t` may not pass next().
  void update(double t, bool reverse) {
    commutated_ = t >= wrap_;
    if (!commutated_) return;
    step_ = (step_ + (reverse ? 5 : 1)) % 6;
    start_from(t, 0);
  }
  void set_frequency(double t, double f) {
    const double now = phase(t);
    frequency_ = f;
    start_from(t, now);
  }
  void load(double t, int step, double phase) {
    step_ = step;
    start_from(t, phase);
  }
  void stop(double t) { set_frequency(t, 0); }

  double next() const { return wrap_; }
  double phase(double t) const { return std::min(phase_ + frequency_ * (t - time_), 1.0); }
  double frequency() const { return frequency_; }
  int step() const { return step_; }
  bool commutated() const { return commutated_; }

 private:
  void start_from(double t, double phase) {
    time_ = t;
    phase_ = phase;
    wrap_ = frequency_ > 0 ? t + (1 - phase) / frequency_ : kNever;
  }

  double time_ = 0, phase_ = 0, frequency_ = 0, wrap_ = kNever;
  int step_ = 0;
  bool commutated_ = false;
};

}  // namespace steplock::reference
