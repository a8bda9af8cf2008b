// BEMF comparator logic: finds the zero crossing of the floating phase.
//
//     level = comparator of the floating phase, in the sense "after the crossing"
//
// After a commutation the old current freewheels and clamps the floating terminal to a rail, where
// the comparator shows the level of after the crossing (demagnetisation).  So the filter is preset to
// "after", and the level from before must be seen first; where that happens is the end of the
// freewheeling.  Samples are taken every `sample_every` clocks where the sampling mode allows it and no
// edge of the chopped gate lies within `blanking` clocks.  The filter counts them up and down between
// 0 (before) and `samples` (after).
//
// The crossing's place is the middle between the last sample of before and the first sample of after,
// in turns of the step: what the filter waits for afterwards costs no time, and a gap in the samples
// (blanking, off-time) is halved instead of added.
//
//     latency      1 clock after the sample that decides
//     registers    about 85 bits     multipliers  none
//
// Doc: docs/blocks/bemf_comparator.md   Test: tests/hls/bemf_comparator_test.cpp

#pragma once

#include "hls/numeric/bits.hpp"
#include "hls/six_step/words.hpp"

namespace steplock {

class BemfComparator {
 public:
  struct In {
    bool u = false;          // synchronised comparators: terminal above the reference
    bool v = false;          // see u
    bool w = false;          // see u
    UInt<3> step = 0;        // 0 to 5
    bool reverse = false;    // direction of rotation
    bool commutate = false;  // one clock, the first of a new step
    bool chop = false;       // the chopped gate is meant to be on
    Phase phase = 0;         // u0.16, turns of this step
    BemfWords words;
  };

  struct Out {
    bool crossing = false;     // one clock
    Phase crossing_phase = 0;  // u0.16, where in the step it was
    bool before_seen = false;  // in this step, the level from before the crossing
    Phase freewheel = 0;       // u0.16, where freewheeling last ended in its step; all ones: it did not
    bool sample = false;       // strobe: time base of every filter on the pins
  };

  Out tick(const In& in) {
    const bool sample = interval_ == 0;
    interval_ = !sample                     ? wrap<UInt<8>>(interval_ - 1)
                : in.words.sample_every == 0 ? UInt<8>(0)
                                            : wrap<UInt<8>>(in.words.sample_every - 1);

    const bool allowed = in.words.sampling == Sampling::kBoth ||
                         (in.words.sampling == Sampling::kOnTime) == in.chop;
    const bool quiet = blank_ == 0 && in.chop == chop_ && !in.commutate;
    if (in.chop != chop_ || in.commutate) {
      blank_ = in.words.blanking;
    } else if (blank_ != 0) {
      blank_ = wrap<UInt<10>>(blank_ - 1);
    }
    chop_ = in.chop;

    crossing_ = false;
    if (in.commutate) {
      count_ = full(in.words);
      if (!before_seen_) freewheel_ = Phase::max();  // it never ended
      before_seen_ = false;
      found_ = false;
    } else if (sample && quiet && allowed && !found_) {
      take(in, after(in));
    }
    return {.crossing = crossing_,
            .crossing_phase = middle(),
            .before_seen = before_seen_,
            .freewheel = freewheel_,
            .sample = sample};
  }

 private:
  static UInt<4> full(const BemfWords& words) {
    return words.samples == 0 ? UInt<4>(1) : words.samples;
  }

  static bool after(const In& in) {
    const bool floating = in.step == 0 || in.step == 3   ? in.w
                          : in.step == 1 || in.step == 4 ? in.v
                                                         : in.u;
    // The crossing rises in the odd steps, and in the even ones when the rotor turns backwards.
    return floating == (in.step.bit(0) != in.reverse);
  }

  void take(const In& in, bool is_after) {
    if (is_after) {
      if (count_ == 0) first_after_ = in.phase;
      if (count_ < full(in.words)) count_ = wrap<UInt<4>>(count_ + 1);
      if (before_seen_ && count_ >= full(in.words)) crossing_ = found_ = true;
    } else {
      if (count_ != 0) count_ = wrap<UInt<4>>(count_ - 1);
      if (count_ == 0) {
        last_before_ = in.phase;
        if (!before_seen_) freewheel_ = in.phase;
        before_seen_ = true;
      }
    }
  }

  Phase middle() const { return (last_before_ + first_after_).slice<16, 1>(); }

  UInt<8> interval_ = 0;      // clocks to the next sample
  UInt<10> blank_ = 0;        // clocks of blanking still to come
  bool chop_ = false;         // in the last clock
  UInt<4> count_ = 0;         // the filter: 0 is before the crossing
  bool before_seen_ = false;
  bool crossing_ = false;
  bool found_ = false;        // one crossing per step
  Phase last_before_ = 0;     // u0.16, last sample with the filter at 0
  Phase first_after_ = 0;     // u0.16, sample that left 0 for the last time
  Phase freewheel_ = 0;
};

}  // namespace steplock
