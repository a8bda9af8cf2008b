// Current-model estimator, Matsui 1996, (12)-(20): angle and speed of the rotor, once per sample.
//
//     Delta i  = i - i' + (R T/L) (i + i')/2 - (T/L) v    in the stationary frame, both ends of the
//                                                            interval, v the applied voltage
//     turned into gamma-delta at the interval's middle, and Delta i_delta += (T/L) e_c    (14)-(16)
//     e_c     -= K_e Delta i_delta                                                        (18)
//     step     = e_c T / K_E + sign(step) K_theta Delta i_gamma;  angle += step       (19), (20)
//
// The angle given is theta_c at the sample's instant, the step what it turns until the next.  The
// sign is that of the step's mean over 32 samples.  Without `enable` the angle is `initial` and all
// else 0; the ends of the interval are remembered all the same.
//
//     currents, voltages     s0.15 of a full scale each; Delta i: s-1.16
//     e_c                    s0.27 of the voltage
//     angle, step            u0.24, s-4.23 electrical turns (per sample): up to 1/16 turn
//     decay  R T/L           u0.15;    gain  T/L   u2.13, current per voltage
//     k_e                    u2.13, voltage per current;  k_theta  u1.14, turns per current
//     k_speed  T / K_E       u-2.17, turns per voltage
//     multipliers            34 products of 16 x 16 bits
//
// Doc: docs/blocks/current_model.md   Test: tests/hls/current_model_test.cpp

#pragma once

#include "hls/sinusoidal/observer.hpp"

namespace steplock {

struct CurrentModelConfig {
  UInt<15> decay = 0;    // u0.15, per sample
  UInt<15> gain = 0;     // u2.13, current per voltage
  UInt<15> k_e = 0;      // u2.13, voltage per current
  UInt<15> k_theta = 0;  // u1.14, turns per current
  UInt<15> k_speed = 0;  // u-2.17, turns per voltage
};

// e_c, which follows the EMF along delta.
class FollowedEmf {
 public:
  template <class Config>
  Turned follow(const Observer::Seen& seen, const Config& config) {
    const auto emf = wrap<Int<16>>(emf_ >> 12);
    const auto delta = saturate<MovedCurrent>(seen.delta + driven(emf, config.gain));
    emf_ = saturate<Emf>(emf_ - ((delta * config.k_e) >> 2));
    const auto turned = wrap<Int<22>>(emf_ >> 6) * config.k_speed;
    return {.emf_step = saturate<Turn>((turned + (1 << 14)) >> 15),
            .pull = wrap<Int<26>>((seen.gamma * config.k_theta + (1 << 6)) >> 7)};
  }
  void rest() { emf_ = 0; }

 private:
  using Emf = Int<28>;  // s0.27
  Emf emf_ = 0;
};

class CurrentModel {
 public:
  struct In {
    bool enable = false;     // false: the angle is `initial`, the speed 0
    Int<16> edge = 0;        // s0.15 of 1/16 turn: a slower mean step is one backward
    Angle initial = 0;       // u0.24
    Int<16> i_u = 0;         // s0.15
    Int<16> i_v = 0;         // s0.15
    UInt<12> v_dc = 0;       // u0.12
    AppliedPattern pattern;  // of the interval that this sample ends
    CurrentModelConfig config;
  };

  using Out = Estimate;

  Out tick(const In& in) { return observer_.sample(in, emf_); }

 private:
  Observer observer_;
  FollowedEmf emf_;
};

}  // namespace steplock
