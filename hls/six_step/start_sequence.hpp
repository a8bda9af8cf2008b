// Start sequence: from standstill, or from a rotor that already turns, to a lock; and back.
//
//     kIdle        gates off, until `run` goes up with valid words and a set speed that is not 0; words that become
//                  valid under a `run` that is up start nothing
//     kDetectSpin  gates off; the PLL catches the comparators' codes.  Turns the wanted way: kRun
//                  at the speed and angle found, if that is no stall.  The other way: kBrake.  Else, in time: kPreAlign
//     kPreAlign    a step next to the aligned position, for a rotor exactly opposite to it
//     kAlign       two phases high, one low: the rotor takes a known position   (the paper's reset: t_r, Eq. 22).
//                  Both last twice as long after each failed attempt, three times: a heavy rotor swings
//     kAccelerate  forced steps, frequency from 0 to hand_over by `ramp` per tick   (t_a, Eq. 23),
//                  a quarter as fast after each failed attempt, three times.  With method kFollow it comes in place of
//                  kPreAlign and kAlign, too, and the steps are the rotor follower's, until that has caught the rotor
//     kPullIn      the PLL closes; `good_crossings` in a row are a lock
//     kRun         speed control
//     kSlowDown    speed control down to hand-over speed, before a reversal or a braked stop
//     kBrake       braked for `brake` ticks, the more softly the faster it turned; then kDetectSpin looks again
//     kRetryDelay  gates off after a failed attempt
//     kFault       latched; left by a rising edge of clear_fault with `run` down and the cause gone
//
// With Hall sensors kRun follows kIdle at once.  What ends a state in time, and how often, is counted by
// StartCounters; the duty of the states without speed control is OpenLoopDuty's.
//
//     latency      1 clock: outputs follow the state
//     registers    94 bits, 64 of them in the two     multipliers  none
//
// Law: hls/six_step/start_sequence_law.hpp   Doc: docs/blocks/start_sequence.md   Test: tests/hls/start_sequence_test.cpp

#pragma once

#include "hls/numeric/bits.hpp"
#include "hls/numeric/one_hot.hpp"
#include "hls/six_step/commutation.hpp"
#include "hls/six_step/divide_by_n.hpp"
#include "hls/six_step/loop_filter.hpp"
#include "hls/six_step/open_loop_duty.hpp"
#include "hls/six_step/phase_detector.hpp"
#include "hls/six_step/speed_control.hpp"
#include "hls/six_step/start_counters.hpp"
#include "hls/six_step/config.hpp"

namespace steplock {

class StartSequence {
 public:
  struct In {
    Parameter<true> detects_spin;     // else kDetectSpin is left out, as with config.detect_spin = 0
    bool tick = false;                // the slow time base
    Command command;
    Source source = Source::kBemf;
    StartConfig config;
    bool fast = false;                // the VCO's frequency is hand_over or more
    bool slow = false;                // it is below stall
    bool commutate = false;           // strobe: a new step began
    bool update = false;              // strobe: the phase detector has a new error
    bool good = false;                // with `update`: it is a small one
    bool lags = false;                // the last error was negative: the rotor lags the VCO
    bool turns_reverse = false;       // while a spin is detected: the code last moved downwards
    UInt<3> sector = 0;               // while a spin is detected: 0 to 5
    bool follower_drives = false;     // the rotor follower: gates may be on
    bool caught = false;              // strobe: and the rotor can be handed over, in the middle of the present step
    bool sure = false;                // it has the rotor
    bool moves = false;               // or saw one pass an edge at least, either way
    bool blocked = false;             // strobe: it cannot move it
    bool still = false;               // the set speed is 0: as if `run` were down, by braking
    Step at = 0;                      // the present step
    bool lost = false;                // protection: give up this attempt
    bool fatal = false;               // protection: latch
    Reason cause = Reason::kNone;     // protection: why
  };

  struct Out {
    State state = State::kIdle;
    Reason reason = Reason::kNone;      // of the last failed attempt, or of the fault
    bool enable = false;                // the gate guard may turn gates on
    OneHot<Pattern, 5> pattern = Pattern::kOff;
    bool reverse = false;               // direction of this attempt
    bool running = false;               // locked and under speed control
    SpeedMode mode = SpeedMode::kFixed;
    Duty duty = 0;                      // u1.15, for all modes but kControl
    bool stop = false;                  // speed control: towards standstill, not the set speed
    DetectorSource detector_source = DetectorSource::kNone;  // phase detector
    Loop loop = Loop::kStop;            // loop filter
    bool load_step = false;             // one clock: take `step`, in its middle
    UInt<3> step = 0;                   // 0 to 5
    bool turn_vco = false;              // the VCO may count
    bool follow = false;                // the rotor follower is at work
    bool steady = false;                // good intervals in a row, almost as many as a lock takes
    UInt<2> backoff = 0;                // loop filter: the ramp is quartered so often
    bool began = false;                 // one clock: `run` was obeyed
    bool failed = false;                // one clock: an attempt failed
  };

  Out tick(const In& in) {
    Counts counts = counters_.tick({.tick = in.tick,
                                          .state = at_,
                                          .entered = entered_,
                                          .failed = failed_,
                                          .braking = braking_,
                                          .update = in.update,
                                          .good = in.good,
                                          .turns_reverse = in.turns_reverse,
                                          .hopeful = in.moves,
                                          .config = in.config});
    if (at_.holds(State::kDetectSpin) && is_started(in, counts)) counts.count_reached = false;
    const Duty duty = open_loop_.tick({.state = at_,
                                       .strong = counts.strong,
                                       .follows = follows(in),
                                       .sure = in.sure,
                                       .fast = in.fast,
                                       .commutate = in.commutate,
                                       .lags = in.lags,
                                       .align_duty = in.config.align_duty,
                                       .start_duty = in.config.start_duty,
                                       .brake_duty = in.config.brake_duty}).duty;
    const Out present = out(in, counts, duty);
    const Requests requests = request(in, counts);
    const States next = next_state(in, requests, counts);

    began_ = requests.attempt && at_.holds(State::kIdle);
    failed_ = requests.fails;
    load_step_ = (follows(in) ? at_.holds(State::kAccelerate) && next.holds(State::kPullIn)
                              : !at_.holds(State::kAccelerate) && next.holds(State::kAccelerate)) ||
                 (at_.holds(State::kDetectSpin) && next.holds(State::kRun));
    if (requests.attempt) reverse_ = in.command.reverse;
    if (began_) {
      reason_ = Reason::kNone;
    } else if (requests.fails || (!at_.holds(State::kFault) && next.holds(State::kFault))) {
      reason_ = requests.brakes       ? Reason::kCannotStop
                : in.fatal || in.lost ? in.cause
                : in.blocked          ? Reason::kBlocked
                                      : Reason::kNoLock;
    }
    braking_ = requests.brakes;
    clear_was_ = in.command.clear_fault;
    refused_ = in.command.run && (refused_ || !in.command.configured);
    entered_ = requests.exits;
    boosts_ = next.holds_one_of(State::kAccelerate, State::kPullIn);
    drives_ = next.holds_one_of(State::kAccelerate, State::kPullIn, State::kRun, State::kSlowDown);
    enables_ = drives_ || next.holds_one_of(State::kBrake, State::kPreAlign, State::kAlign);
    // A tick later than the duty of the pulling in, which the integral then has.
    if (in.tick) holds_ = boosted_;
    if (in.tick) boosted_ = follows(in);
    if (!at_.holds(State::kPullIn)) holds_ = boosted_ = false;
    const bool hall = in.source == Source::kHall;
    const bool runs = next.holds_one_of(State::kRun, State::kSlowDown);
    sectors_ = next.holds(State::kDetectSpin) || (runs && hall) ||
               (at_.holds(State::kAccelerate) && next.holds(State::kAccelerate) && follows(in));
    tracks_ = next.holds(State::kPullIn) || (runs && !hall);
    at_ = next;
    return present;
  }

  bool operator==(const StartSequence&) const = default;

 private:
  using Counts = StartCounters::Out;

  static bool follows(const In& in) { return in.config.method == Method::kFollow; }
  // The word changed.
  bool turns_to_follow(const In& in) const {
    return follows(in) && at_.holds_one_of(State::kPreAlign, State::kAlign);
  }
  // What ends kAccelerate well.
  static bool arrives(const In& in) { return follows(in) ? in.caught : in.fast; }
  static bool looks(const In& in) {
    return in.detects_spin && in.source == Source::kBemf && in.config.detect_spin != 0;
  }

  // What more than one state may want, and what counters have a say in.
  struct Requests {
    bool stops = false;   // to kIdle, whatever the state is
    bool trips = false;   // to kFault, likewise
    bool attempt = false; // a new one
    bool brakes = false;  // one braking interval more
    bool fails = false;   // this attempt failed
    bool exits = false;   // the state, by any of these or by itself
  };

  Requests request(const In& in, const Counts& counts) const {
    const bool timed_out = counts.timed_out;
    const bool fault = at_.holds(State::kFault);
    const bool runs = at_.holds_one_of(State::kRun, State::kSlowDown);
    const bool brakes = (in.command.brake_to_stop || in.still) &&
                        (runs || at_.holds_one_of(State::kBrake, State::kDetectSpin));
    const bool halts = (!runs_on(in) || refused_) && !brakes;
    const bool rearm = in.command.clear_fault && !clear_was_ && !in.command.run && !in.fatal;
    const bool trips = in.command.configured && in.fatal;
    const bool active = !fault && in.command.configured && !in.fatal && !halts;
    return {.stops = fault ? rearm : !in.command.configured || (halts && !in.fatal),
            .trips = fault ? !rearm : trips,
            .attempt = active && (at_.holds(State::kIdle) || (at_.holds(State::kBrake) && timed_out && looks_again(in)) ||
                                  (at_.holds(State::kRetryDelay) && timed_out)),
            .brakes = active && ((at_.holds(State::kDetectSpin) && counts.count_reached && !turns_on(in, counts)) ||
                               (at_.holds(State::kSlowDown) && !in.lost && turns_round(in) && (timed_out || !in.fast))),
            .fails = active && ((at_.holds(State::kAccelerate) && !arrives(in) && (timed_out || in.blocked)) ||
                              (at_.holds(State::kPullIn) && !counts.count_reached && timed_out) || (runs && in.lost)),
            .exits = active ? exits(in, counts)
                           : !at_.holds_one_of(State::kIdle, State::kFault) || (at_.holds(State::kIdle) && trips) ||
                                 (fault && rearm)};
  }

  // What ends the present state while the drive is told to go on.
  bool exits(const In& in, const Counts& counts) const {
    const bool timed = !at_.holds_one_of(State::kIdle, State::kRun, State::kFault);
    return at_.holds(State::kIdle) || (counts.timed_out && timed) ||
           (counts.count_reached && at_.holds_one_of(State::kDetectSpin, State::kPullIn)) ||
           ((arrives(in) || in.blocked) && at_.holds(State::kAccelerate)) ||
           turns_to_follow(in) || (at_.holds(State::kRun) && (in.lost || turns_round(in))) ||
           (at_.holds(State::kSlowDown) && (in.lost || !turns_round(in) || !in.fast));
  }

  static bool runs_on(const In& in) { return in.command.run && !in.still; }
  bool turns_round(const In& in) const { return !runs_on(in) || in.command.reverse != reverse_; }
  bool turns_on(const In& in, const Counts& counts) const {
    return runs_on(in) && counts.turns_reverse == reverse_;
  }
  // Neither caught, since it turns slower than it may run, nor braked, since a rotor follower turns it round.
  bool is_started(const In& in, const Counts& counts) const {
    return turns_on(in, counts) ? in.slow : follows(in) && runs_on(in) && !in.fast;
  }
  static bool looks_again(const In& in) { return runs_on(in) || looks(in); }

  // Every state with what leads to it, and what keeps the drive in it.
  States next_state(const In& in, const Requests& requests, const Counts& counts) const {
    const bool timed_out = counts.timed_out, count_reached = counts.count_reached;
    const bool hall = in.source == Source::kHall;
    const bool missed = at_.holds(State::kDetectSpin) && !count_reached && timed_out;
    const bool begins = missed && runs_on(in);
    const bool caught = at_.holds(State::kDetectSpin) && count_reached && turns_on(in, counts);
    const bool locks = at_.holds(State::kPullIn) && count_reached;
    const bool on = at_.holds_one_of(State::kRun, State::kSlowDown) && !in.lost;
    const bool gives_up = at_.holds(State::kBrake) && timed_out && !looks_again(in);
    const auto to = [](State state, bool yes) { return States(state).when(yes); };
    const States wanted =
        to(State::kIdle, (missed && !runs_on(in)) || gives_up) |
        to(State::kDetectSpin, in.detects_spin && at_.holds(State::kDetectSpin) && !count_reached && !timed_out) |
        to(State::kBrake, at_.holds(State::kBrake) && !timed_out) |
        to(State::kPreAlign, !follows(in) && (begins || (at_.holds(State::kPreAlign) && !timed_out))) |
        to(State::kAlign, !follows(in) && ((at_.holds(State::kPreAlign) && timed_out) || (at_.holds(State::kAlign) && !timed_out))) |
        to(State::kAccelerate, (begins && follows(in)) || turns_to_follow(in) || (at_.holds(State::kAlign) && timed_out) ||
                                   (at_.holds(State::kAccelerate) && !arrives(in) && !timed_out && !in.blocked)) |
        to(State::kPullIn, (at_.holds(State::kAccelerate) && arrives(in)) ||
                               (at_.holds(State::kPullIn) && !count_reached && !timed_out)) |
        to(State::kRun, caught || locks || (on && !turns_round(in))) |
        to(State::kSlowDown, on && turns_round(in) && (at_.holds(State::kRun) || (!timed_out && in.fast))) |
        to(State::kRetryDelay, at_.holds(State::kRetryDelay) && !timed_out);
    return wanted.when(!requests.stops && !requests.trips) |
           to(State::kIdle, requests.stops) |
           to(State::kDetectSpin, requests.attempt && looks(in)) |
           to(State::kRun, requests.attempt && !looks(in) && hall) |
           to(State::kPreAlign, requests.attempt && !looks(in) && !hall && !follows(in)) |
           to(State::kAccelerate, requests.attempt && !looks(in) && !hall && follows(in)) |
           to(State::kBrake, requests.brakes && !counts.brakes_exhausted) |
           to(State::kRetryDelay, requests.fails && !counts.retries_exhausted) |
           to(State::kFault, requests.trips || (requests.brakes && counts.brakes_exhausted) ||
                                 (requests.fails && counts.retries_exhausted));
  }

  Out out(const In& in, const Counts& counts, Duty duty) const {
    Out out;
    out.state = at_.value();
    out.reason = reason_;
    out.reverse = reverse_;
    out.load_step = load_step_;
    out.step = step(in);
    out.began = began_;
    out.failed = failed_;
    out.stop = at_.holds(State::kSlowDown);
    // A load too heavy for the ramp fails; the next attempt takes a quarter of it.
    out.backoff = counts.backoff;
    out.steady = counts.steady;

    const bool detects_spin = at_.holds(State::kDetectSpin);
    out.running = at_.holds_one_of(State::kRun, State::kSlowDown);
    out.enable = enables_;
    out.turn_vco = detects_spin || drives_;
    const auto bridge = [](Pattern pattern, bool on) { return OneHot<Pattern, 5>(pattern).when(on); };
    const bool follows_rotor = at_.holds(State::kAccelerate) && follows(in);
    const bool rests = follows_rotor && !in.follower_drives;  // for a look
    out.follow = follows_rotor;
    out.pattern = bridge(Pattern::kOff, !out.enable || rests) | bridge(Pattern::kDrive, drives_ && !rests) |
                  bridge(Pattern::kBrake, at_.holds(State::kBrake)) |
                  bridge(Pattern::kPreAlign, at_.holds(State::kPreAlign)) |
                  bridge(Pattern::kAlign, at_.holds(State::kAlign));
    out.detector_source = sectors_ ? DetectorSource::kSectors : tracks_ ? DetectorSource::kCrossings : DetectorSource::kNone;
    const Loop by_sectors = out.running ? Loop::kHall : detects_spin ? Loop::kCatchSpin : Loop::kFollow;
    out.loop = sectors_                                          ? by_sectors
               : at_.holds(State::kBrake)                        ? Loop::kCatchSpin  // which keeps the frequency found
               : tracks_                                         ? Loop::kTrack
               : at_.holds(State::kAccelerate) && !follows_rotor ? Loop::kRamp
                                                                 : Loop::kStop;
    // A rotor that was followed has a speed that is known and lasts: it is controlled, locked or not.
    out.mode = out.running || holds_      ? SpeedMode::kControl
               : detects_spin || boosts_  ? SpeedMode::kFeedForwardDrive
               : at_.holds(State::kBrake) ? SpeedMode::kFeedForwardBrake
                                          : SpeedMode::kFixed;
    out.duty = duty;
    return out;
  }

  // With load_step: full torque from the aligned position, or where a rotor that enters `sector` is.
  Step step(const In& in) const {
    if (at_.holds(State::kPullIn)) return in.at;
    if (at_.holds(State::kAccelerate)) return reverse_ ? Step(0) : Step(3);
    return reverse_ ? in.sector : next_step(in.sector, true);
  }

  StartCounters counters_;
  OpenLoopDuty open_loop_;

  States at_ = State::kIdle;
  bool drives_ = false;         // one of the states in which the bridge commutates
  bool enables_ = false;        // or one of the others in which gates may be on
  bool boosts_ = false;         // one of those whose duty comes above the back-EMF's
  bool sectors_ = false;        // a state in which the loop follows sectors: of a follower from its second clock on, after
                                // one in which all that was measured before is forgotten
  bool holds_ = false;          // while pulling in: speed control has the duty
  bool boosted_ = false;        // while pulling in: a tick has passed
  bool tracks_ = false;         // or the crossings
  bool entered_ = false;        // this is the first clock of the state
  bool braking_ = false;        // a braking interval begins
  Reason reason_ = Reason::kNone;
  bool load_step_ = false;
  bool began_ = false;
  bool failed_ = false;
  bool reverse_ = false;        // direction of this attempt
  bool clear_was_ = false;
  bool refused_ = false;        // `run` was up before the words were valid: that is no wish to start
};

}  // namespace steplock
