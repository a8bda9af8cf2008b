// Start sequence: from standstill, or from a rotor that already turns, to a lock; and back.
//
//     kIdle        gates off, until the words are valid and `run` is up
//     kObserve     gates off; the PLL catches the comparators' codes.  Turns the wanted way: kRun
//                  at the speed and angle found.  The other way: kBrake.  Not in time: kSettle
//     kSettle      a step next to the reset position, for a rotor exactly opposite to it
//     kReset       two phases high, one low: the rotor takes a known position   (t_r, Eq. 22).
//                  Both last twice as long after each failed try, three times: a heavy rotor swings
//     kAccelerate  forced steps, frequency from 0 to hand_over by `ramp` per tick   (t_a, Eq. 23),
//                  a quarter as fast after each failed try, three times
//     kPullIn      the PLL closes; `good_crossings` in a row are a lock
//     kRun         speed control
//     kSlowDown    speed control down to hand-over speed, before a reversal or a braked stop
//     kBrake       braked for `brake` ticks, then kObserve looks again
//     kRest        gates off after a failed try
//     kFault       latched; left by a rising edge of clear_fault with `run` down and the cause gone
//
// With Hall sensors kRun follows kIdle at once.
//
//     latency      1 clock: outputs follow the state
//     registers    about 60 bits     multipliers  none
//
// Doc: docs/blocks/start_sequence.md   Test: tests/hls/start_sequence_test.cpp

#pragma once

#include "hls/numeric/bits.hpp"
#include "hls/six_step/commutation.hpp"
#include "hls/six_step/divide_by_n.hpp"
#include "hls/six_step/loop_filter.hpp"
#include "hls/six_step/phase_detector.hpp"
#include "hls/six_step/speed_control.hpp"
#include "hls/six_step/words.hpp"

namespace steplock {

class StartSequence {
 public:
  struct In {
    bool tick = false;                // the slow time base
    Command command;
    Source source = Source::kBemf;
    StartWords words;
    bool fast = false;                // the VCO's frequency is hand_over or more
    bool commutate = false;           // strobe: a new step began
    bool update = false;              // strobe: the phase detector has a new error
    bool good = false;                // with `update`: it is a small one
    bool lags = false;                // the last error was negative: the rotor lags the VCO
    bool turns_reverse = false;       // while observing: the code last moved downwards
    UInt<3> sector = 0;               // while observing: 0 to 5
    bool lost = false;                // protection: give up this try
    bool fatal = false;               // protection: latch
    Reason cause = Reason::kNone;     // protection: why
  };

  struct Out {
    State state = State::kIdle;
    Reason reason = Reason::kNone;      // of the last failed try, or of the fault
    bool enable = false;                // the gate guard may turn gates on
    Pattern pattern = Pattern::kOff;
    bool reverse = false;               // direction of this try
    bool running = false;               // locked and under speed control
    SpeedMode mode = SpeedMode::kFixed;
    Duty duty = 0;                      // u1.15, for kFixed and kAboveBemf
    bool stop = false;                  // speed control: towards standstill, not the set speed
    Evidence watch = Evidence::kNothing;  // phase detector
    Loop loop = Loop::kStop;            // loop filter
    bool load_step = false;             // one clock: take `step`, in its middle
    UInt<3> step = 0;                   // 0 to 5
    bool turn_vco = false;              // the VCO may count
    UInt<2> gentle = 0;                 // loop filter: the ramp is quartered so often
    bool began = false;                 // one clock: `run` was obeyed
    bool failed = false;                // one clock: a try failed
  };

  Out tick(const In& in) {
    const Out present = out(in);
    const bool over = in.tick && ticks_ == 0;
    const State wanted = choose(in, over);
    const bool leaves = wanted != state_;
    const State next = leaves ? admit(in, wanted) : state_;

    began_ = leaves && state_ == State::kIdle && wanted == State::kObserve;
    failed_ = leaves && wanted == State::kRest;
    load_step_ = leaves && (next == State::kAccelerate ||
                            (state_ == State::kObserve && next == State::kRun));
    if (leaves && wanted == State::kObserve) reverse_ = in.command.reverse;
    if (began_) {
      reason_ = Reason::kNone;
    } else if (leaves && (next == State::kRest || next == State::kFault)) {
      reason_ = wanted == State::kBrake                             ? Reason::kCannotStop
                : in.fatal || in.lost ? in.cause
                                                                    : Reason::kNoLock;
    }
    fade(in);
    count(in, over, leaves, wanted);
    if (leaves) {
      ticks_ = length(in, next, present.gentle);
    } else if (in.tick && !over) {
      ticks_ = wrap<Length>(ticks_ - 1);
    }
    clear_was_ = in.command.clear_fault;
    state_ = next;
    return present;
  }

  bool operator==(const StartSequence&) const = default;

 private:
  // Where the present state wants to go; itself, if nowhere.  kObserve stands for a new try, kBrake
  // for one more braking interval, kRest for a failed try: admit() knows what becomes of them.
  State choose(const In& in, bool over) const {
    if (state_ == State::kFault) {
      const bool rearm = in.command.clear_fault && !clear_was_;
      return rearm && !in.command.run && !in.fatal ? State::kIdle : State::kFault;
    }
    if (!in.command.configured) return State::kIdle;
    if (in.fatal) return State::kFault;
    const bool brakes = in.command.brake_to_stop &&
                        (state_ == State::kRun || state_ == State::kSlowDown ||
                         state_ == State::kBrake || state_ == State::kObserve);
    if (!in.command.run && !brakes) return State::kIdle;

    const bool enough = fresh_ && good_ >= in.words.good_crossings;
    const bool turn_round = !in.command.run || in.command.reverse != reverse_;
    switch (state_) {
      case State::kIdle: return State::kObserve;
      case State::kObserve:
        if (enough) {
          return !in.command.run || turns_reverse_ != reverse_ ? State::kBrake : State::kRun;
        }
        return !over ? State::kObserve : in.command.run ? State::kSettle : State::kIdle;
      case State::kBrake:
        if (!over) return State::kBrake;
        return !in.command.run && !looks(in) ? State::kIdle : State::kObserve;
      case State::kSettle: return over ? State::kReset : State::kSettle;
      case State::kReset: return over ? State::kAccelerate : State::kReset;
      case State::kAccelerate:
        return in.fast ? State::kPullIn : over ? State::kRest : State::kAccelerate;
      case State::kPullIn: return enough ? State::kRun : over ? State::kRest : State::kPullIn;
      case State::kRun:
        return in.lost ? State::kRest : turn_round ? State::kSlowDown : State::kRun;
      case State::kSlowDown:
        if (in.lost) return State::kRest;
        if (!turn_round) return State::kRun;
        return over || !in.fast ? State::kBrake : State::kSlowDown;
      default: return over ? State::kObserve : state_;
    }
  }

  static bool looks(const In& in) {
    return in.source == Source::kBemf && in.words.observe != 0;
  }

  State admit(const In& in, State wanted) const {
    switch (wanted) {
      case State::kObserve:
        return looks(in)                    ? State::kObserve
               : in.source == Source::kHall ? State::kRun
                                            : State::kSettle;
      case State::kBrake: return brakes_ == kMostBrakes ? State::kFault : State::kBrake;
      case State::kRest: return retries_ >= in.words.retries ? State::kFault : State::kRest;
      default: return wanted;
    }
  }

  using Length = UInt<15>;  // Ticks, doubled up to three times

  static Length doubled(Ticks ticks, UInt<2> times) {
    const Length wide = ticks;
    const Length once = times.bit(0) ? wide << 1 : wide;
    return times.bit(1) ? once << 2 : once;
  }

  static Length length(const In& in, State state, UInt<2> failed) {
    switch (state) {
      case State::kObserve: return in.words.observe;
      case State::kBrake: return in.words.brake;
      case State::kSettle:
      case State::kReset:
        return doubled(state == State::kSettle ? in.words.settle : in.words.reset, failed);
      case State::kPullIn: return in.words.pull_in;
      case State::kSlowDown: return in.words.slow_down;
      case State::kRest: return in.words.rest;
      case State::kRun: return 1024;   // after that long earlier failures are forgotten
      default: return doubled(Ticks::max(), failed);  // a ramp of 0 must end, too
    }
  }

  void count(const In& in, bool over, bool leaves, State wanted) {
    if (began_ || (over && state_ == State::kRun)) {
      retries_ = 0;
    } else if (failed_) {
      retries_ = wrap<UInt<4>>(retries_ + 1);
    }
    if (began_ || state_ == State::kRun) {
      brakes_ = 0;
    } else if (leaves && wanted == State::kBrake) {
      brakes_ = wrap<UInt<8>>(brakes_ + 1);
    }
    // While observing, changes that go on in the direction of the last one.
    const bool same = state_ != State::kObserve || in.turns_reverse == turns_reverse_;
    fresh_ = in.update;
    if (leaves) {
      good_ = 0;
    } else if (in.update) {
      good_ = in.good && same ? wrap<UInt<6>>(good_ + 1) : UInt<6>(0);
      turns_reverse_ = in.turns_reverse;
    }
  }

  // Pulling in, the start's torque fades by 1/32 per step: with all of it the rotor would keep its
  // lead on the VCO and run away from the loop.  A rotor that lags has too little torque and gets
  // 1/32 more per step, up to the start's: a heavy load would stop it else.
  // The failures counted are those before this clock: one that counts now ends the pulling in, and
  // waiting for the verdict would make this the longest path of the drive.
  void fade(const In& in) {
    const Duty part = boost_ >> 5;
    if (state_ != State::kPullIn) {
      boost_ = stronger(in.words.start_duty);
    } else if (in.commutate && (!in.lags || boost_ < stronger(in.words.start_duty))) {
      boost_ = in.lags ? wrap<Duty>(boost_ + part) : wrap<Duty>(boost_ - part);
    }
  }

  // Two failed tries: bus, flux or resistance may be weaker than the words' motor; the limit stands.
  Duty stronger(Duty duty) const {
    return retries_ > 1 ? saturate<Duty>(UInt<17>(duty) << 1) : duty;
  }

  Out out(const In& in) const {
    const bool hall = in.source == Source::kHall;
    Out out;
    out.state = state_;
    out.reason = reason_;
    out.reverse = reverse_;
    out.load_step = load_step_;
    out.step = step(in);
    out.began = began_;
    out.failed = failed_;
    out.stop = state_ == State::kSlowDown;
    // A load too heavy for the ramp fails; the next try takes a quarter of it.
    out.gentle = retries_ > 3 ? UInt<2>(3) : wrap<UInt<2>>(retries_);
    switch (state_) {
      case State::kObserve:
        out.turn_vco = true;
        out.watch = Evidence::kSectors;
        out.loop = Loop::kCatch;
        out.mode = SpeedMode::kAboveBemf;
        break;
      case State::kBrake:
        out.enable = true;
        out.pattern = Pattern::kBrake;
        out.duty = in.words.brake_duty;
        break;
      case State::kSettle:
      case State::kReset:
        out.enable = true;
        out.pattern = state_ == State::kSettle ? Pattern::kSettle : Pattern::kReset;
        out.duty = stronger(in.words.reset_duty);
        break;
      case State::kAccelerate:
      case State::kPullIn:
        out.enable = out.turn_vco = true;
        out.watch = state_ == State::kPullIn ? Evidence::kCrossings : Evidence::kNothing;
        out.loop = state_ == State::kPullIn ? Loop::kTrack : Loop::kRamp;
        out.pattern = Pattern::kDrive;
        out.mode = SpeedMode::kAboveBemf;
        out.duty = boost_;
        break;
      case State::kRun:
      case State::kSlowDown:
        out.enable = out.turn_vco = out.running = true;
        out.watch = hall ? Evidence::kSectors : Evidence::kCrossings;
        out.loop = hall ? Loop::kHall : Loop::kTrack;
        out.pattern = Pattern::kDrive;
        out.mode = SpeedMode::kControl;
        break;
      default: break;
    }
    return out;
  }

  // With load_step: full torque from the reset position, or where a rotor that enters `sector` is.
  Step step(const In& in) const {
    if (state_ == State::kAccelerate) return reverse_ ? Step(0) : Step(3);
    return reverse_ ? in.sector : next_step(in.sector, true);
  }

  static constexpr int kMostBrakes = 255;  // intervals before a rotor counts as unstoppable

  State state_ = State::kIdle;
  Reason reason_ = Reason::kNone;
  Length ticks_ = 0;            // left in this state
  UInt<6> good_ = 0;            // good crossings in a row
  bool fresh_ = false;          // good_ was counted in the last clock
  UInt<4> retries_ = 0;         // failed tries
  UInt<8> brakes_ = 0;          // braking intervals of this stop
  Duty boost_ = 0;              // u1.15, duty above the back-EMF's while pulling in
  bool load_step_ = false;
  bool began_ = false;
  bool failed_ = false;
  bool reverse_ = false;        // direction of this try
  bool turns_reverse_ = false;  // direction at the last update while observing
  bool clear_was_ = false;
};

}  // namespace steplock
