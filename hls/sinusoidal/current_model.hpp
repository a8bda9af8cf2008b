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
//     multipliers            34 products of 16 x 16 bits: one multiplier, in turn
//
// Doc: docs/blocks/current_model.md   Test: tests/hls/current_model_test.cpp

#pragma once

#include "hls/numeric/bits.hpp"
#include "hls/numeric/scheduled.hpp"
#include "hls/sinusoidal/applied_voltage.hpp"
#include "hls/sinusoidal/sine.hpp"

namespace steplock {

using Angle = UInt<24>;  // u0.24, electrical turns
using Turn = Int<20>;    // s-4.23, electrical turns per sample

struct EstimatorWords {
  UInt<15> decay = 0;    // u0.15, per sample
  UInt<15> gain = 0;     // u2.13, current per voltage
  UInt<15> k_e = 0;      // u2.13, voltage per current
  UInt<15> k_theta = 0;  // u1.14, turns per current
  UInt<15> k_speed = 0;  // u-2.17, turns per voltage
};

class CurrentModel {
 public:
  struct In {
    bool enable = false;     // false: the angle is `initial`, the speed 0
    Angle initial = 0;       // u0.24
    Int<16> i_u = 0;         // s0.15
    Int<16> i_v = 0;         // s0.15
    UInt<12> v_dc = 0;       // u0.12
    AppliedPattern pattern;  // of the interval that this sample ends
    EstimatorWords words;
  };

  struct Out {
    Angle angle = 0;    // u0.24, at this sample
    Turn step = 0;      // s-4.23, until the next
    Turn emf_step = 0;  // s-4.23, the EMF's part of it
    Int<16> error = 0;  // s-1.16, Delta i_gamma: zero in step
  };

  Out tick(const In& in) {
    const EstimatorWords& words = in.words;
    const auto sum_u = in.i_u + last_u_, sum_v = in.i_v + last_v_;
    const auto [v_alpha, v_beta] =
        applied_voltage(in.pattern, sum_u, sum_v, in.v_dc + last_dc_);

    // i_u and i_u + 2 i_v, whose sqrt(1/3) is beta, in s0.16.
    const auto free_u = free(in.i_u - last_u_, sum_u, words.decay);
    const auto free_v = free(in.i_v - last_v_, sum_v, words.decay);
    const auto twice = saturate<Int<18>>(free_u + free_v + free_v);
    const auto alpha = saturate<Small>(free_u - driven(v_alpha, words.gain));
    const auto beta = saturate<Small>(((twice * kInverseRoot3 + (1 << 14)) >> 15) -
                                      driven(v_beta, words.gain));

    // The step's last place is two of the angle's.
    const Angle middle = wrap<Angle>(before_ + step_);
    const auto [sine, cosine] = sine_cosine(middle.slice<23, 8>());
    const auto gamma = rounded(alpha * cosine + beta * sine);
    const auto emf = wrap<Int<16>>(emf_ >> 12);
    const auto delta = saturate<Small>(rounded(beta * cosine - alpha * sine) +
                                       driven(emf, words.gain));
    const auto emf_now = saturate<Emf>(emf_ - ((delta * words.k_e) >> 2));

    const auto turned = wrap<Int<22>>(emf_now >> 6) * words.k_speed;
    const auto by_emf = saturate<Turn>((turned + (1 << 14)) >> 15);
    const auto pull = (gamma * words.k_theta + (1 << 6)) >> 7;
    const auto step = saturate<Turn>(way_.negative() ? by_emf - pull : by_emf + pull);

    last_u_ = in.i_u;
    last_v_ = in.i_v;
    last_dc_ = in.v_dc;
    if (!in.enable) {
      before_ = in.initial;
      step_ = 0;
      emf_ = 0;
      way_ = 0;
      return {.angle = in.initial};
    }
    before_ = wrap<Angle>(before_ + step_ + step_);
    step_ = step;
    emf_ = emf_now;
    way_ = wrap<Int<25>>(way_ - (way_ >> 5) + step);
    return {.angle = before_, .step = step, .emf_step = by_emf, .error = gamma};
  }

 private:
  using Small = Int<16>;  // s-1.16
  using Emf = Int<28>;    // s0.27
  static constexpr Int<16> kInverseRoot3 = 18919;  // s0.15

  // What the current would have moved without any voltage, taken back: s1.16.
  static Int<18> free(Int<17> moved, Int<17> sum, UInt<15> decay) {
    return saturate<Int<18>>((Int<18>(moved) << 1) + ((sum * decay + (1 << 14)) >> 15));
  }
  // What a voltage moves the current: s.16.
  static Int<20> driven(Int<16> voltage, UInt<15> gain) {
    return wrap<Int<20>>((voltage * gain + (1 << 11)) >> 12);
  }
  // s.31 to s-1.16.
  template <int W>
  static Small rounded(Int<W> product) {
    return saturate<Small>((product + (1 << 14)) >> 15);
  }

  Int<16> last_u_ = 0;   // s0.15, at the interval's begin
  Int<16> last_v_ = 0;   // s0.15
  UInt<12> last_dc_ = 0; // u0.12
  Angle before_ = 0;     // u0.24, theta_c at the last sample
  Turn step_ = 0;        // s-4.23
  Emf emf_ = 0;          // s0.27, e_c
  Int<25> way_ = 0;      // s-4.28, 32 mean steps
};

// One multiplier, short enough for 24 MHz on UP5K; whoever gives the inputs holds them.
using CurrentModelLoop = Scheduled<
    CurrentModel,
    Budget{.multipliers = 1, .clocks = 41, .levels = 10, .inputs = Inputs::kHeld}>;

}  // namespace steplock
