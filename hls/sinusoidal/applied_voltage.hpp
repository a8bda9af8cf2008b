// The voltage that the bridge applied over one PWM period, from what it was asked for; never
// measured.
//
//     t_k = on_k - s_k dead       s_k = sign of the current out of leg k, in proportion within
//                                 one step of a 12-bit ADC
//     v_alpha = (2 t_u - t_v - t_w) v_dc / (3 period)
//     v_beta = sqrt 3 (t_v - t_w) v_dc / (3 period)
//
// The diode that takes over at each dead time holds the terminal low while the current flows into
// the motor, high otherwise.  A leg that does not switch loses nothing.  `dead` holds the diode's
// drop as well, as the clocks that cost the same at the nominal dc voltage.
//
//     on, period   clocks          dead   u8.4 clocks        v_dc   u0.12 of the full scale
//     inverse      u0.25: 1 / (3 period), for a period of 342 clocks or more
//     multipliers  4 products, and 3 small ones for s_k dead
//
// Doc: docs/blocks/current_model.md   Test: tests/hls/current_model_test.cpp

#pragma once

#include "hls/numeric/bits.hpp"

namespace steplock {

using LegClocks = UInt<14>;   // on-time of a leg within the period
using DeadClocks = UInt<12>;  // u8.4, clocks

// s_k dead in s9.4 clocks; `current` in s0.15, of which an ADC's step is 16 places.
template <int W>
Int<14> dead_clocks(Int<W> current, DeadClocks dead) {
  const bool above = current > 16, below = current < -16;
  const Int<6> sign = above ? Int<6>(16) : below ? Int<6>(-16) : wrap<Int<6>>(current);
  return wrap<Int<14>>((sign * dead) >> 4);
}

struct AppliedVoltage {
  Int<16> alpha = 0;  // s0.15
  Int<16> beta = 0;   // s0.15
};

struct AppliedPattern {
  LegClocks on_u = 0;     // clocks
  LegClocks on_v = 0;     // clocks
  LegClocks on_w = 0;     // clocks
  LegClocks period = 0;   // clocks
  DeadClocks dead = 0;    // u8.4, clocks
  UInt<15> inverse = 0;   // u0.25
};

// Currents and dc voltage are sums of both ends of the period.
inline AppliedVoltage applied_voltage(const AppliedPattern& p, Int<17> twice_u, Int<17> twice_v,
                                      UInt<13> twice_dc) {
  const auto leg = [&](LegClocks on, Int<18> twice_current) {
    const bool switches = on != 0 && on < p.period;
    const auto asked = UInt<18>(on) << 4;
    return asked - (switches ? dead_clocks(twice_current >> 1, p.dead) : Int<14>(0));
  };
  const auto u = leg(p.on_u, twice_u);
  const auto v = leg(p.on_v, twice_v);
  const auto w = leg(p.on_w, wrap<Int<18>>(-(twice_u + twice_v)));
  const auto per_clock = wrap<UInt<15>>((twice_dc * p.inverse + (1 << 12)) >> 13);  // s0.15, 2^-14
  const auto across = wrap<Int<20>>(v - w);
  constexpr Int<16> kRoot3 = 28378;  // s1.14
  const auto beta = wrap<Int<21>>((across * kRoot3 + (1 << 13)) >> 14);
  const auto alpha = wrap<Int<21>>(u + u - v - w);
  return {saturate<Int<16>>((alpha * per_clock + (1 << 13)) >> 14),
          saturate<Int<16>>((beta * per_clock + (1 << 13)) >> 14)};
}

}  // namespace steplock
