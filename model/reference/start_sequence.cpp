// See start_sequence.hpp for the states; each case below is one arrow's condition.
#include "model/reference/start_sequence.hpp"

#include <algorithm>
#include <cmath>

namespace steplock::reference {
StartSequence::StartSequence(const design::StartParameters& p, design::Source source, double tick)
    : p_(p), source_(source), tick_(tick) {}

void StartSequence::enter(State s) {
  state_ = s;
  ticks_ = 0;
  good_ = 0;
  entered_ = true;
}

void StartSequence::join(bool reverse) {
  enter(State::kRun);
  entered_ = false;  // nothing to prepare: the drive runs already
  reverse_ = reverse;
  stopping_ = false;
}

bool StartSequence::time_is_up(double seconds) const {
  return ticks_ >= std::lround(seconds / tick_);
}

void StartSequence::begin_try() {
  if (source_ == design::Source::kHall) return enter(State::kRun);
  if (std::lround(p_.detect_spin / tick_) > 0) return enter(State::kDetectSpin);
  stopped();
}

// Nothing turns, as far as one can see.
void StartSequence::stopped() {
  brakes_ = 0;
  enter(stopping_                                ? State::kIdle
        : p_.method == design::Method::kFollow ? State::kAccelerate
                                               : State::kPreAlign);
}

void StartSequence::fail(Reason why) {
  reason_ = why;
  enter(State::kRetryDelay);
}

// What was tried before.
void StartSequence::forget() {
  retries_ = 0;
  followed_ = 0;
  hoped_ = -kHopes - 1;
}

void StartSequence::update(const In& in) {
  entered_ = false;
  const bool clear = in.command.clear_fault && !clear_was_;
  clear_was_ = in.command.clear_fault;
  refused_ = in.command.run && (refused_ || !in.command.configured);
  // A set speed of 0 is `run` down, and braked.
  const bool runs = in.command.run && !in.still;
  if (in.tick) ++ticks_;

  if (in.fatal != Reason::kNone && state_ != State::kFault) {
    reason_ = in.fatal;
    return enter(State::kFault);
  }
  if (!runs || !in.command.configured) forget();

  switch (state_) {
    case State::kIdle:
      stopping_ = false;
      brakes_ = 0;
      if (!runs || refused_ || !in.command.configured) return;
      reverse_ = in.command.reverse;
      reason_ = Reason::kNone;
      return begin_try();
    case State::kFault:
      if (clear && !in.command.run && !in.fault_pin) {
        reason_ = Reason::kNone;
        enter(State::kIdle);
      }
      return;
    case State::kRun:
    case State::kSlowDown:
      return run(in);
    default:
      break;
  }

  if (!in.command.configured || (!runs && !stopping_)) return enter(State::kIdle);
  switch (state_) {
    case State::kDetectSpin:
      if (in.caught > 0 && !stopping_) return enter(State::kRun);
      if (in.caught != 0) {
        if (++brakes_ <= 255) return enter(State::kBrake);
        reason_ = Reason::kCannotStop;
        return enter(State::kFault);
      }
      if (time_is_up(p_.detect_spin)) stopped();
      return;
    case State::kBrake:
      if (!time_is_up(p_.brake)) return;
      reverse_ = in.command.reverse;
      return begin_try();
    case State::kPreAlign:
      if (time_is_up(std::ldexp(p_.pre_align, std::min(retries_, 3)))) enter(State::kAlign);
      return;
    case State::kAlign:
      if (time_is_up(std::ldexp(p_.align, std::min(retries_, 3)))) enter(State::kAccelerate);
      return;
    case State::kAccelerate:
      if (in.ramp_done) return enter(State::kPullIn);
      if (in.blocked) return fail(Reason::kBlocked);
      if (p_.method == design::Method::kFollow) {
        if (in.tick) ++followed_;
        const long left = kMostTicks - followed_;
        if (left % kLasts == kLasts - 1) lasts_ = true;
        lasts_ = lasts_ && in.hopeful;
        if (left % kLasts == 0 && lasts_) hoped_ = followed_;
        const bool hopes = followed_ - hoped_ < kHopes, verdict = left % kVerdict == kVerdict - 1;
        if (left > 0 && (hopes || !verdict)) return;
        retries_ = p_.retries;  // the next one would be the same
        fail(Reason::kNoLock);
      }
      return;
    case State::kPullIn:
      if (in.updated) good_ = in.good ? good_ + 1 : 0;
      if (good_ >= p_.good_crossings) return enter(State::kRun);
      if (time_is_up(p_.pull_in)) fail(Reason::kNoLock);
      return;
    case State::kRetryDelay:
      if (!time_is_up(p_.retry_delay)) return;
      if (++retries_ > p_.retries) return enter(State::kFault);
      return begin_try();
    default:
      return;
  }
}

void StartSequence::run(const In& in) {
  if (in.lost != Reason::kNone) return fail(in.lost);
  if (ticks_ >= 1024 && state_ == State::kRun) forget();
  if (!in.command.configured) return enter(State::kIdle);
  const bool runs = in.command.run && !in.still;
  if (!runs && !in.command.brake_to_stop && !in.still) return enter(State::kIdle);
  stopping_ = !runs;
  if (state_ == State::kRun) {
    if (stopping_ || in.command.reverse != reverse_) enter(State::kSlowDown);
    return;
  }
  if (!stopping_ && in.command.reverse == reverse_) return enter(State::kRun);
  if (in.frequency <= 1.25 * p_.hand_over || time_is_up(p_.slow_down)) enter(State::kBrake);
}

}  // namespace steplock::reference
