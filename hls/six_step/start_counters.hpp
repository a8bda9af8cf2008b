// Start counters: what the start sequence counts, and what follows from it.
//
//     timed_out          the state's time: n ticks, and the part of one before the first.  kPreAlign, kAlign and kAccelerate
//                        last twice as long after each failed attempt, three times.  Following a rotor takes 4 * 4096 over all
//                        attempts together, and ends after each 4096 in whose last quarter there was no hope: none of its eight
//                        parts in which the rotor moved from end to end.  One that is shaken in its place does so for moments
//     count_reached      `good_crossings` in a row; while a spin is detected, codes that went on in one direction
//     retries_exhausted  `retries` attempts failed: this one is the last; or it follows, and these ticks are over.  Both are
//                        forgotten in kIdle and after 1024 ticks of kRun
//     brakes_exhausted   255 braking intervals: the rotor counts as unstoppable.  Forgotten in kIdle and kRun
//
// The state machine (start_sequence.hpp) tells the state, and when it is new.
//
//     latency      none from the tick to `timed_out`; 2 clocks from a strobe to `retries_exhausted` and `brakes_exhausted`,
//                  before which nothing asks for them; 1 to all others.  Ticks, and updates, are further apart than that
//     registers    56 bits     multipliers  none
//
// Doc: docs/blocks/start_counters.md   Test: tests/hls/start_counters_test.cpp

#pragma once

#include "hls/numeric/bits.hpp"
#include "hls/six_step/config.hpp"

namespace steplock {

class StartCounters {
 public:
  struct In {
    bool tick = false;           // the slow time base
    States state = State::kIdle;
    bool entered = false;        // this is the first clock of the state
    bool failed = false;         // strobe: an attempt failed
    bool braking = false;        // strobe: a braking interval begins
    bool update = false;         // strobe: the phase detector has a new error
    bool good = false;           // with `update`: it is a small one
    bool turns_reverse = false;  // while a spin is detected: the code last moved downwards
    bool hopeful = false;        // a follower has seen the rotor move, as it now believes it does
    StartConfig config;
  };

  struct Out {
    bool timed_out = false;          // with `tick`: the state's time
    bool count_reached = false;      // good crossings in a row, the last one in the clock before
    bool steady = false;             // one less, at least
    bool retries_exhausted = false;  // no more attempts are left
    bool brakes_exhausted = false;   // no more braking intervals are left
    bool turns_reverse = false;      // direction at the last update
    UInt<2> backoff = 0;             // failed attempts, as far as they make the next one gentler
    bool strong = false;             // two or more of them
  };

  Out tick(const In& in) {
    const Out out{.timed_out = in.tick && time_up_ && !in.entered,
                  .count_reached = count_reached_,
                  .steady = steady_,
                  .retries_exhausted = retries_exhausted_,
                  .brakes_exhausted = brakes_exhausted_,
                  .turns_reverse = turns_reverse_,
                  .backoff = backoff(),
                  .strong = retries_ > 1 && !follows(in)};
    const bool forgets = in.state.holds(State::kIdle) || (out.timed_out && in.state.holds(State::kRun));
    count_ticks(in, forgets);
    count_attempts(in, forgets);
    count_crossings(in);
    return out;
  }

  bool operator==(const StartCounters&) const = default;

 private:
  using Length = UInt<15>;  // Ticks, doubled up to three times

  static Length doubled(Ticks ticks, UInt<2> times) {
    const Length wide = ticks;
    const Length once = times.bit(0) ? wide << 1 : wide;
    return times.bit(1) ? once << 2 : once;
  }

  // Every attempt of such a start is the same.
  static bool follows(const In& in) { return in.config.method == Method::kFollow; }

  static Length length(const In& in, UInt<2> failed) {
    const auto when = [&in](State state, Length then) { return in.state.holds(state) ? then : Length(0); };
    return when(State::kDetectSpin, in.config.detect_spin) | when(State::kBrake, in.config.brake) |
           when(State::kPreAlign, doubled(in.config.pre_align, failed)) |
           when(State::kAlign, doubled(in.config.align, failed)) |
           when(State::kPullIn, in.config.pull_in) | when(State::kSlowDown, in.config.slow_down) |
           when(State::kRetryDelay, in.config.retry_delay) |
           when(State::kRun, 1024) |  // after that long earlier failures are forgotten
           // A ramp of 0 must end, too.
           when(State::kAccelerate, doubled(Ticks::max(), failed));
  }

  static bool following(const In& in) { return follows(in) && in.state.holds(State::kAccelerate); }

  void count_ticks(const In& in, bool forgets) {
    // A state's ticks are loaded in its first clock; a tick of that very clock counts in the next one.
    const bool ticks = (in.tick || late_) && !in.entered;
    late_ = in.tick && in.entered;
    const bool verdict = follows_.slice<11, 0>() == 0xfff;
    time_up_ = !in.entered && (following(in) ? follows_ == 0 || (verdict && !hopes_) : ticks_ == 0);
    // One that turns round is not believed to move for a moment: any part of the 1024 ticks before each verdict counts.
    const UInt<2> quarter = follows_.slice<11, 10>();
    const UInt<7> part = follows_.slice<6, 0>();
    hopes_ = quarter == 0 ? hopes_ || (part == 0 && lasts_) : quarter != 2 && hopes_;
    lasts_ = in.hopeful && (lasts_ || part == 0x7f);
    if (in.entered) {
      ticks_ = length(in, backoff());
    } else if (ticks && ticks_ != 0) {
      ticks_ = wrap<Length>(ticks_ - 1);
    }
    if (forgets) {
      follows_ = kFollows;
    } else if (ticks && following(in) && follows_ != 0) {
      follows_ = wrap<UInt<14>>(follows_ - 1);
    }
  }

  void count_attempts(const In& in, bool forgets) {
    retries_exhausted_ = retries_ >= in.config.retries || (following(in) && time_up_);
    if (forgets) {
      retries_ = 0;
    } else if (in.failed) {
      retries_ = wrap<UInt<4>>(retries_ + 1);
    }
    brakes_exhausted_ = brakes_ == kMostBrakes;
    if (in.state.holds_one_of(State::kIdle, State::kRun)) {
      brakes_ = 0;
    } else if (in.braking) {
      brakes_ = wrap<UInt<8>>(brakes_ + 1);
    }
  }

  void count_crossings(const In& in) {
    // While a spin is detected, changes that go on in the direction of the last one.
    const bool same = !in.state.holds(State::kDetectSpin) || in.turns_reverse == turns_reverse_;
    const bool counts = in.good && same;
    count_reached_ = in.update && counts && steady_ && !in.entered;
    steady_ = good_ + 1 >= in.config.good_crossings;
    if (in.entered) {
      good_ = 0;
    } else if (in.update) {
      good_ = counts ? wrap<UInt<6>>(good_ + 1) : UInt<6>(0);
      turns_reverse_ = in.turns_reverse;
    }
  }

  UInt<2> backoff() const { return retries_ > 3 ? UInt<2>(3) : wrap<UInt<2>>(retries_); }

  static constexpr int kMostBrakes = 255;
  static constexpr int kFollows = 0x3ffe;  // verdicts at 0x2fff and each 4096 further

  Length ticks_ = 0;            // left in this state
  bool late_ = false;           // there was a tick in the state's first clock
  UInt<14> follows_ = kFollows; // ticks left to follow a rotor, in all attempts
  bool time_up_ = false;        // no ticks are left, or none without a rotor that moves
  bool lasts_ = false;          // the rotor that is followed moved in this part of 128 ticks so far
  bool hopes_ = false;          // it did so throughout one of the last eight before a verdict
  UInt<4> retries_ = 0;         // failed attempts
  bool retries_exhausted_ = false;  // no more are left
  UInt<8> brakes_ = 0;          // braking intervals of this stop
  bool brakes_exhausted_ = false;   // no more are left
  UInt<6> good_ = 0;            // good crossings in a row
  bool steady_ = false;         // one more is enough
  bool count_reached_ = false;  // that one came in the last clock
  bool turns_reverse_ = false;  // direction at the last update
};

}  // namespace steplock
