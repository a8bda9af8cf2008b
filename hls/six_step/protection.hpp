// Protection: says when a lock is no longer one, and what must end the drive at once.
//
//     step-out     score + 4 per step that ended on the level before its crossing, + 1 per one that
//                  never showed that level or whose crossing is far from its place, - 1 per good
//                  one, at `misses`.  Those that never show it weigh less: long freewheeling and
//                  slow PWM hide crossings of a rotor that follows, up to half of them for good.  A
//                  comparator that is stuck misses one of either kind per turn, which climbs:
//                  4 + 1 > 4 * 1.
//                  Far ones count since a rotor that stands shows some, too: the decay of the
//                  commutated current, then noise
//     stall        six steps in a row slower than `stall`
//     wrong lock   a stable lock on a wrong edge keeps its phase error small; it shows in current
//                  (duty - duty of the back-EMF > slip: voltage that only resistance can take) or
//                  in the interval (freewheeling longer than `freewheel` of a step).  Of `wrong_lock`
//                  ticks a wrong one takes two, a right one gives one back: the VCO swings about an
//                  edge that follows each commutation of a rotor at rest, and half of its steps look
//                  right
//     Hall code    all three alike for two ticks
//     over-current the limit's comparator was never released in `over_current` hits in a row
//     fault pin    as it comes
//
// The first four end an attempt (`lost`), the last two end the drive (`fatal`), whatever it is doing.
//
//     latency      none: the verdict stands in the clock of its cause; on strobes in clocks in a row up to two later
//     registers    35 bits     multipliers  none
//
// Law: hls/six_step/protection_law.hpp   Doc: docs/blocks/protection.md   Test: tests/hls/protection_test.cpp

#pragma once

#include "hls/numeric/bits.hpp"
#include "hls/six_step/config.hpp"

namespace steplock {

class Protection {
 public:
  struct In {
    bool running = false;       // locked and under speed control
    bool tick = false;          // time base of the wrong-lock test
    bool commutate = false;     // a new step began
    bool update = false;        // strobe: a step had its crossing, or ended without
    bool good = false;          // with `update`: a crossing near its place
    bool missed = false;        // with `update`: a step without a crossing
    bool lags = false;          // with `missed`: the step ended on the level before
    bool slow = false;          // the VCO's frequency is below `stall`
    bool slips = false;         // the duty is more than the back-EMF explains
    Phase freewheel = 0;        // u0.16, of the present or last step
    UInt<4> stuck = 0;          // hits of the current limit whose comparator was never released
    bool fault_pin = false;     // synchronised
    bool hall = false;          // steps come from the Hall sensors
    bool hall_illegal = false;  // their code is 000 or 111
    ProtectionConfig config;
  };

  struct Out {
    bool lost = false;            // give up this attempt
    bool fatal = false;           // latch a fault, in any state
    Reason reason = Reason::kNone;
    bool freewheel_long = false;  // strobe: the step that ended freewheeled for too long
  };

  Out tick(const In& in) {
    const bool freewheels_long = in.freewheel > in.config.freewheel;

    Out out;
    out.freewheel_long = in.commutate && freewheels_long;
    // What this step adds is known late in the clock, and waits for the next one; the verdict does not.
    const bool strikes = in.missed || (in.update && !in.good && !in.hall);
    const bool heavy = in.missed && in.lags;
    const bool step_out = in.running && (ended_ || (heavy && four_end_) || (strikes && one_ends_));
    ended_ = in.config.misses != 0 && score_ >= in.config.misses;
    four_end_ = in.config.misses != 0 && score_ + 4 >= in.config.misses;
    one_ends_ = in.config.misses != 0 && score_ + 1 >= in.config.misses;
    const bool wrong_tick = in.tick && (in.slips || long_);
    const bool wrong = in.running && in.config.wrong_lock != 0 && (none_left_ || (wrong_tick && few_left_));
    const bool stall = in.running && (slow_ == 6 || (in.commutate && in.slow && slow_ == 5));
    const bool no_code = in.tick && in.hall && in.hall_illegal;
    const bool hall = in.running && ((hall_ == 2 && !in.tick) || (no_code && hall_ != 0));
    const bool none_left = wrong_ == 0;
    const bool few_left = wrong_ <= 2;
    const bool all_left = wrong_ >= in.config.wrong_lock;
    if (in.running) {
      const bool pays = strikes_ == 0 && credit_ && score_ != 0;
      score_ = wrap<UInt<7>>(score_ + (pays ? UInt<7>::max() : UInt<7>(strikes_)));
      strikes_ = heavy ? UInt<3>(4) : UInt<3>(strikes);
      credit_ = in.good;
      watch_steps(in);
      if (in.tick) watch_time(in);
    } else {
      score_ = 0;
      strikes_ = 0;
      credit_ = false;
      slow_ = 0;
      hall_ = 0;
    }

    watch_lock(in);
    long_ = freewheels_long;
    none_left_ = none_left;
    few_left_ = few_left;
    all_left_ = all_left;
    const bool over_current = in.config.over_current != 0 && in.stuck >= in.config.over_current;
    out.fatal = in.fault_pin || over_current;
    out.lost = step_out || stall || wrong || hall;
    out.reason = in.fault_pin   ? Reason::kFaultPin
                 : over_current ? Reason::kOverCurrent
                 : step_out     ? Reason::kStepOut
                 : stall        ? Reason::kStall
                 : wrong        ? Reason::kWrongLock
                 : hall         ? Reason::kHallCode
                                : Reason::kNone;
    return out;
  }

  bool operator==(const Protection&) const = default;

 private:
  void watch_steps(const In& in) {
    if (in.commutate) {
      if (!in.slow) {
        slow_ = 0;
      } else if (slow_ != 6) {
        slow_ = wrap<UInt<3>>(slow_ + 1);
      }
    }
  }

  // One adder loads, takes two away and gives one back; all bits have one reset (docs/theory.md).
  void watch_lock(const In& in) {
    const bool wrong = in.slips || long_;
    const Ticks change = !in.running ? in.config.wrong_lock : wrong ? wrap<Ticks>(~Ticks(1)) : Ticks(1);
    if (in.running && in.tick && wrong && few_left_) {
      wrong_ = 0;
    } else if (!in.running || (in.tick && (wrong || !all_left_))) {
      wrong_ = wrap<Ticks>((in.running ? wrong_ : Ticks(0)) + change);
    }
  }

  void watch_time(const In& in) {
    if (!in.hall || !in.hall_illegal) {
      hall_ = 0;
    } else if (hall_ != 2) {
      hall_ = wrap<UInt<2>>(hall_ + 1);
    }
  }

  UInt<7> score_ = 0;     // of missed and far crossings, but for the last
  UInt<3> strikes_ = 0;   // the last one's
  bool credit_ = false;   // the last one was good
  bool ended_ = false;    // the score is enough
  bool one_ends_ = false;   // one more would be
  bool four_end_ = false;   // four more would be
  bool long_ = false;     // freewheeling stood for too long a clock ago
  UInt<3> slow_ = 0;   // slow steps in a row
  Ticks wrong_ = Ticks::max();  // ticks left of those that may look like a wrong lock
  bool none_left_ = false;  // wrong_ a clock ago, which ticks are long enough apart for: 0
  bool few_left_ = false;   // 2 or less
  bool all_left_ = true;    // all of them
  UInt<2> hall_ = 0;   // ticks in a row with an illegal code
};

}  // namespace steplock
