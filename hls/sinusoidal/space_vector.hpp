// Space-vector modulator: a voltage vector to the on-clocks of three legs.
//
//     v_u = v_alpha,  v_v, v_w = (-v_alpha +- sqrt 3 v_beta) / 2
//     on_k = period (1/2 + (v_k - common) / v_dc) + s_k dead
//     common = (least + greatest) / 2, which gives v_dc / sqrt 3 a phase; 0 with `sine`
//
// s_k is the sign of the current out of leg k: so the pulse makes up for its dead time.  A wanted
// current has no noise, and its sign counts down to the last place; making up for less near zero lets
// a slow rotor swing.  On or off times below `minimum` become 0 % or 100 %, here and not only in the
// PWM generator, because the applied voltage is reconstructed from what comes out.
//
// With `hold` the legs of `hold_u`, `hold_v` and `hold_w` get `hold_voltage`, the others stay low: a pattern that
// turns the rotor to a known place.  One leg or two, the current's vector is of the same length.
//
// 1 / v_dc follows by one step of Newton a sample, r <- r (2 - v_dc r), which doubles its digits:
// from any dc voltage above an eighth of the full scale to the last place in ten samples.
//
//     voltages      s0.15, v_dc u0.12 of the full scale;  1 / v_dc  u3.12
//     clocks        u14.0, inside s.4;  dead  u8.4
//     multipliers   9 products of 16 x 16 bits
//
// Doc: docs/blocks/space_vector.md   Test: tests/hls/space_vector_test.cpp

#pragma once

#include "hls/numeric/bits.hpp"
#include "hls/sinusoidal/applied_voltage.hpp"

namespace steplock {

class SpaceVector {
 public:
  struct In {
    Int<16> v_alpha = 0;        // s0.15
    Int<16> v_beta = 0;         // s0.15
    Int<16> i_u = 0;            // s0.15, for its sign: the wanted current, or the measured one
    Int<16> i_v = 0;            // s0.15
    UInt<12> v_dc = 0;          // u0.12
    LegClocks period = 0;       // clocks
    LegClocks minimum = 0;      // clocks
    DeadClocks dead = 0;        // u8.4 clocks; 0: nothing to make up for
    bool sine = false;          // no zero component
    bool hold = false;          // legs of a pattern, not a vector
    bool hold_u = false;        // u is one of them
    bool hold_v = false;        // v is
    bool hold_w = false;        // w is
    UInt<15> hold_voltage = 0;  // u0.15
  };

  struct Out {
    LegClocks on_u = 0;  // clocks
    LegClocks on_v = 0;  // clocks
    LegClocks on_w = 0;  // clocks
  };

  Out tick(const In& in) {
    const UInt<15> v_dc = UInt<15>(in.v_dc) << 3;
    const auto rest = saturate<UInt<15>>((Int<32>(1 << 28) - v_dc * inverse_) >> 13);  // u1.14
    const auto better = saturate<UInt<15>>((inverse_ * rest + (1 << 13)) >> 14);
    inverse_ = better < kOne ? kOne : better;

    const auto half = Int<17>(in.v_alpha) >> 1;
    const auto side = (in.v_beta * kHalfRoot3 + (1 << 14)) >> 15;
    const Int<18> u = in.v_alpha, v = wrap<Int<18>>(side - half), w = wrap<Int<18>>(-side - half);
    const Int<18> least = min(u, min(v, w)), greatest = max(u, max(v, w));
    const Int<18> common = in.sine ? Int<18>(0) : wrap<Int<18>>((least + greatest) >> 1);
    const auto i_w = saturate<Int<16>>(-(in.i_u + in.i_v));
    const auto pick = [&](Int<18> voltage, bool holds) {
      const auto free = saturate<Int<16>>(voltage - common);
      return !in.hold ? free : holds ? Int<16>(in.hold_voltage) : Int<16>(0);
    };
    return {.on_u = leg(in, pick(u, in.hold_u), in.i_u),
            .on_v = leg(in, pick(v, in.hold_v), in.i_v),
            .on_w = leg(in, pick(w, in.hold_w), i_w)};
  }

 private:
  static constexpr UInt<15> kOne = 4096;        // u3.12
  static constexpr Int<16> kHalfRoot3 = 28378;  // s0.15

  static Int<18> min(Int<18> a, Int<18> b) { return a < b ? a : b; }
  static Int<18> max(Int<18> a, Int<18> b) { return a < b ? b : a; }

  LegClocks leg(const In& in, Int<16> voltage, Int<16> current) const {
    const auto share = saturate<Int<16>>((voltage * inverse_ + (1 << 11)) >> 12);
    const auto clocks = wrap<Int<20>>((share * in.period) >> 11);  // s15.4
    const auto middle = in.hold ? UInt<17>(0) : UInt<17>(in.period) << 3;
    const auto made_up = current.negative() ? Int<13>(-in.dead) : current == Int<16>(0) ? Int<13>(0) : Int<13>(in.dead);
    const auto exact = clocks + middle + made_up + 8;
    const auto on = exact >> 4;
    const bool none = on < in.minimum, all = in.period - on < in.minimum;
    return on.negative() || none ? LegClocks(0) : all ? in.period : wrap<LegClocks>(on);
  }

  UInt<15> inverse_ = 4096;  // u3.12, 1 / v_dc
};

}  // namespace steplock
