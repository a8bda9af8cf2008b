// Protection, the law: what a step, a commutation and a tick do to its four counts, as equations.
//
// Protection adds up each of them one or two clocks later, with the verdict in the clock of its
// cause, and is held to this bit for bit, for strobes that are three clocks apart: the drive's are.
//
// Doc: docs/blocks/protection.md   Test: tests/hls/protection_law_test.cpp

#pragma once

#include "hls/six_step/protection.hpp"

namespace steplock {

struct ProtectionLaw {
  using In = Protection::In;

  // law
  UInt<7> score = 0;          // of lost crossings
  UInt<3> slow = 0;           // steps in a row, up to 6
  Ticks left = Ticks::max();  // ticks that may look like a wrong lock, until it is one
  UInt<2> codes = 0;          // ticks in a row with an illegal Hall code, up to 2

  Protection::Out clock(const In& in) {
    const auto& config = in.config;
    const bool freewheels_long = in.freewheel > config.freewheel;
    if (!in.running) {
      *this = ProtectionLaw{.left = config.wrong_lock};
    } else {
      if (in.update) score = wrap<UInt<7>>(score + weight(in));
      if (in.commutate) slow = in.slow ? up_to(slow, UInt<3>(6)) : UInt<3>(0);
      if (in.tick) codes = in.hall && in.hall_illegal ? up_to(codes, UInt<2>(2)) : UInt<2>(0);
      if (in.tick && (in.slips || freewheels_long)) {
        left = left > 2 ? wrap<Ticks>(left - 2) : Ticks(0);
      } else if (in.tick && left < config.wrong_lock) {
        left = wrap<Ticks>(left + 1);
      }
    }
    const bool step_out = in.running && config.misses != 0 && score >= config.misses;
    const bool wrong_lock = in.running && config.wrong_lock != 0 && left == 0;
    const bool over_current = config.over_current != 0 && in.stuck >= config.over_current;
    const Reason reason = in.fault_pin   ? Reason::kFaultPin
                          : over_current ? Reason::kOverCurrent
                          : step_out     ? Reason::kStepOut
                          : slow == 6    ? Reason::kStall
                          : wrong_lock   ? Reason::kWrongLock
                          : codes == 2   ? Reason::kHallCode
                                         : Reason::kNone;
    return {.lost = step_out || slow == 6 || wrong_lock || codes == 2,
            .fatal = in.fault_pin || over_current,
            .reason = reason,
            .freewheel_long = in.commutate && freewheels_long};
  }

 private:
  // A step that ended on the level before its crossing weighs 4, one that never showed that level
  // or whose crossing was far off 1; a good one takes 1 back.
  Int<4> weight(const In& in) const {
    if (in.missed) return in.lags ? 4 : 1;
    if (in.good) return score == 0 ? 0 : -1;
    return in.hall ? 0 : 1;
  }
  // end of law

  template <class Count>
  static Count up_to(Count count, Count most) {
    return count == most ? most : wrap<Count>(count + 1);
  }
};

}  // namespace steplock
