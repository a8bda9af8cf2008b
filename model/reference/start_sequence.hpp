// Start sequence of Fig. 5, made safe: look for a spinning rotor, align, accelerate, pull
// in, run; slow down and brake before a reversal or a stop; bounded retries, then a latched fault.
//
// With method kFollow the steps follow the rotor instead (rotor_follower.hpp): kDetectSpin -> kAccelerate -> kPullIn.
//
//     kIdle -> kDetectSpin -> kPreAlign -> kAlign -> kAccelerate -> kPullIn -> kRun
//                    |  caught, right way ------------------------------------^   |
//                    |  caught, wrong way                      reverse, or stop by brake |
//                 kBrake <-------------------------------------------------- kSlowDown
//     a failed attempt: kRetryDelay -> kDetectSpin, `retries` times, then kFault
//
// Doc: docs/theory.md   Test: tests/model/reference/reference_start_sequence_test.cpp
#pragma once

#include "model/design/parameters.hpp"
#include "model/reference/signals.hpp"

namespace steplock::reference {

class StartSequence {
 public:
  StartSequence(const design::StartParameters&, design::Source, double tick);

  struct In {
    bool tick = false;
    Command command = {};
    Reason fatal = Reason::kNone, lost = Reason::kNone;  // from Protection
    bool fault_pin = false;
    bool updated = false, good = false;  // the phase detector took an error; it was a good one
    bool ramp_done = false;  // or the follower has caught the rotor
    bool blocked = false;    // the follower cannot move it
    bool hopeful = false;    // it has seen the rotor move
    bool still = false;      // the set speed is 0
    double frequency = 0;  // steps/s
    int caught = 0;        // detecting a spin: the rotor turns, +1 as wanted, -1 the other way
  };
  void update(const In&);

  void join(bool reverse);  // straight to kRun

  State state() const { return state_; }
  Reason reason() const { return reason_; }
  bool reverse() const { return reverse_; }
  bool entered() const { return entered_; }  // the state is new in this update
  bool locked() const { return state_ == State::kRun || state_ == State::kSlowDown; }
  int retries() const { return retries_; }

 private:
  void enter(State);
  void begin_try();
  void stopped();
  void fail(Reason);
  void forget();
  bool time_is_up(double seconds) const;
  void run(const In&);

  static constexpr long kHopes = 1024;  // ticks before a verdict, in
  static constexpr long kLasts = 128;   // ticks of which a rotor that moves from end to end counts
  static constexpr long kVerdict = 4096, kMostTicks = 4 * kVerdict - 2;  // to follow a rotor, in all attempts

  design::StartParameters p_;
  design::Source source_;
  double tick_;
  State state_ = State::kIdle;
  Reason reason_ = Reason::kNone;
  long ticks_ = 0;  // since the state was entered
  long followed_ = 0;         // ticks for which a rotor was followed, in all attempts
  bool lasts_ = false;        // that rotor moved in this part of kLasts so far
  long hoped_ = -kHopes - 1;  // the end of the last one throughout which it did
  int good_ = 0, retries_ = 0, brakes_ = 0;
  bool reverse_ = false, stopping_ = false, entered_ = false, clear_was_ = false, refused_ = false;
};

}  // namespace steplock::reference
