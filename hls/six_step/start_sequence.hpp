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
//     registers    82 bits     multipliers  none
//
// Doc: docs/blocks/start_sequence.md   Test: tests/hls/start_sequence_test.cpp

#pragma once

#include "hls/numeric/bits.hpp"
#include "hls/numeric/one_hot.hpp"
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
    Parameter<true> observes;         // else kObserve is left out, as with words.observe = 0
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
    OneHot<Pattern, 5> pattern = Pattern::kOff;
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
    const bool over = in.tick && last_ && !entered_;
    const Moves moves = choose(in, over);
    const States next = admit(in, moves, over);

    began_ = moves.tries && at_.holds(State::kIdle);
    const bool failed = failed_;
    failed_ = moves.fails;
    load_step_ = (!at_.holds(State::kAccelerate) && next.holds(State::kAccelerate)) ||
                 (at_.holds(State::kObserve) && next.holds(State::kRun));
    if (moves.tries) reverse_ = in.command.reverse;
    if (began_) {
      reason_ = Reason::kNone;
    } else if (moves.fails || (!at_.holds(State::kFault) && next.holds(State::kFault))) {
      reason_ = moves.brakes          ? Reason::kCannotStop
                : in.fatal || in.lost ? in.cause
                                      : Reason::kNoLock;
    }
    lead(in);
    count(in, over, failed, braking_);
    braking_ = moves.brakes;
    clear_was_ = in.command.clear_fault;
    entered_ = moves.leaves;
    boosts_ = next.holds_one_of(State::kAccelerate, State::kPullIn);
    drives_ = next.holds_one_of(State::kAccelerate, State::kPullIn, State::kRun, State::kSlowDown);
    enables_ = drives_ || next.holds_one_of(State::kBrake, State::kSettle, State::kReset);
    at_ = next;
    return present;
  }

  bool operator==(const StartSequence&) const = default;

 private:
  using States = OneHot<State, 11>;

  static bool looks(const In& in) {
    return in.observes && in.source == Source::kBemf && in.words.observe != 0;
  }

  // What more than one state may want, and what counters have a say in.
  struct Moves {
    bool stops = false;   // to kIdle, whatever the state is
    bool trips = false;   // to kFault, likewise
    bool tries = false;   // a new try
    bool brakes = false;  // one braking interval more
    bool fails = false;   // this try failed
    bool leaves = false;  // the state, by any of these or by itself
  };

  Moves choose(const In& in, bool over) const {
    const bool fault = at_.holds(State::kFault);
    const bool runs = at_.holds_one_of(State::kRun, State::kSlowDown);
    const bool brakes = in.command.brake_to_stop &&
                        (runs || at_.holds_one_of(State::kBrake, State::kObserve));
    const bool halts = !in.command.run && !brakes;
    const bool rearm = in.command.clear_fault && !clear_was_ && !in.command.run && !in.fatal;
    const bool trips = in.command.configured && in.fatal;
    const bool goes = !fault && in.command.configured && !in.fatal && !halts;
    return {.stops = fault ? rearm : !in.command.configured || (halts && !in.fatal),
            .trips = fault ? !rearm : trips,
            .tries = goes && (at_.holds(State::kIdle) || (at_.holds(State::kBrake) && over && looks_again(in)) ||
                              (at_.holds(State::kRest) && over)),
            .brakes = goes && ((at_.holds(State::kObserve) && enough_ && !turns_on(in)) ||
                               (at_.holds(State::kSlowDown) && !in.lost && turns_round(in) && (over || !in.fast))),
            .fails = goes && ((at_.holds(State::kAccelerate) && !in.fast && over) ||
                              (at_.holds(State::kPullIn) && !enough_ && over) || (runs && in.lost)),
            .leaves = goes ? leaves(in, over)
                           : !at_.holds_one_of(State::kIdle, State::kFault) || (at_.holds(State::kIdle) && trips) ||
                                 (fault && rearm)};
  }

  // What ends the present state while the drive is told to go on.
  bool leaves(const In& in, bool over) const {
    const bool timed = !at_.holds_one_of(State::kIdle, State::kRun, State::kFault);
    return at_.holds(State::kIdle) || (over && timed) ||
           (enough_ && at_.holds_one_of(State::kObserve, State::kPullIn)) ||
           (in.fast && at_.holds(State::kAccelerate)) ||
           (at_.holds(State::kRun) && (in.lost || turns_round(in))) ||
           (at_.holds(State::kSlowDown) && (in.lost || !turns_round(in) || !in.fast));
  }

  bool turns_round(const In& in) const { return !in.command.run || in.command.reverse != reverse_; }
  bool turns_on(const In& in) const { return in.command.run && turns_reverse_ == reverse_; }
  static bool looks_again(const In& in) { return in.command.run || looks(in); }

  // Every state with what leads to it, and what keeps the drive in it.
  States admit(const In& in, const Moves& moves, bool over) const {
    const bool hall = in.source == Source::kHall;
    const bool missed = at_.holds(State::kObserve) && !enough_ && over;
    const bool caught = at_.holds(State::kObserve) && enough_ && turns_on(in);
    const bool locks = at_.holds(State::kPullIn) && enough_;
    const bool on = at_.holds_one_of(State::kRun, State::kSlowDown) && !in.lost;
    const bool gives_up = at_.holds(State::kBrake) && over && !looks_again(in);
    const auto to = [](State state, bool yes) { return States(state).when(yes); };
    const States wanted =
        to(State::kIdle, (missed && !in.command.run) || gives_up) |
        to(State::kObserve, in.observes && at_.holds(State::kObserve) && !enough_ && !over) |
        to(State::kBrake, at_.holds(State::kBrake) && !over) |
        to(State::kSettle, (missed && in.command.run) || (at_.holds(State::kSettle) && !over)) |
        to(State::kReset, (at_.holds(State::kSettle) && over) || (at_.holds(State::kReset) && !over)) |
        to(State::kAccelerate, (at_.holds(State::kReset) && over) ||
                                   (at_.holds(State::kAccelerate) && !in.fast && !over)) |
        to(State::kPullIn, (at_.holds(State::kAccelerate) && in.fast) ||
                               (at_.holds(State::kPullIn) && !enough_ && !over)) |
        to(State::kRun, caught || locks || (on && !turns_round(in))) |
        to(State::kSlowDown, on && turns_round(in) && (at_.holds(State::kRun) || (!over && in.fast))) |
        to(State::kRest, at_.holds(State::kRest) && !over);
    return wanted.when(!moves.stops && !moves.trips) |
           to(State::kIdle, moves.stops) |
           to(State::kObserve, moves.tries && looks(in)) |
           to(State::kRun, moves.tries && !looks(in) && hall) |
           to(State::kSettle, moves.tries && !looks(in) && !hall) |
           to(State::kBrake, moves.brakes && !braked_) |
           to(State::kRest, moves.fails && !tried_) |
           to(State::kFault, moves.trips || (moves.brakes && braked_) || (moves.fails && tried_));
  }

  using Length = UInt<15>;  // Ticks, doubled up to three times

  static Length doubled(Ticks ticks, UInt<2> times) {
    const Length wide = ticks;
    const Length once = times.bit(0) ? wide << 1 : wide;
    return times.bit(1) ? once << 2 : once;
  }

  Length length(const In& in, UInt<2> failed) const {
    const auto when = [this](State state, Length then) { return at_.holds(state) ? then : Length(0); };
    return when(State::kObserve, in.words.observe) | when(State::kBrake, in.words.brake) |
           when(State::kSettle, doubled(in.words.settle, failed)) |
           when(State::kReset, doubled(in.words.reset, failed)) |
           when(State::kPullIn, in.words.pull_in) | when(State::kSlowDown, in.words.slow_down) |
           when(State::kRest, in.words.rest) |
           when(State::kRun, 1024) |  // after that long earlier failures are forgotten
           when(State::kAccelerate, doubled(Ticks::max(), failed));  // a ramp of 0 must end, too
  }

  // `failed` and `brakes` are of the clock before: nothing asks so soon.
  void count(const In& in, bool over, bool failed, bool brakes) {
    // A state's ticks are loaded in its first clock; a tick of that very clock counts in the next one.
    const bool ticks = (in.tick || late_) && !entered_;
    late_ = in.tick && entered_;
    last_ = !entered_ && ticks_ == 0;
    if (entered_) {
      ticks_ = length(in, gentle());
    } else if (ticks && ticks_ != 0) {
      ticks_ = wrap<Length>(ticks_ - 1);
    }
    tried_ = retries_ >= in.words.retries;
    if (at_.holds(State::kIdle) || (over && at_.holds(State::kRun))) {
      retries_ = 0;
    } else if (failed) {
      retries_ = wrap<UInt<4>>(retries_ + 1);
    }
    braked_ = brakes_ == kMostBrakes;
    if (at_.holds_one_of(State::kIdle, State::kRun)) {
      brakes_ = 0;
    } else if (brakes) {
      brakes_ = wrap<UInt<8>>(brakes_ + 1);
    }
    // While observing, changes that go on in the direction of the last one.
    const bool same = !at_.holds(State::kObserve) || in.turns_reverse == turns_reverse_;
    const bool counts = in.good && same;
    enough_ = in.update && counts && nearly_ && !entered_;
    nearly_ = good_ + 1 >= in.words.good_crossings;
    if (entered_) {
      good_ = 0;
    } else if (in.update) {
      good_ = counts ? wrap<UInt<6>>(good_ + 1) : UInt<6>(0);
      turns_reverse_ = in.turns_reverse;
    }
  }

  // Pulling in, the start's torque fades by 1/32 per step: with all of it the rotor would keep its
  // lead on the VCO and run away from the loop.  A rotor that lags has too little torque and gets
  // 1/32 more per step, up to the start's: a heavy load would stop it else.
  // The failures counted are those before this clock: one that counts now ends the pulling in, and
  // waiting for the verdict would make this the longest path of the drive.
  void lead(const In& in) {
    const Duty part = duty_ >> 5;
    const bool faded = duty_ < stronger(in.words.start_duty);
    if (!at_.holds(State::kPullIn)) {
      duty_ = at_.holds(State::kAccelerate)                          ? stronger(in.words.start_duty)
              : at_.holds_one_of(State::kSettle, State::kReset) ? stronger(in.words.reset_duty)
              : at_.holds(State::kBrake)                        ? in.words.brake_duty
                                                                : Duty(0);
    } else if (in.commutate && (!in.lags || faded_)) {
      // One adder for both directions: the 1 that the complement lacks is carried in from a bit below.
      const UInt<17> change = UInt<17>(in.lags ? part : wrap<Duty>(~part)) << 1 | UInt<17>(!in.lags);
      duty_ = wrap<Duty>(((UInt<17>(duty_) << 1 | UInt<17>(1)) + change) >> 1);
    }
    faded_ = faded;
  }

  // Two failed tries: bus, flux or resistance may be weaker than the words' motor; the limit stands.
  Duty stronger(Duty duty) const {
    return retries_ > 1 ? saturate<Duty>(UInt<17>(duty) << 1) : duty;
  }

  Out out(const In& in) const {
    const bool hall = in.source == Source::kHall;
    Out out;
    out.state = at_.value();
    out.reason = reason_;
    out.reverse = reverse_;
    out.load_step = load_step_;
    out.step = step(in);
    out.began = began_;
    out.failed = failed_;
    out.stop = at_.holds(State::kSlowDown);
    // A load too heavy for the ramp fails; the next try takes a quarter of it.
    out.gentle = gentle();

    const bool observes = at_.holds(State::kObserve);
    out.running = at_.holds_one_of(State::kRun, State::kSlowDown);
    out.enable = enables_;
    out.turn_vco = observes || drives_;
    const auto bridge = [](Pattern pattern, bool on) { return OneHot<Pattern, 5>(pattern).when(on); };
    out.pattern = bridge(Pattern::kOff, !out.enable) | bridge(Pattern::kDrive, drives_) |
                  bridge(Pattern::kBrake, at_.holds(State::kBrake)) |
                  bridge(Pattern::kSettle, at_.holds(State::kSettle)) |
                  bridge(Pattern::kReset, at_.holds(State::kReset));
    const bool tracks = at_.holds(State::kPullIn) || (out.running && !hall);
    const bool follows = observes || (out.running && hall);
    out.watch = follows ? Evidence::kSectors : tracks ? Evidence::kCrossings : Evidence::kNothing;
    out.loop = observes                        ? Loop::kCatch
               : follows                       ? Loop::kHall
               : tracks                        ? Loop::kTrack
               : at_.holds(State::kAccelerate) ? Loop::kRamp
                                               : Loop::kStop;
    out.mode = out.running            ? SpeedMode::kControl
               : observes || boosts_ ? SpeedMode::kAboveBemf
                                     : SpeedMode::kFixed;
    out.duty = duty_;
    return out;
  }

  // Tries that failed, as far as they make the next one gentler.
  UInt<2> gentle() const { return retries_ > 3 ? UInt<2>(3) : wrap<UInt<2>>(retries_); }

  // With load_step: full torque from the reset position, or where a rotor that enters `sector` is.
  Step step(const In& in) const {
    if (at_.holds(State::kAccelerate)) return reverse_ ? Step(0) : Step(3);
    return reverse_ ? in.sector : next_step(in.sector, true);
  }

  static constexpr int kMostBrakes = 255;  // intervals before a rotor counts as unstoppable

  States at_ = State::kIdle;
  bool drives_ = false;         // one of the states in which the bridge commutates
  bool enables_ = false;        // or one of the others in which gates may be on
  bool boosts_ = false;         // one of those whose duty comes above the back-EMF's
  Duty duty_ = 0;               // u1.15, of the state a clock ago; in kPullIn it fades
  bool entered_ = false;        // this is the first clock of the state
  bool late_ = false;           // there was a tick in it
  bool last_ = false;           // no ticks are left
  bool tried_ = false;          // no more tries are left
  bool braking_ = false;        // a braking interval begins
  bool braked_ = false;         // no more braking intervals are left
  Reason reason_ = Reason::kNone;
  Length ticks_ = 0;            // left in this state
  UInt<6> good_ = 0;            // good crossings in a row
  bool nearly_ = false;         // one more is enough
  bool enough_ = false;         // that one came in the last clock
  UInt<4> retries_ = 0;         // failed tries
  UInt<8> brakes_ = 0;          // braking intervals of this stop
  bool faded_ = false;          // the duty is below the start's
  bool load_step_ = false;
  bool began_ = false;
  bool failed_ = false;
  bool reverse_ = false;        // direction of this try
  bool turns_reverse_ = false;  // direction at the last update while observing
  bool clear_was_ = false;
};

}  // namespace steplock
