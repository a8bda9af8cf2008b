// BEMF comparator logic: finds the zero crossing of the floating phase.
//
//     level = comparator of the floating phase, in the sense "after the crossing"
//
// After a commutation the old current freewheels and clamps the floating terminal to a rail, where
// the comparator shows the level of after the crossing (demagnetisation).  So the filter is preset to
// "after", and the level from before must be seen first; where that happens is the end of the
// freewheeling.  The filter counts samples up and down between 0 (before) and `samples` (after).
//
// A sample is taken `blanking` clocks after each edge of the chopped gate and after each commutation,
// and then every `sample_every` clocks, where the sampling mode allows the state of that gate.
//
// The crossing's place is the middle between the last sample of before and the first sample of after,
// in turns of the step: what the filter waits for afterwards costs no time, and a gap in the samples
// (blanking, off-time) is halved instead of added.
//
//     latency      1 clock after the sample that decides
//     registers    71 bits     multipliers  none
//
// Doc: docs/blocks/bemf_comparator.md   Test: tests/hls/bemf_comparator_test.cpp

#pragma once

#include "hls/numeric/bits.hpp"
#include "hls/six_step/config.hpp"

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
    BemfConfig config = {};
  };

  struct Out {
    bool crossing = false;     // one clock, once in a step at most
    Phase crossing_phase = 0;  // u0.16, where in the step it was
    bool before_seen = false;  // the level from before the crossing showed in this step
    Phase freewheel = 0;       // u0.16, where freewheeling last ended in its step; all ones: it did not
    bool operator==(const Out&) const = default;
  };

  Out tick(const In& in) {
    // Seen together with the commutation that ends the step, already.
    const bool endless = in.commutate && !before_seen_;
    const Out out{.crossing = crossing_,
                  .crossing_phase = place_,
                  .before_seen = before_seen_,
                  .freewheel = endless ? Phase::max() : freewheel_};

    const bool edge = in.chop != chop_ || in.commutate;
    const bool due = due_;
    due_ = edge ? in.config.blanking < 2 : due ? in.config.sample_every < 2 : left_ == 2;
    left_ = edge  ? in.config.blanking
            : due ? UInt<10>(in.config.sample_every)
                  : wrap<UInt<10>>(left_ - 1);
    chop_ = in.chop;

    const bool is_after = after(in);
    floating_ = floating(in);  // a commutation's own clock takes no sample: there is time to look its step up
    crossing_ = false;
    if (in.commutate) {
      count_ = full(in);
      before_seen_ = found_ = false;
      if (endless) freewheel_ = Phase::max();
    } else if (due && !edge && allowed(in) && !found_) {
      take(in, full(in), is_after);
    }
    return out;
  }

  // Quiet clocks (docs/theory.md): until this block does more than count, and that many at once.
  // Samples that only confirm what the filter holds are no event; skip() tells in which of the
  // skipped clocks, from 1, the last of them was whose phase has to be remembered, or 0.
  std::uint64_t quiet(const In& in) const {
    const bool confirms = found_ || !allowed(in) || (after(in) ? count_ == full(in) && !before_seen_ : count_ == 0 && before_seen_);
    return confirms ? ~std::uint64_t{0} : left_ < 2 ? 0 : left_.raw() - 1;
  }
  std::uint64_t skip(const In& in, std::uint64_t clocks) {
    const std::uint64_t first = left_ < 2 ? 1 : left_.raw();
    if (clocks < first) {
      left_ = UInt<10>::of(left_.raw() - clocks);
      due_ = left_ < 2;
      return 0;
    }
    const std::uint64_t every = in.config.sample_every < 2 ? 1 : in.config.sample_every.raw();
    const std::uint64_t since = (clocks - first) % every;
    left_ = UInt<10>::of(in.config.sample_every.raw() - since);
    due_ = left_ < 2;
    return allowed(in) && !found_ && !after(in) ? clocks - since : 0;
  }
  void remember(Phase phase) { before_ = phase; }
  bool operator==(const BemfComparator&) const = default;

 private:
  static bool allowed(const In& in) {
    return in.config.sampling == Sampling::kBoth ||
           (in.config.sampling == Sampling::kOnTime) == in.chop;
  }
  static UInt<4> full(const In& in) {
    return in.config.samples == 0 ? UInt<4>(1) : in.config.samples;
  }

  // The floating phase of a step, and whether its crossing rises: in the odd steps, and in the even ones when
  // the rotor turns backwards.
  struct Floating {
    bool u = false;
    bool v = false;
    bool w = false;
    bool rises = false;
    bool operator==(const Floating&) const = default;
  };
  static Floating floating(const In& in) {
    return {.u = in.step != 0 && in.step != 3 && in.step != 1 && in.step != 4,
            .v = in.step == 1 || in.step == 4,
            .w = in.step == 0 || in.step == 3,
            .rises = in.step.bit(0) != in.reverse};
  }
  bool after(const In& in) const {
    return ((floating_.u && in.u) || (floating_.v && in.v) || (floating_.w && in.w)) == floating_.rises;
  }

  void take(const In& in, UInt<4> full, bool after) {
    if (after) {
      // At its end or beyond: 15 is the end of whatever words came while it counted.
      const bool last = count_ == wrap<UInt<4>>(full - 1) || count_ == full || count_ == UInt<4>::max();
      if (count_ == 0) place_ = (before_ + in.phase).slice<16, 1>();
      count_ = last ? full : wrap<UInt<4>>(count_ + 1);
      crossing_ = found_ = before_seen_ && last;
    } else {
      if (count_ <= 1) {
        before_ = in.phase;
        if (!before_seen_) freewheel_ = in.phase;
        before_seen_ = true;
      }
      if (count_ != 0) count_ = wrap<UInt<4>>(count_ - 1);
    }
  }

  bool due_ = true;           // left_ is 0 or 1
  Floating floating_;         // of the step, a clock ago
  UInt<10> left_ = 0;         // clocks to the next sample
  bool chop_ = false;         // chop in the last clock
  UInt<4> count_ = 0;         // the filter: 0 is before the crossing
  bool before_seen_ = false;  // the filter reached 0 in this step
  bool found_ = false;        // the crossing of this step
  bool crossing_ = false;     // one clock after the sample that decided
  Phase before_ = 0;          // u0.16, last sample that left the filter at 0
  Phase place_ = 0;           // u0.16, middle of that one and the one after
  Phase freewheel_ = 0;       // u0.16, first sample that brought the filter to 0
};

}  // namespace steplock
