#include "testbench/sweep/witness.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "testbench/run/units.hpp"

namespace steplock {
namespace {

bool claims_lock(State s) { return s == State::kRun || s == State::kSlowDown; }

}  // namespace

const char* name_of(Outcome o) {
  constexpr const char* kNames[] = {"started", "latched", "silent_step_out", "unfinished"};
  return kNames[static_cast<int>(o)];
}

double WitnessSettings::electrical_turn_s() const { return 60 / (std::abs(set_rpm) * pole_pairs); }

Witness::Witness(const WitnessSettings& settings, Recorder* recorder)
    : settings_(settings), recorder_(recorder), judge_(settings.advance_deg) {}

void Witness::changed(const plant::State& s, Watch was, Watch now, const DriveView& view,
                      double load_nm) {
  look(s);
  if (now.state() != was.state()) entered(was.state(), now.state(), now.reason(), s.time);
  if (!claims_lock(now.state())) judge_.released();
  if (now.step() != was.step() && claims_lock(now.state())) {
    judge_.commutated(s.electrical_angle, was.step(), now.step());
    findings_.slips = judge_.step_outs();
    if (findings_.slips > slips_before_ && !slipped_at_) slipped_at_ = s.time;
  }
  if (recorder_) recorder_->changed(s, was, now, view, load_nm);
}

void Witness::sample(const plant::State& s, Watch w, const DriveView& view, double load_nm) {
  look(s);
  if (s.time >= next_look_) {
    next_look_ = s.time + settings_.electrical_turn_s();
    marks_.push_back({s.time, s.electrical_angle});
    if (marks_.size() > kAtSpeedTurns + 1) marks_.pop_front();
    judge(s.time, view);
  }
  if (recorder_ && s.time >= recorder_->next_sample()) recorder_->sample(s, w, view, load_nm);
}

double Witness::next_sample() const {
  return recorder_ ? std::min(next_look_, recorder_->next_sample()) : next_look_;
}

void Witness::pins_changed(double time, const plant::Pins& pins) {
  if (recorder_) recorder_->pins_changed(time, pins);
}

// At every gate edge, where the current of a chopped motor has its peaks.
void Witness::look(const plant::State& s) {
  for (const double i : s.current) {
    findings_.peak_current_a = std::max(findings_.peak_current_a, std::abs(i));
  }
  if (!first_angle_) {
    first_angle_ = s.electrical_angle;
    if (settings_.at_rest) findings_.kick_deg = 0;
  }
  if (!findings_.kick_deg) return;
  const double back = (*first_angle_ - s.electrical_angle) * (settings_.set_rpm < 0 ? -1 : 1);
  findings_.kick_deg = std::max(*findings_.kick_deg, degrees(back));
}

void Witness::entered(State was, State is, Reason reason, double time) {
  if (is == State::kRest || is == State::kFault) {
    ++findings_.retries;
    findings_.lost_locks += claims_lock(was);
    findings_.reason = reason;
  }
  if (is == State::kFault) {
    findings_.outcome = Outcome::kLatched;
    findings_.end_s = time;
  }
  if (claims_lock(is) == claims_lock(was)) return;
  lock_at_ = slipped_at_ = astray_at_ = findings_.speed_time_s = std::nullopt;
  slips_before_ = judge_.step_outs();
  if (claims_lock(is)) {
    lock_at_ = time;
    findings_.lock_time_s = time - settings_.run_s;
  }
}

double Witness::mean_rpm(std::size_t turns) const {
  const Mark &last = marks_.back(), &first = marks_[marks_.size() - 1 - turns];
  return rpm((last.angle - first.angle) / (last.time - first.time) / settings_.pole_pairs);
}

// A rotor that stands, or turns the other way, is in no lock even if the drive says that it is slow.
bool Witness::other_speed(const DriveView& view) const {
  if (marks_.size() < 2) return false;
  const double set = std::abs(settings_.set_rpm);
  const double rotor = mean_rpm(1) * (settings_.set_rpm < 0 ? -1 : 1);
  const double drive = rpm_of_steps(view.steps_per_second, settings_.pole_pairs);
  if (rotor < kStandStill * set) return true;
  return std::abs(rotor - drive) > kOtherSpeed * std::max({rotor, drive, 0.1 * set});
}

void Witness::judge(double time, const DriveView& view) {
  findings_.end_s = time;
  if (!lock_at_ || decided()) return;
  if (!slipped_at_ && !other_speed(view)) {
    astray_at_ = std::nullopt;
  } else if (!astray_at_) {
    astray_at_ = slipped_at_.value_or(time);
  }
  if (astray_at_) {
    if (time - *astray_at_ >= kNoticeTime) findings_.outcome = Outcome::kSilentStepOut;
    return;
  }
  const double set = settings_.set_rpm;
  if (marks_.size() <= kAtSpeedTurns ||
      std::abs(mean_rpm(kAtSpeedTurns) - set) > kAtSpeed * std::abs(set)) {
    return;
  }
  if (!findings_.speed_time_s) findings_.speed_time_s = time - settings_.run_s;
  if (time - *lock_at_ >= kHeldTurns * settings_.electrical_turn_s()) {
    findings_.outcome = Outcome::kStarted;
  }
}

}  // namespace steplock
