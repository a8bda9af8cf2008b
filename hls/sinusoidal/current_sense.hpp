// Current sense: the ADCs' codes to currents without offset, and over-current.
//
//     calibrate   the mean of 16 samples is the offset; `measured` when it stands
//     else        i = code - offset, taken with `valid`, limited to the format
//     over        |i_u|, |i_v| or |i_w| beyond the limit, with i_w = -i_u - i_v
//
// The sum of 16 codes of s0.11 is their mean in s0.15: no division, no shift.
//
//     latency      1 clock from valid to taken and the currents
//     registers    83 bits     multipliers  none
//
// Doc: docs/blocks/current_sense.md   Test: tests/hls/current_sense_test.cpp

#pragma once

#include "hls/numeric/bits.hpp"

namespace steplock {

class CurrentSense {
 public:
  struct Codes {
    bool valid = false;  // one clock: the codes are of a new sample
    Int<12> u = 0;       // s0.11, current of phase u
    Int<12> v = 0;       // s0.11, current of phase v
    UInt<12> dc = 0;     // u0.12, dc voltage
  };

  struct In {
    Codes codes;
    bool calibrate = false;     // gates are off: samples are offsets
    UInt<15> over_current = 0;  // u0.15
  };

  struct Out {
    bool taken = false;     // one clock: a sample has been taken
    bool measured = false;  // the offsets of this calibration stand
    bool over = false;      // a current is beyond the limit
    Int<16> i_u = 0;        // s0.15
    Int<16> i_v = 0;        // s0.15
    UInt<12> v_dc = 0;      // u0.12
  };

  Out tick(const In& in) {
    const auto i_w = i_u_ + i_v_;
    const auto beyond = [&](auto i) { return i > in.over_current || i < -in.over_current; };
    const Out out{.taken = taken_,
                  .measured = samples_.bit(4),
                  .over = beyond(i_u_) || beyond(i_v_) || beyond(i_w),
                  .i_u = i_u_,
                  .i_v = i_v_,
                  .v_dc = v_dc_};
    taken_ = in.codes.valid;
    if (in.codes.valid) {
      i_u_ = in.calibrate ? Int<16>(0) : less(in.codes.u, offset_u_);
      i_v_ = in.calibrate ? Int<16>(0) : less(in.codes.v, offset_v_);
      v_dc_ = in.codes.dc;
    }
    if (!in.calibrate) {
      samples_ = 0;
    } else if (in.codes.valid && !out.measured) {
      const bool first = samples_ == 0;
      offset_u_ = wrap<Int<16>>((first ? Int<16>(0) : offset_u_) + in.codes.u);
      offset_v_ = wrap<Int<16>>((first ? Int<16>(0) : offset_v_) + in.codes.v);
      samples_ = wrap<UInt<5>>(samples_ + 1);
    }
    return out;
  }

 private:
  static Int<16> less(Int<12> code, Int<16> offset) {
    return saturate<Int<16>>((Int<16>(code) << 4) - offset);
  }

  Int<16> offset_u_ = 0;  // s0.15
  Int<16> offset_v_ = 0;  // s0.15
  Int<16> i_u_ = 0;       // s0.15
  Int<16> i_v_ = 0;       // s0.15
  UInt<12> v_dc_ = 0;     // u0.12
  UInt<5> samples_ = 0;   // of this calibration, up to 16
  bool taken_ = false;
};

}  // namespace steplock
