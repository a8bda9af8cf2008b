// Both estimators of Matsui 1996 behind one observer, for side-by-side work: `voltage` chooses
// whose angle and speed go on.
//
//     Observer -> FollowedEmf     current model, (12)-(20)  --+-> step, angle += step
//              -> CorrectedSpeed  voltage model, (6)-(11)   --'
//
// Applied voltage, what moved the current, sine and cosine and the turning are the same for both:
// side by side they take 3 products more than the current model alone.  A drive that needs one
// takes CurrentModel or VoltageModel in this block's place, whose ports are the same but for words.
// The words stand still while the drive runs.
//
//     formats                those of CurrentModel and VoltageModel
//     multipliers            37 products of 16 x 16 bits
//
// Doc: docs/blocks/estimator.md   Test: tests/hls/estimator_test.cpp

#pragma once

#include "hls/sinusoidal/current_model.hpp"
#include "hls/sinusoidal/voltage_model.hpp"

namespace steplock {

struct EstimatorConfig {
  bool voltage = false;  // the voltage model's estimate, else the current model's
  bool average = false;  // voltage model: the mean of 8 samples
  UInt<15> decay = 0;    // u0.15, per sample
  UInt<15> gain = 0;     // u2.13, current per voltage
  UInt<15> k_theta = 0;  // u1.14, turns per current; K_SP L of the voltage model is the same
  UInt<15> k_e = 0;      // u2.13, voltage per current
  UInt<15> k_speed = 0;  // u-2.17, turns per voltage
  UInt<15> k_emf = 0;    // u0.15, turns per current
  UInt<15> k_si = 0;     // u-8.23, turns per current
};

// Both laws, side by side.
class EitherLaw {
 public:
  Turned follow(const Observer::Seen& seen, const EstimatorConfig& config) {
    const Turned by_current = emf_.follow(seen, config);
    const Turned by_voltage = speed_.follow(seen, config);
    return config.voltage ? by_voltage : by_current;
  }
  void rest() {
    emf_.rest();
    speed_.rest();
  }

 private:
  FollowedEmf emf_;
  CorrectedSpeed speed_;
};

class Estimator {
 public:
  struct In {
    bool enable = false;     // false: the angle is `initial`, the speed 0
    Int<16> edge = 0;        // s0.15 of 1/16 turn: a slower mean step is one backward
    Angle initial = 0;       // u0.24
    Int<16> i_u = 0;         // s0.15
    Int<16> i_v = 0;         // s0.15
    UInt<12> v_dc = 0;       // u0.12
    AppliedPattern pattern;  // of the interval that this sample ends
    EstimatorConfig config;
  };

  using Out = Estimate;

  Out tick(const In& in) { return observer_.sample(in, laws_); }

 private:
  Observer observer_;
  EitherLaw laws_;
};

}  // namespace steplock
