// Start sequence, the law: where each state goes, one row per state.
//
// StartSequence has for every state what leads to it, so that a state's bit waits for its own row alone, and is held to this in
// every clock.  Times and attempts are counted by StartCounters in both.
//
// Doc: docs/blocks/start_sequence.md   Test: tests/hls/start_sequence_law_test.cpp

#pragma once

#include "hls/six_step/start_sequence.hpp"

namespace steplock {

struct StartSequenceLaw {
  using In = StartSequence::In;
  using Counts = StartCounters::Out;

  // law
  State at = State::kIdle;
  Reason reason = Reason::kNone;  // of the last failed attempt, or of the fault
  bool reverse = false;           // direction of this attempt
  bool cleared = false;           // clear_fault, a clock ago
  bool refused = false;           // `run` was up before the words were valid
  bool load_step = false;         // strobe: the step is the follower's, the ramp's first, or where the rotor is
  bool began = false, failed = false, braking = false, entered = false;  // strobes

  struct Next {
    State state = State::kIdle;
    bool begins = false, brakes = false, fails = false;  // an attempt; a braking interval; the end of an attempt
  };

  Next next(const In& in, const Counts& counts) const {
    const Command& host = in.command;
    const bool wanted = host.run && !in.still, timed_out = counts.timed_out, follows = in.config.method == Method::kFollow;
    const bool hall = in.source == Source::kHall, looks = in.detects_spin && !hall && in.config.detect_spin != 0;
    const bool may_brake = at == State::kRun || at == State::kSlowDown || at == State::kBrake || at == State::kDetectSpin;
    const bool turns_round = !wanted || host.reverse != reverse;
    const bool turns_on = wanted && counts.turns_reverse == reverse;
    const State first = follows ? State::kAccelerate : State::kPreAlign;
    const Next begin{.state = looks ? State::kDetectSpin : hall ? State::kRun : first, .begins = true};
    const Next brake{.state = counts.brakes_exhausted ? State::kFault : State::kBrake, .brakes = true};
    const Next fail{.state = counts.retries_exhausted ? State::kFault : State::kRetryDelay, .fails = true};
    const auto go = [](State state) { return Next{.state = state}; };

    if (at == State::kFault) return go(host.clear_fault && !cleared && !host.run && !in.fatal ? State::kIdle : at);
    if (!host.configured) return go(State::kIdle);
    if (in.fatal) return go(State::kFault);
    if ((!wanted || refused) && !((host.brake_to_stop || in.still) && may_brake)) return go(State::kIdle);
    switch (at) {
      case State::kDetectSpin:
        // One that turns the wanted way, but slower than it may run, is started; so is one that a follower turns round.
        if (counts.count_reached && turns_on && !in.slow) return go(State::kRun);
        if (counts.count_reached && !turns_on && (in.fast || !follows || !wanted)) return brake;
        return go(!timed_out ? at : wanted ? first : State::kIdle);
      case State::kBrake: return !timed_out ? go(at) : wanted || looks ? begin : go(State::kIdle);
      case State::kPreAlign: return go(follows ? first : timed_out ? State::kAlign : at);
      case State::kAlign: return go(follows || timed_out ? State::kAccelerate : at);
      case State::kAccelerate:
        if (follows ? in.caught : in.fast) return go(State::kPullIn);
        return timed_out || in.blocked ? fail : go(at);
      case State::kPullIn: return counts.count_reached ? go(State::kRun) : timed_out ? fail : go(at);
      case State::kRun: return in.lost ? fail : go(turns_round ? State::kSlowDown : at);
      case State::kSlowDown:
        if (in.lost) return fail;
        if (!turns_round) return go(State::kRun);
        return timed_out || !in.fast ? brake : go(at);
      case State::kRetryDelay: return timed_out ? begin : go(at);
      default: return begin;  // kIdle
    }
  }

  void clock(const In& in, const Counts& counts) {
    const Next go = next(in, counts);
    const bool follows = in.config.method == Method::kFollow;
    const bool accelerates = at != State::kAccelerate && go.state == State::kAccelerate;
    const bool hands_over = at == State::kAccelerate && go.state == State::kPullIn;
    load_step = (follows ? hands_over : accelerates) || (at == State::kDetectSpin && go.state == State::kRun);
    began = go.begins && at == State::kIdle;
    failed = go.fails;
    braking = go.brakes;
    entered = go.state != at;
    if (began) {
      reason = Reason::kNone;
    } else if (go.fails || (entered && go.state == State::kFault)) {
      reason = go.brakes             ? Reason::kCannotStop
               : in.fatal || in.lost ? in.cause
               : in.blocked          ? Reason::kBlocked
                                     : Reason::kNoLock;
    }
    if (go.begins) reverse = in.command.reverse;
    cleared = in.command.clear_fault;
    refused = in.command.run && (refused || !in.command.configured);
    at = go.state;
  }
  // end of law
};

}  // namespace steplock
