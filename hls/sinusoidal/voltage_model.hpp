// Voltage-model estimator, Matsui 1996, (6)-(11): angle and speed of the rotor, once per sample.
//
//     Delta i  = -(T/L) e                       what the EMF moved the current, in gamma-delta
//     theta_e' = e_delta / K_E                   (7), the mean of 8 samples with `average`
//     n_W      = -sign(step) (K_SP e_gamma + K_SI integral of e_gamma)
//     step     = T (theta_e' + n_W);  angle += step                                 (11)
//
// The angle given is theta_c at the sample's instant, the step what it turns until the next.  There
// is no model that follows: an EMF's noise is in the speed at once, which is what the mean is for.
// The sign is that of the step's mean over 32 samples.  Without `enable` the angle is `initial` and
// all else 0; the ends of the interval are remembered all the same.
//
//     currents, voltages     s0.15 of a full scale each; Delta i: s-1.16
//     angle, step            u0.24, s-4.23 electrical turns (per sample): up to 1/16 turn
//     decay  R T/L           u0.15;    gain  T/L   u2.13, current per voltage
//     k_emf    L / K_E        u0.15, turns per current
//     k_theta  K_SP L         u1.14, turns per current
//     k_si     K_SI L T       u-8.23, turns per current;  integral: s-4.31
//     multipliers            33 products of 16 x 16 bits
//
// Doc: docs/blocks/voltage_model.md   Test: tests/hls/voltage_model_test.cpp

#pragma once

#include <array>

#include "hls/sinusoidal/observer.hpp"

namespace steplock {

struct VoltageModelConfig {
  bool average = false;  // the mean of 8 samples
  UInt<15> decay = 0;    // u0.15, per sample
  UInt<15> gain = 0;     // u2.13, current per voltage
  UInt<15> k_emf = 0;    // u0.15, turns per current
  UInt<15> k_theta = 0;  // u1.14, turns per current
  UInt<15> k_si = 0;     // u-8.23, turns per current
};

// The hypothetical speed and its correction.
class CorrectedSpeed {
 public:
  template <class Config>
  Turned follow(const Observer::Seen& seen, const Config& config) {
    sum_ = wrap<Sum>(sum_ - recent_[kSamples - 1] + seen.delta);
    for (std::size_t n = kSamples - 1; n > 0; --n) recent_[n] = recent_[n - 1];
    recent_[0] = seen.delta;
    const Sum emf = config.average ? sum_ : Sum(seen.delta) << 3;
    const auto moved = integral_ + ((seen.gamma * config.k_si + (1 << 7)) >> 8);
    integral_ = saturate<Integral>(moved);
    const auto pull = (seen.gamma * config.k_theta + (1 << 6)) >> 7;
    return {.emf_step = saturate<Turn>(((1 << 10) - emf * config.k_emf) >> 11),
            .pull = wrap<Int<26>>(pull + (integral_ >> 8))};
  }
  void rest() {
    sum_ = 0;
    integral_ = 0;
    for (auto& moved : recent_) moved = 0;
  }

 private:
  static constexpr std::size_t kSamples = 8;
  using Sum = Int<19>;       // s2.16; of 8 samples: s-1.19 of their mean
  using Integral = Int<28>;  // s-4.31, turns per sample

  std::array<MovedCurrent, kSamples> recent_ = {};  // Delta i_delta
  Sum sum_ = 0;                                     // of them
  Integral integral_ = 0;
};

class VoltageModel {
 public:
  struct In {
    bool enable = false;     // false: the angle is `initial`, the speed 0
    Int<16> edge = 0;        // s0.15 of 1/16 turn: a slower mean step is one backward
    Angle initial = 0;       // u0.24
    Int<16> i_u = 0;         // s0.15
    Int<16> i_v = 0;         // s0.15
    UInt<12> v_dc = 0;       // u0.12
    AppliedPattern pattern;  // of the interval that this sample ends
    VoltageModelConfig config;
  };

  using Out = Estimate;

  Out tick(const In& in) { return observer_.sample(in, speed_); }

 private:
  Observer observer_;
  CorrectedSpeed speed_;
};

}  // namespace steplock
