// The sequence of the sinusoidal drive: start, run, stop, and what follows a failure.
//
//     idle -> calibrate -> pattern -> starting -> run -> slow down -> brake -> idle
//                                        |         |
//                    pilot ----------^   (failed: retry delay -> calibrate, so many times, then fault)
//
// Pattern: three places, the last of which is winding u, angle 0; forwards 240, 300 and 0 degrees (legs w, w and u, u), in
// reverse 120, 60 and 0 (v, v and u, u), so that the rotor turns the wanted way from place to place.  A load holds a rotor
// near each of them, and near its opposite; from what it leaves of one, the next is near enough to be reached.
// Pilot: PilotPulses looks for the angle; not found in `pattern` periods is an attempt that failed for want of decay.
// Starting: the loop is closed; the gates follow from the first period on that has on-times of the regulators, and the
// estimator from the period after.  Run: the speed was high enough, and the EMF belonged to it, for `lock` periods
// without a gap.
//
//     latency      1 clock; all outputs follow from registers
//     registers    61 bits     multipliers  none
//
// Doc: docs/blocks/sinusoidal_sequence.md   Test: tests/hls/sinusoidal_sequence_test.cpp

#pragma once

#include "hls/bridge/bridge.hpp"
#include "hls/sinusoidal/config.hpp"

namespace steplock {

class SinusoidalSequence {
 public:
  struct In {
    Command command;
    bool fault_pin = false;
    bool period = false;     // a PWM period begins
    bool sampled = false;    // a sample has been worked through
    bool measured = false;   // the ADCs' offsets stand
    bool fast = false;       // the speed may be trusted
    bool plausible = false;  // the EMF belongs to it
    bool stopping = false;   // slower than the stop speed
    bool found = false;      // the pilot pulses know the angle
    bool still = false;      // the set speed is 0: as if `run` were down, by braking
    SinusoidalReason fatal = SinusoidalReason::kNone;
    SinusoidalReason failed = SinusoidalReason::kNone;
    SequenceConfig config;
  };

  struct Out {
    SinusoidalState state = SinusoidalState::kIdle;
    SinusoidalReason reason = SinusoidalReason::kNone;
    bool entered = false;     // one clock: the state is new
    bool reverse = false;     // the wanted direction
    bool calibrate = false;
    bool pilot = false;       // pulses are wanted
    bool hold = false;        // legs of the pattern, or of a pilot pulse
    bool hold_u = false;      // u is one of them
    bool hold_v = false;      // v is
    bool hold_w = false;      // w is
    bool regulate = false;    // the loop is closed
    bool estimate = false;    // the estimator has seen a whole period of it
    bool modulate = false;    // gates follow the PWM
    bool brake = false;       // all low sides on
    bool slow_down = false;
    bool locked = false;
    UInt<4> retries = 0;      // attempts that failed and were followed by another one, since `run` was obeyed
  };

  Out tick(const In& in) {
    const bool regulating = is_regulating();
    const bool holding = state_ == SinusoidalState::kPattern;
    const Out out{.state = state_,
                  .reason = reason_,
                  .entered = entered_,
                  .reverse = reverse_,
                  .calibrate = state_ == SinusoidalState::kCalibrate,
                  .pilot = state_ == SinusoidalState::kPilot,
                  .hold = holding || state_ == SinusoidalState::kPilot,
                  .hold_u = state_ == SinusoidalState::kPilot || (holding && third_ != 0),
                  .hold_v = holding && third_ != 2 && reverse_,
                  .hold_w = holding && third_ != 2 && !reverse_,
                  .regulate = regulating,
                  .estimate = regulating && modulated_ >= 2,
                  .modulate = holding || (regulating && modulated_ != 0),
                  .brake = state_ == SinusoidalState::kBrake,
                  .slow_down = state_ == SinusoidalState::kSlowDown,
                  .locked = regulating && state_ != SinusoidalState::kStarting,
                  .retries = retries_};
    entered_ = false;
    // As they stand at the begin of the clock: counting and deciding are a path each.
    const bool over = timer_ == 0, trusted = trust_ == 0;
    if (in.period) timer_ = saturate<Periods>(timer_ - 1);
    if (in.period && regulated_ && modulated_ != 3) modulated_ = wrap<UInt<2>>(modulated_ + 1);
    if (in.sampled && regulating) regulated_ = true;
    if (in.sampled && !(in.fast && in.plausible)) trust_ = in.config.lock;
    if (in.period) trust_ = saturate<Periods>(trust_ - 1);

    refused_ = in.command.run && (refused_ || !in.command.configured);
    const bool alive = state_ != SinusoidalState::kFault;
    if (alive && in.fault_pin) {
      end(SinusoidalReason::kFaultPin);
    } else if (alive && in.fatal != SinusoidalReason::kNone) {
      end(in.fatal);
    } else if (alive && !in.command.configured && state_ != SinusoidalState::kIdle) {
      enter(SinusoidalState::kIdle);  // the guard has turned the bridge off: nothing goes on when it is on again
    } else {
      walk(in, over, trusted);
    }
    return out;
  }

 private:
  bool is_regulating() const {
    return state_ == SinusoidalState::kStarting || state_ == SinusoidalState::kRun ||
           state_ == SinusoidalState::kSlowDown;
  }

  void enter(SinusoidalState state) {
    state_ = state;
    entered_ = true;
  }
  void end(SinusoidalReason reason) {
    reason_ = reason;
    enter(SinusoidalState::kFault);
  }
  void fail(SinusoidalReason reason, const SequenceConfig& config) {
    const bool last = retries_ >= config.retries;
    reason_ = reason;
    timer_ = config.retry_delay;
    if (!last) retries_ = wrap<UInt<4>>(retries_ + 1);
    enter(last ? SinusoidalState::kFault : SinusoidalState::kRetryDelay);
  }
  void begin_to_turn(const SequenceConfig& config) {
    timer_ = config.give_up;
    trust_ = config.lock;
    modulated_ = 0;
    regulated_ = false;
    enter(SinusoidalState::kStarting);
  }

  void walk(const In& in, bool over, bool trusted) {
    const SequenceConfig& config = in.config;
    const bool run = in.command.run && in.command.configured && !refused_ && !in.still;
    const bool leave = !run || in.command.reverse != reverse_;
    const bool failed = in.failed != SinusoidalReason::kNone;
    switch (state_) {
      case SinusoidalState::kIdle:
        if (run) {
          reverse_ = in.command.reverse;
          retries_ = 0;
          reason_ = SinusoidalReason::kNone;
          enter(SinusoidalState::kCalibrate);
        }
        break;
      case SinusoidalState::kCalibrate:
        if (!run) {
          enter(SinusoidalState::kIdle);
        } else if (in.measured && config.arbitrary) {
          begin_to_turn(config);
        } else if (in.measured) {
          timer_ = config.pattern;
          third_ = 0;
          enter(config.pilot ? SinusoidalState::kPilot : SinusoidalState::kPattern);
        }
        break;
      case SinusoidalState::kPilot:
        if (!run) {
          enter(SinusoidalState::kIdle);
        } else if (failed) {
          fail(in.failed, config);
        } else if (in.found) {
          begin_to_turn(config);
        } else if (over) {
          fail(SinusoidalReason::kNoDecay, config);
        }
        break;
      case SinusoidalState::kPattern:
        if (!run) {
          enter(SinusoidalState::kIdle);
        } else if (over && third_ != 2) {
          timer_ = config.pattern;
          third_ = wrap<UInt<2>>(third_ + 1);
        } else if (over) {
          begin_to_turn(config);
        }
        break;
      case SinusoidalState::kStarting:
        if (leave) {
          timer_ = config.brake;
          enter(SinusoidalState::kBrake);
        } else if (failed) {
          fail(in.failed, config);
        } else if (trusted) {
          enter(SinusoidalState::kRun);
        } else if (over) {
          fail(SinusoidalReason::kNoLock, config);
        }
        break;
      case SinusoidalState::kRun:
        if (failed) {
          fail(in.failed, config);
        } else if (leave) {
          const bool slow_down = run || in.command.brake_to_stop || in.still;
          enter(slow_down ? SinusoidalState::kSlowDown : SinusoidalState::kIdle);
        }
        break;
      case SinusoidalState::kSlowDown:
        if (!leave) {
          enter(SinusoidalState::kRun);
        } else if (in.stopping) {
          timer_ = config.brake;
          enter(SinusoidalState::kBrake);
        }
        break;
      case SinusoidalState::kBrake:
        if (over) enter(SinusoidalState::kIdle);
        break;
      case SinusoidalState::kRetryDelay:
        if (!run) {
          enter(SinusoidalState::kIdle);
        } else if (over) {
          enter(SinusoidalState::kCalibrate);
        }
        break;
      case SinusoidalState::kFault:
        if (in.command.clear_fault && !in.command.run && !in.fault_pin) {
          enter(SinusoidalState::kIdle);
        }
        break;
    }
  }

  SinusoidalState state_ = SinusoidalState::kIdle;
  SinusoidalReason reason_ = SinusoidalReason::kNone;
  Periods timer_ = 0;        // periods left of the state
  Periods trust_ = 0;        // periods in which the estimate has still to be trusted
  UInt<4> retries_ = 0;        // that failed
  UInt<2> modulated_ = 0;    // periods begun under the regulators
  bool regulated_ = false;   // their first on-times stand
  UInt<2> third_ = 0;        // of the pattern
  bool reverse_ = false;
  bool refused_ = false;  // `run` was up before the words were valid: that is no wish to start
  bool entered_ = false;
};

}  // namespace steplock
