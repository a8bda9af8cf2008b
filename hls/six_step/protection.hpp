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
// The first four end a try (`lost`), the last two end the drive (`fatal`), whatever it is doing.
//
//     latency      none: the verdict stands in the clock of its cause
//     registers    24 bits     multipliers  none
//
// Doc: docs/blocks/protection.md   Test: tests/hls/protection_test.cpp

#pragma once

#include "hls/numeric/bits.hpp"
#include "hls/six_step/words.hpp"

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
    ProtectionWords words;
  };

  struct Out {
    bool lost = false;            // give up this try
    bool fatal = false;           // latch a fault, in any state
    Reason reason = Reason::kNone;
    bool freewheel_long = false;  // strobe: the step that ended freewheeled for too long
  };

  Out tick(const In& in) {
    const bool freewheels_long = in.freewheel > in.words.freewheel;

    Out out;
    out.freewheel_long = in.commutate && freewheels_long;
    if (in.running) {
      watch_steps(in);
      if (in.tick) watch_time(in, in.slips || freewheels_long);
    } else {
      score_ = 0;
      slow_ = 0;
      wrong_ = in.words.wrong_lock;
      hall_ = 0;
    }

    const bool over_current = in.words.over_current != 0 && in.stuck >= in.words.over_current;
    const bool step_out = in.words.misses != 0 && score_ >= in.words.misses;
    const bool stall = slow_ == 6;
    const bool wrong = in.words.wrong_lock != 0 && wrong_ == 0;
    const bool hall = hall_ == 2;
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
    const bool far = in.update && !in.good && !in.hall;
    if (in.missed || far) {
      score_ = wrap<UInt<7>>(score_ + (in.missed && in.lags ? UInt<3>(4) : UInt<3>(1)));
    } else if (in.good && score_ != 0) {
      score_ = wrap<UInt<7>>(score_ - 1);
    }
    if (in.commutate) {
      if (!in.slow) {
        slow_ = 0;
      } else if (slow_ != 6) {
        slow_ = wrap<UInt<3>>(slow_ + 1);
      }
    }
  }

  void watch_time(const In& in, bool wrong) {
    if (wrong) {
      wrong_ = wrong_ > 2 ? wrap<Ticks>(wrong_ - 2) : Ticks(0);
    } else if (wrong_ < in.words.wrong_lock) {
      wrong_ = wrap<Ticks>(wrong_ + 1);
    }
    if (!in.hall || !in.hall_illegal) {
      hall_ = 0;
    } else if (hall_ != 2) {
      hall_ = wrap<UInt<2>>(hall_ + 1);
    }
  }

  UInt<7> score_ = 0;  // of missed and far crossings
  UInt<3> slow_ = 0;   // slow steps in a row
  Ticks wrong_ = Ticks::max();  // ticks left of those that may look like a wrong lock
  UInt<2> hall_ = 0;   // ticks in a row with an illegal code
};

}  // namespace steplock
