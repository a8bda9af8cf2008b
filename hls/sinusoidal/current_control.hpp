// Current control in the assumed frame: phase currents in, the voltage vector out.
//
//     Clarke      i_alpha = i_u,  i_beta = (i_u + 2 i_v) / sqrt 3
//     Park        i_gamma =  i_alpha cos + i_beta sin,   i_delta = -i_alpha sin + i_beta cos
//     PI          x += k_i e,  u = x + k_p e,  e = set - i                   (one for each axis)
//     decoupling  u_gamma -= w L i_delta,  u_delta += w L i_gamma + w K_E   Matsui 1996, (5)
//     limit       |u_gamma| <= 3/4 U,  |u_delta| <= U - 9/64 |u_gamma|, 17/16 U - 13/32 |u_gamma|,
//                 5/4 U - 13/16 |u_gamma|: within the circle U, a part of the dc voltage, by 3 %
//                 of it at most
//     back        v_alpha = u_gamma cos' - u_delta sin',  v_beta = u_gamma sin' + u_delta cos'
//
// The voltage acts one to two samples later: it goes back at the angle `ahead`, where the frame
// will then stand.  wanted_u, wanted_v are the set currents seen from there as phase currents:
// their signs say which way dead time will act, where those of measured currents near zero are
// noise.
//
// An integrator stands still while its output is limited and the error would drive it further.
// Without `enable` voltages and integrators are 0, so that control begins from rest.
//
//     currents, voltages     s0.15 of a full scale each; w: s0.15 of a full scale of the speed
//     x                      s0.27, so that small gains still integrate
//     k_p, k_i               u3.12, u0.15;   w L, w K_E per unit: u5.10
//     latency                one sample
//     multipliers            34 products of 16 x 16 bits
//
// Doc: docs/blocks/current_control.md   Test: tests/hls/current_control_test.cpp

#pragma once

#include "hls/numeric/bits.hpp"
#include "hls/sinusoidal/sine.hpp"

namespace steplock {

class CurrentControl {
 public:
  struct In {
    bool enable = false;      // false: no voltage, integrators at 0
    Int<16> i_u = 0;          // s0.15
    Int<16> i_v = 0;          // s0.15
    UInt<16> angle = 0;       // u0.16, electrical turns, of the gamma axis at the sample
    UInt<16> ahead = 0;       // u0.16, electrical turns, of the gamma axis when the voltage acts
    Int<16> speed = 0;        // s0.15
    Int<16> set_gamma = 0;    // s0.15
    Int<16> set_delta = 0;    // s0.15
    UInt<15> k_p = 0;         // u3.12
    UInt<15> k_i = 0;         // u0.15, per sample
    UInt<15> inductance = 0;  // u5.10, voltage per current and speed
    UInt<15> emf = 0;         // u5.10, voltage per speed
    UInt<12> v_dc = 0;        // u0.12
    UInt<15> limit = 0;       // u0.15, length of the voltage vector, of the dc voltage
  };

  struct Out {
    Int<16> v_alpha = 0;   // s0.15
    Int<16> v_beta = 0;    // s0.15
    Int<16> i_gamma = 0;   // s0.15
    Int<16> i_delta = 0;   // s0.15
    Int<16> wanted_u = 0;  // s0.15, phase currents asked for, when the voltage acts
    Int<16> wanted_v = 0;  // s0.15
    bool limited = false;  // the voltage would have been longer
  };

  Out tick(const In& in) {
    const auto [sine, cosine] = sine_cosine(in.angle);
    const Int<16> alpha = in.i_u;
    const auto beta = saturate<Int<16>>(((in.i_v + in.i_v + in.i_u) * kInverseRoot3) >> 15);
    const auto i_gamma = rounded(alpha * cosine + beta * sine);
    const auto i_delta = rounded(beta * cosine - alpha * sine);

    const auto coupling = saturate<Int<16>>((in.speed * in.inductance + (1 << 9)) >> 10);
    const auto emf = saturate<Int<16>>((in.speed * in.emf + (1 << 9)) >> 10);
    const auto limit = wrap<UInt<15>>((in.v_dc * in.limit) >> 12);
    const auto gamma = control(integral_gamma_, in, saturate<Int<16>>(in.set_gamma - i_gamma),
                               -rounded(coupling * i_delta), wrap<UInt<15>>(limit - (limit >> 2)));
    const auto length = gamma.voltage.negative() ? -gamma.voltage : Int<17>(gamma.voltage);
    const Int<22> one = length;
    const auto eight = one << 3, nine = wrap<Int<22>>(eight + one);
    const auto thirteen = wrap<Int<22>>(nine + (one << 2));
    const auto near = wrap<Int<22>>(limit - (nine >> 6));
    const auto far = wrap<Int<22>>(limit + (limit >> 4) - (thirteen >> 5));
    const auto last = wrap<Int<22>>(limit + (limit >> 2) - (thirteen >> 4));
    const auto left = min(near, min(far, last));
    const auto delta = control(integral_delta_, in, saturate<Int<16>>(in.set_delta - i_delta),
                               rounded(coupling * i_gamma) + emf, saturate<UInt<15>>(left));

    const auto [sine_then, cosine_then] = sine_cosine(in.ahead);
    const auto ask_alpha = rounded(in.set_gamma * cosine_then - in.set_delta * sine_then);
    const auto ask_beta = rounded(in.set_gamma * sine_then + in.set_delta * cosine_then);
    const auto side = (ask_beta * kHalfRoot3 + (1 << 14)) >> 15;
    return {.v_alpha = rounded(gamma.voltage * cosine_then - delta.voltage * sine_then),
            .v_beta = rounded(gamma.voltage * sine_then + delta.voltage * cosine_then),
            .i_gamma = i_gamma,
            .i_delta = i_delta,
            .wanted_u = ask_alpha,
            .wanted_v = saturate<Int<16>>(side - (ask_alpha >> 1)),
            .limited = gamma.limited || delta.limited};
  }

 private:
  using Integral = Int<28>;  // s0.27
  static constexpr Int<16> kInverseRoot3 = 18919;  // s0.15
  static constexpr Int<16> kHalfRoot3 = 28378;    // s0.15

  static Int<22> min(Int<22> a, Int<22> b) { return a < b ? a : b; }

  struct Axis {
    Int<16> voltage = 0;
    bool limited = false;
  };

  // s.30 to s0.15.
  template <int W>
  static Int<16> rounded(Int<W> product) {
    return saturate<Int<16>>((product + (1 << 14)) >> 15);
  }

  template <int W>
  static Axis control(Integral& integral, const In& in, Int<16> error, Int<W> ahead,
                      UInt<15> limit) {
    const auto moved = saturate<Integral>(integral + ((error * in.k_i) >> 3));
    const auto wanted = (moved >> 12) + ((error * in.k_p) >> 12) + ahead;
    const bool above = wanted > limit;
    const bool below = wanted < -limit;
    if (!in.enable) {
      integral = 0;
      return {};
    }
    // Further in the direction of the limit it would only have to come back.
    if (!(above && !error.negative()) && !(below && error.negative())) integral = moved;
    if (above) return {wrap<Int<16>>(Int<17>(limit)), true};
    if (below) return {wrap<Int<16>>(-limit), true};
    return {wrap<Int<16>>(wanted), false};
  }

  Integral integral_gamma_ = 0;  // s0.27, voltage
  Integral integral_delta_ = 0;  // s0.27, voltage
};

}  // namespace steplock
