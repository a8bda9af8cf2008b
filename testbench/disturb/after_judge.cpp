#include "testbench/disturb/after_judge.hpp"

#include <algorithm>
#include <cmath>

#include "testbench/run/units.hpp"

namespace steplock {

void AfterJudge::disturb(const Disturbed& d) {
  disturbance_ = d;
  settings_.set_rpm = d.set_rpm;
  findings_ = {};
  findings_.outcome = After::kUnfinished;
  findings_.disturbed_s = next_look_ = last_unwell_ = d.from_s;
}

void AfterJudge::look(const plant::State& s) {
  for (const double i : s.current) findings_.peak_current_a = std::max(findings_.peak_current_a, std::abs(i));
}

void AfterJudge::failed(bool claimed_lock, bool for_good, double time) {
  ++findings_.retries;
  findings_.lost_locks += claimed_lock;
  const double after = time - disturbance_->from_s;
  if (!findings_.lost_s) findings_.lost_s = after;
  if (!for_good) return;
  findings_.outcome = After::kLatched;
  findings_.fault_s = after;
  findings_.end_s = time;
  decided_ = true;
}

void AfterJudge::strayed(bool first) {
  astray_ = true;
  findings_.slips += first;
}

void AfterJudge::turn(const plant::State& s, double drive_rpm, bool claims_now) {
  next_look_ = s.time + settings_.electrical_turn_s();
  findings_.end_s = s.time;
  const double sign = settings_.set_rpm < 0 ? -1 : 1, set = std::abs(settings_.set_rpm);
  const std::optional<Mark> from = mark_;
  mark_ = Mark{s.time, s.electrical_angle};
  if (!from) return;
  const double rotor = sign * rpm((mark_->angle - from->angle) / (mark_->time - from->time) / settings_.pole_pairs);
  findings_.dip = std::max(findings_.dip, 1 - rotor / set);
  const bool other = rotor < StartJudge::kStandStill * set ||
                     std::abs(rotor - drive_rpm) > StartJudge::kOtherSpeed * std::max({rotor, drive_rpm, 0.1 * set});
  const bool in_step = claims_ && !astray_ && !other;
  if (!claims_ || in_step) {
    silent_since_ = std::nullopt;
  } else if (!silent_since_) {
    silent_since_ = s.time;
  }
  if (!in_step || std::abs(rotor - set) > StartJudge::kAtSpeed * set) last_unwell_ = s.time;
  claims_ = claims_now;
  astray_ = false;
  if (silent_since_ && s.time - *silent_since_ >= StartJudge::kNoticeTime) {
    findings_.outcome = After::kSilentStepOut;
    decided_ = true;
  } else if (!disturbance_->for_good && s.time - std::max(last_unwell_, disturbance_->until_s) >= settings_.held()) {
    recovered();
  }
}

void AfterJudge::recovered() {
  findings_.outcome = After::kRecovered;
  findings_.recovery_s = last_unwell_ - disturbance_->from_s;
  decided_ = true;
}

void AfterJudge::time_is_over() {
  if (!decided_ && disturbance_ && findings_.end_s - last_unwell_ >= settings_.held()) recovered();
}

}  // namespace steplock
