// Open-loop duty: the torque of a start, before speed control has a say.
//
//     kPreAlign, kAlign  align_duty        twice that with `strong`, up to 100 %
//     kAccelerate        start_duty        likewise
//       following        align_duty until the rotor is followed, then start_duty, then a part: see below
//     kPullIn            start_duty, which fades by 1/32 per step
//       following        the same part of start_duty, until speed control takes over
//     kBrake             brake_duty, from which speed control takes the back-EMF's
//     all others         0
//
// Pulling in, the start's torque fades: with all of it the rotor would keep its lead on the VCO and run
// away from the loop.  A rotor that lags has too little torque and gets 1/32 more per step, up to the
// start's: a heavy load would stop it else.
//
// A rotor that is followed and has hand-over's frequency gets a sixteenth above its back-EMF: what is measured then is a
// speed that lasts, and the PLL finds a rotor that hardly accelerates.  With nothing a light one under load falls back.  One that
// falls back all the same, since its flux is more or its bus less than the words', gets a quarter from then on.  Until the next step
// it gets half of the start's: with all of it a light one, at hand-over's frequency again, is nearly twice as fast by then.
//
// The first interval that is measured spans the start's torque: it may be longer than hand-over's while the rotor is faster.
// So what falls back after just that one gets the half, but no quarter: a light one on a bus above the words' would not stop at
// the set speed.  A heavy one passes no edge in that time, and gets both.
//
//     latency      1 clock from state to duty
//     registers    22 bits     multipliers  none
//
// Doc: docs/blocks/open_loop_duty.md   Test: tests/hls/open_loop_duty_test.cpp

#pragma once

#include "hls/numeric/bits.hpp"
#include "hls/six_step/config.hpp"

namespace steplock {

class OpenLoopDuty {
 public:
  struct In {
    States state = State::kIdle;
    bool strong = false;     // two attempts failed
    bool follows = false;    // the start follows the rotor
    bool sure = false;       // and has it
    bool fast = false;       // and has the frequency of hand-over
    bool commutate = false;  // strobe: a new step began
    bool lags = false;       // the last error was negative: the rotor lags the VCO
    Duty align_duty = 0;     // u1.15
    Duty start_duty = 0;     // u1.15
    Duty brake_duty = 0;     // u1.15
  };

  struct Out {
    Duty duty = 0;  // u1.15, of the state a clock ago
  };

  // `strong` leaves out an attempt that fails in this clock: that ends the pulling in, and waiting for the
  // verdict would make this the longest path of the drive.
  Out tick(const In& in) {
    const Out out{.duty = duty_};
    const Duty start = stronger(in.start_duty, in.strong);
    const bool faded = duty_ < start;
    const bool pulls_in = in.state.holds(State::kPullIn), accelerates = in.state.holds(State::kAccelerate);
    const Duty part = duty_ >> 5;
    if (pulls_in && !in.follows) {
      if (in.commutate && (!in.lags || faded_)) {
        // One adder for both directions: the 1 that the complement lacks is carried in from a bit below.
        const UInt<17> change = UInt<17>(in.lags ? part : wrap<Duty>(~part)) << 1 | UInt<17>(!in.lags);
        duty_ = wrap<Duty>(((UInt<17>(duty_) << 1 | UInt<17>(1)) + change) >> 1);
      }
    } else {
      const bool fast = accelerates && in.follows && in.sure && in.fast;
      const bool falls = was_fast_ && !fast && accelerates;
      fell_ = in.follows && (pulls_in || accelerates) && (fell_ || (falls && (lasted_ || !began_)));
      eases_ = falls || (eases_ && accelerates && !in.commutate);
      lasted_ = fast && (lasted_ || (began_ && in.commutate));
      began_ = fast && (began_ || in.commutate);
      was_fast_ = fast;
      duty_ = pulls_in || fast                                       ? fell_ ? start >> 2 : start >> 4
              : accelerates && in.follows && !in.sure                ? in.align_duty
              : accelerates                                          ? eases_ ? start >> 1 : start
              : in.state.holds_one_of(State::kPreAlign, State::kAlign) ? stronger(in.align_duty, in.strong)
              : in.state.holds(State::kBrake)                        ? in.brake_duty
                                                                     : Duty(0);
    }
    faded_ = faded;
    return out;
  }

  bool operator==(const OpenLoopDuty&) const = default;

 private:
  // Two failed attempts: bus, flux or resistance may be weaker than the words' motor; the limit stands.  No bus
  // has more than 100 %, and what a rotor that lags gets more than that does not pass the word's end.
  static Duty stronger(Duty duty, bool strong) {
    if (!strong) return duty;
    return duty.bit(15) || duty.bit(14) ? kWhole : duty << 1;
  }

  static constexpr Duty kWhole = 0x8000;

  Duty duty_ = 0;       // u1.15, of the state a clock ago; in kPullIn it fades
  bool faded_ = false;  // it is below the start's
  bool was_fast_ = false;  // the rotor that is followed had hand-over's frequency
  bool began_ = false;     // and a step began since
  bool lasted_ = false;    // and another one: it had it after an interval that was measured
  bool fell_ = false;      // and has had less since
  bool eases_ = false;     // in this step
};

}  // namespace steplock
