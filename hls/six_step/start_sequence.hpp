// Start sequence: from standstill, or from a rotor that already turns, to a lock; and back.
//
//     kIdle        gates off, until the words are valid and `run` is up
//     kObserve     gates off; the PLL catches the comparators' codes.  Turns the wanted way: kRun at the
//                  speed and angle found.  Turns the other way: kBrake.  Not found in time: kSettle
//     kSettle      a step next to the reset position, for a rotor exactly opposite to it
//     kReset       two phases high, one low: the rotor takes a known position   (t_r, Eq. 22)
//     kAccelerate  forced steps, frequency from 0 to hand_over by `ramp` per tick   (t_a, Eq. 23)
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
    Frequency target = 0;             // u0.32, set speed
    Frequency frequency = 0;          // u0.32, of the VCO
    bool commutate = false;           // strobe: a new step began
    bool update = false;              // strobe: the phase detector has a new error
    bool good = false;                // with `update`: it is a small one
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
    Frequency target = 0;               // u0.32, for speed control
    Evidence watch = Evidence::kNothing;      // phase detector
    Loop loop = Loop::kHold;            // loop filter
    bool load = false;                  // loop filter: take load_frequency
    Frequency load_frequency = 0;       // u0.32
    bool load_step = false;             // one clock: take `step`, in its middle
    UInt<3> step = 0;                   // 0 to 5
    bool turn_vco = false;              // the VCO may count
    bool began = false;                 // one clock: `run` was obeyed
    bool failed = false;                // one clock: a try failed
  };

  Out tick(const In& in) {
    const Out present = out(in);
    load_step_ = began_ = failed_ = false;
    fade(in);
    const bool rearm = in.command.clear_fault && !clear_was_;
    clear_was_ = in.command.clear_fault;

    if (state_ == State::kFault) {
      if (rearm && !in.command.run && !in.fatal) enter(State::kIdle, 0);
    } else if (!in.command.configured) {
      enter(State::kIdle, 0);
    } else if (in.fatal) {
      latch(in.cause);
    } else {
      advance(in);
    }
    return present;
  }

  bool operator==(const StartSequence&) const = default;

 private:
  void enter(State state, Ticks ticks) {
    state_ = state;
    ticks_ = ticks;
    good_ = 0;
  }

  void latch(Reason reason) {
    reason_ = reason;
    enter(State::kFault, 0);
  }

  void fail(const In& in, Reason reason) {
    failed_ = true;
    if (retries_ >= in.words.retries) {
      latch(reason);
    } else {
      retries_ = wrap<UInt<4>>(retries_ + 1);
      reason_ = reason;
      enter(State::kRest, in.words.rest);
    }
  }

  // Pulling in, the start's torque fades by 1/32 per step: with all of it the rotor would keep its lead
  // on the VCO and run away from the loop, with too little of it a heavy load would stop it.
  void fade(const In& in) {
    if (state_ != State::kPullIn) {
      boost_ = in.words.start_duty;
    } else if (in.commutate) {
      boost_ = wrap<Duty>(boost_ - (boost_ >> 5));
    }
  }

  // A try begins, in the direction that is wanted now.
  void begin(const In& in) {
    reverse_ = in.command.reverse;
    if (in.source == Source::kHall) {
      enter(State::kRun, kStable);
    } else if (in.words.observe != 0) {
      enter(State::kObserve, in.words.observe);
    } else {
      enter(State::kSettle, in.words.settle);
    }
  }

  void brake(const In& in) {
    if (brakes_ == 255) {
      latch(Reason::kCannotStop);
    } else {
      brakes_ = wrap<UInt<8>>(brakes_ + 1);
      enter(State::kBrake, in.words.brake);
    }
  }

  void advance(const In& in) {
    const bool over = in.tick && ticks_ == 0;
    if (in.tick && ticks_ != 0) ticks_ = wrap<Ticks>(ticks_ - 1);
    const bool brakes_to_stop = in.command.brake_to_stop &&
                                (state_ == State::kRun || state_ == State::kSlowDown ||
                                 state_ == State::kBrake || state_ == State::kObserve);
    if (!in.command.run && !brakes_to_stop) {
      enter(State::kIdle, 0);
      return;
    }
    switch (state_) {
      case State::kIdle:
        began_ = true;
        retries_ = 0;
        brakes_ = 0;
        reason_ = Reason::kNone;
        begin(in);
        break;
      case State::kObserve: observe(in, over); break;
      case State::kBrake:
        if (over) after_braking(in);
        break;
      case State::kSettle:
        if (over) enter(State::kReset, in.words.reset);
        break;
      case State::kReset:
        if (over) {
          load(reverse_ ? UInt<3>(0) : UInt<3>(3));
          enter(State::kAccelerate, Ticks::max());  // a ramp of 0 must end, too
        }
        break;
      case State::kAccelerate:
        if (in.frequency >= in.words.hand_over) {
          enter(State::kPullIn, in.words.pull_in);
        } else if (over) {
          fail(in, Reason::kNoLock);
        }
        break;
      case State::kPullIn: pull_in(in, over); break;
      case State::kRun: run(in, over); break;
      case State::kSlowDown:
        if (in.lost) {
          fail(in, in.cause);
        } else if (in.command.run && in.command.reverse == reverse_) {
          enter(State::kRun, kStable);
        } else if (over || slow(in)) {
          brake(in);
        }
        break;
      case State::kRest:
        if (over) begin(in);
        break;
      default: break;
    }
  }

  void load(UInt<3> step) {
    load_step_ = true;
    step_ = step;
  }

  void observe(const In& in, bool over) {
    if (in.update) {
      const bool again = in.good && in.turns_reverse == turns_reverse_;
      turns_reverse_ = in.turns_reverse;
      good_ = again ? wrap<UInt<6>>(good_ + 1) : UInt<6>(0);
      const bool turns = again && good_ >= in.words.good_crossings &&
                         in.frequency > (in.words.hand_over >> 1);
      if (turns && (in.turns_reverse != reverse_ || !in.command.run)) {
        brake(in);
        return;
      }
      if (turns) {
        load(in.turns_reverse ? in.sector
             : in.sector == 0 ? UInt<3>(5)
                              : wrap<UInt<3>>(in.sector - 1));
        enter(State::kRun, kStable);
        return;
      }
    }
    if (over) at_rest(in);
  }

  // No rotation was found.
  void at_rest(const In& in) {
    if (in.command.run) {
      enter(State::kSettle, in.words.settle);
    } else {
      enter(State::kIdle, 0);
    }
  }

  void after_braking(const In& in) {
    if (!in.command.run && (in.source == Source::kHall || in.words.observe == 0)) {
      enter(State::kIdle, 0);
    } else {
      begin(in);
    }
  }

  void pull_in(const In& in, bool over) {
    if (in.update) good_ = in.good ? wrap<UInt<6>>(good_ + 1) : UInt<6>(0);
    if (in.update && in.good && good_ >= in.words.good_crossings) {
      enter(State::kRun, kStable);
    } else if (over) {
      fail(in, Reason::kNoLock);
    }
  }

  void run(const In& in, bool over) {
    if (over) retries_ = 0;
    if (in.lost) {
      fail(in, in.cause);
    } else if (!in.command.run || in.command.reverse != reverse_) {
      brakes_ = 0;
      enter(State::kSlowDown, in.words.slow_down);
    }
  }

  static bool slow(const In& in) {
    return in.frequency <= in.words.hand_over + (in.words.hand_over >> 2);
  }

  Out out(const In& in) const {
    Out out;
    out.state = state_;
    out.reason = reason_;
    out.reverse = reverse_;
    out.load_step = load_step_;
    out.step = step_;
    out.began = began_;
    out.failed = failed_;
    out.target = state_ == State::kSlowDown ? in.words.hand_over : in.target;
    out.load_frequency = in.words.hand_over;
    switch (state_) {
      case State::kObserve:
        out.turn_vco = true;
        out.watch = Evidence::kSectors;
        out.loop = Loop::kCatch;
        out.mode = SpeedMode::kAboveBemf;
        break;
      case State::kBrake:
        out.enable = out.load = true;
        out.pattern = Pattern::kBrake;
        out.duty = in.words.brake_duty;
        break;
      case State::kSettle:
      case State::kReset:
        out.enable = out.load = true;
        out.load_frequency = 0;
        out.pattern = state_ == State::kSettle ? Pattern::kSettle : Pattern::kReset;
        out.duty = in.words.reset_duty;
        break;
      case State::kAccelerate:
        out.enable = out.turn_vco = true;
        out.loop = Loop::kRamp;
        out.pattern = Pattern::kDrive;
        out.mode = SpeedMode::kAboveBemf;
        out.duty = in.words.start_duty;
        break;
      case State::kPullIn:
        out.enable = out.turn_vco = true;
        out.watch = Evidence::kCrossings;
        out.loop = Loop::kTrack;
        out.pattern = Pattern::kDrive;
        out.mode = SpeedMode::kAboveBemf;
        out.duty = boost_;
        break;
      case State::kRun:
      case State::kSlowDown:
        out.enable = out.turn_vco = out.running = true;
        out.watch = in.source == Source::kHall ? Evidence::kSectors : Evidence::kCrossings;
        out.loop = in.source == Source::kHall ? Loop::kHall : Loop::kTrack;
        out.pattern = Pattern::kDrive;
        out.mode = SpeedMode::kControl;
        break;
      default: out.load = true; break;
    }
    return out;
  }

  static constexpr int kStable = 1024;  // ticks in kRun after which earlier failures are forgotten

  State state_ = State::kIdle;
  Reason reason_ = Reason::kNone;
  Ticks ticks_ = 0;             // left in this state
  UInt<6> good_ = 0;            // good crossings in a row
  UInt<4> retries_ = 0;         // failed tries
  UInt<8> brakes_ = 0;          // braking intervals of this stop
  Duty boost_ = 0;              // u1.15, duty above the back-EMF's while pulling in
  UInt<3> step_ = 0;            // to be loaded
  bool load_step_ = false;
  bool began_ = false;
  bool failed_ = false;
  bool reverse_ = false;        // direction of this try
  bool turns_reverse_ = false;  // direction at the last update while observing
  bool clear_was_ = false;
};

}  // namespace steplock
