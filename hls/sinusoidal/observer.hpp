// What both estimators see of the back-EMF, and how both go on: once per sample.
//
//     Delta i  = i - i' + (R T/L) (i + i')/2 - (T/L) v  =  -(T/L) e     in the stationary frame
//                                both ends of the interval, v the applied voltage, e the EMF
//     turned into gamma-delta at the interval's middle; angle += step
//
// Matsui 1996, (7), (8) and (16).  It is part of an estimator's block, not one of its own.
//
//     currents, voltages     s0.15 of a full scale each;  Delta i: s-1.16
//     angle, step            u0.24, s-4.23 electrical turns (per sample): up to 1/16 turn
//     decay  R T/L           u0.15;    gain  T/L   u2.13, current per voltage
//
// Doc: docs/blocks/current_model.md   Test: tests/hls/current_model_test.cpp

#pragma once

#include "hls/numeric/bits.hpp"
#include "hls/sinusoidal/applied_voltage.hpp"
#include "hls/sinusoidal/sine.hpp"

namespace steplock {

using Angle = UInt<24>;      // u0.24, electrical turns
using Turn = Int<20>;        // s-4.23, electrical turns per sample
using MovedCurrent = Int<16>;  // s-1.16

// What a voltage moves the current: s.16.
inline Int<20> driven(Int<16> voltage, UInt<15> gain) {
  return wrap<Int<20>>((voltage * gain + (1 << 11)) >> 12);
}

// How a sample turns the estimate: by the EMF's speed, and by what the angle's error asks for, in
// the direction of turning.
struct Turned {
  Turn emf_step = 0;   // s-4.23
  Int<26> pull = 0;    // s2.23
};

// What an estimator tells at each sample.
struct Estimate {
  Angle angle = 0;    // u0.24, at this sample
  Turn step = 0;      // s-4.23, until the next
  Turn emf_step = 0;  // s-4.23, the EMF's part of it: of the voltage model, the hypothetical speed
  Int<16> error = 0;  // s-1.16, Delta i_gamma: zero in step
};

class Observer {
 public:
  struct Seen {
    MovedCurrent gamma = 0;  // s-1.16, -(T/L) e: zero in step
    MovedCurrent delta = 0;  // s-1.16
  };

  // One sample: what is seen, how the model's law turns the estimate, and on; without `enable` both
  // rest at `initial`.
  template <class In, class Law>
  Estimate sample(const In& in, Law& law) {
    const Seen seen = observe(in);
    const Turned turned = law.follow(seen, in.config);
    const Turn turn = step(turned, in.edge);
    remember(in);
    if (!in.enable) {
      rest(in.initial);
      law.rest();
      return {.angle = in.initial};
    }
    return {.angle = go_on(turn), .step = turn, .emf_step = turned.emf_step, .error = seen.gamma};
  }

 private:
  template <class In>
  Seen observe(const In& in) const {
    const auto sum_u = in.i_u + last_u_, sum_v = in.i_v + last_v_;
    const auto [v_alpha, v_beta] =
        applied_voltage(in.pattern, sum_u, sum_v, in.v_dc + last_dc_);

    // i_u and i_u + 2 i_v, whose sqrt(1/3) is beta, in s0.16.
    const auto free_u = free(in.i_u - last_u_, sum_u, in.config.decay);
    const auto free_v = free(in.i_v - last_v_, sum_v, in.config.decay);
    const auto twice = saturate<Int<18>>(free_u + free_v + free_v);
    const auto alpha = saturate<MovedCurrent>(free_u - driven(v_alpha, in.config.gain));
    const auto beta = saturate<MovedCurrent>(((twice * kInverseRoot3 + (1 << 14)) >> 15) -
                                             driven(v_beta, in.config.gain));

    // The step's last place is two of the angle's.
    const Angle middle = wrap<Angle>(angle_ + step_);
    const auto [sine, cosine] = sine_cosine(middle.slice<23, 8>());
    return {.gamma = rounded(alpha * cosine + beta * sine),
            .delta = rounded(beta * cosine - alpha * sine)};
  }

  // The step that the sample asks for.  It is one backward where the mean of 32 is below zero; or
  // below `edge`, as long as slow steps are not to be trusted.  Then the direction is that of -edge
  // until the other is seen beyond the edge, and from there until the mean crosses zero; and an EMF
  // against the direction of -edge is no EMF.
  Turn step(const Turned& turned, Int<16> edge) {
    const bool backward = wrap<Int<16>>(mean_steps_ >> 9) < (reversed_ ? Int<16>(0) : edge);
    const bool trusted = edge == Int<16>(0);
    reversed_ = !trusted && backward == edge.negative();
    const bool mistaken = !trusted && !reversed_ && turned.emf_step.negative() != backward;
    const Turn emf_step = mistaken ? Turn(0) : turned.emf_step;
    return saturate<Turn>(backward ? emf_step - turned.pull : emf_step + turned.pull);
  }

  // The ends of the interval are remembered whether or not the estimate goes on.
  template <class In>
  void remember(const In& in) {
    last_u_ = in.i_u;
    last_v_ = in.i_v;
    last_dc_ = in.v_dc;
  }
  void rest(Angle at) {
    angle_ = at;
    step_ = 0;
    mean_steps_ = 0;
    reversed_ = false;
  }
  // The angle at this sample.
  Angle go_on(Turn step) {
    angle_ = wrap<Angle>(angle_ + step_ + step_);
    step_ = step;
    mean_steps_ = wrap<Int<25>>(mean_steps_ - (mean_steps_ >> 5) + step);
    return angle_;
  }

  static constexpr Int<16> kInverseRoot3 = 18919;  // s0.15

  // What the current would have moved without any voltage, taken back: s1.16.
  static Int<18> free(Int<17> moved, Int<17> sum, UInt<15> decay) {
    return saturate<Int<18>>((Int<18>(moved) << 1) + ((sum * decay + (1 << 14)) >> 15));
  }
  // s.31 to s-1.16.
  template <int W>
  static MovedCurrent rounded(Int<W> product) {
    return saturate<MovedCurrent>((product + (1 << 14)) >> 15);
  }

  Int<16> last_u_ = 0;   // s0.15, at the interval's begin
  Int<16> last_v_ = 0;   // s0.15
  UInt<12> last_dc_ = 0; // u0.12
  Angle angle_ = 0;      // u0.24, theta_c at the last sample
  Turn step_ = 0;        // s-4.23
  Int<25> mean_steps_ = 0;  // s-4.28, 32 mean steps
  bool reversed_ = false;  // turning against the direction of -edge
};

}  // namespace steplock
