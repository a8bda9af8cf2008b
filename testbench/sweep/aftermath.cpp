#include "testbench/sweep/aftermath.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "testbench/run/units.hpp"

namespace steplock {
namespace {

constexpr double kStepDeg = 60;

bool claims_lock(State s) { return s == State::kRun || s == State::kSlowDown; }

}  // namespace

const char* name_of(After a) {
  constexpr const char* kNames[kAfters] = {"recovered", "latched", "silent_step_out", "unfinished",
                                           "not_started"};
  return kNames[static_cast<int>(a)];
}

Aftermath::Aftermath(const WitnessSettings& settings, Recorder* recorder)
    : settings_(settings), start_(settings, recorder), judge_(settings.advance_deg) {}

void Aftermath::disturb(const Disturbed& d) {
  disturbance_ = d;
  settings_.set_rpm = d.set_rpm;
  findings_ = {};
  findings_.outcome = After::kUnfinished;
  findings_.disturbed_s = d.from_s;
  next_look_ = d.from_s;
  last_unwell_ = d.from_s;
}

void Aftermath::changed(const plant::State& s, Watch was, Watch now, const DriveView& view,
                        double load_nm) {
  start_.changed(s, was, now, view, load_nm);
  if (!disturbance_) return;
  const bool steps = now.step() != was.step() && claims_lock(now.state());
  if (!claims_lock(now.state())) judge_.released();
  if (steps) {
    judge_.commutated(s.electrical_angle, was.step(), now.step());
    astray_ = astray_ || std::abs(std::remainder(judge_.last_deg(), 360)) > kStepDeg;
  }
  if (disturbance_->look_at_freewheeling) watch_freewheeling(s, steps, was.step(), now.step());
  if (!disturbed(s.time) || decided_) return;
  look(s);
  findings_.slips = judge_.step_outs();
  claims_ = claims_ && claims_lock(now.state());
  if (now.state() == was.state()) return;
  if (now.state() == State::kRetryDelay || now.state() == State::kFault) {
    ++findings_.retries;
    findings_.lost_locks += claims_lock(was.state());
    findings_.reason = now.reason();
    if (!findings_.lost_s) findings_.lost_s = s.time - disturbance_->from_s;
  }
  if (now.state() == State::kFault) {
    findings_.outcome = After::kLatched;
    findings_.fault_s = s.time - disturbance_->from_s;
    findings_.end_s = s.time;
    decided_ = true;
  }
}

void Aftermath::sample(const plant::State& s, Watch w, const DriveView& view, double load_nm) {
  if (s.time >= start_.next_sample()) start_.sample(s, w, view, load_nm);
  if (!disturbance_) return;
  if (disturbance_->look_at_freewheeling) watch_freewheeling(s, false, 0, 0);
  if (s.time < next_look_) return;
  next_look_ = s.time + settings_.electrical_turn_s();
  state_ = w.state();
  if (disturbed(s.time) && !decided_) {
    look(s);
    turn(s.time, s.electrical_angle, view);
  }
}

double Aftermath::next_sample() const {
  return disturbance_ ? std::min({start_.next_sample(), next_look_, next_fine_}) : start_.next_sample();
}

void Aftermath::look(const plant::State& s) {
  for (const double i : s.current) {
    findings_.peak_current_a = std::max(findings_.peak_current_a, std::abs(i));
  }
}

// The phase that a commutation switched off floats in the step it leads to, either way round.
void Aftermath::watch_freewheeling(const plant::State& s, bool commutated, int from, int to) {
  constexpr int kFloating[6] = {2, 1, 0, 2, 1, 0};
  const double fine = 1 / std::max(1.0, std::abs(degrees(s.speed)) * settings_.pole_pairs);
  if (commutated && from != to) {
    freewheels_ = kFloating[to % 6];
    freewheels_from_ = s.electrical_angle;
  }
  if (freewheels_ >= 0) {
    const double deg = std::abs(degrees(s.electrical_angle - freewheels_from_));
    if (!commutated && (s.floating[static_cast<std::size_t>(freewheels_)] || deg > kStepDeg)) {
      findings_.demagnetisation_deg = std::max(findings_.demagnetisation_deg, deg);
      freewheels_ = -1;
    }
  }
  next_fine_ = freewheels_ >= 0 ? s.time + fine : 1e9;
}

// Once per electrical turn of set speed.
void Aftermath::turn(double time, double angle, const DriveView& view) {
  findings_.end_s = time;
  const double sign = settings_.set_rpm < 0 ? -1 : 1, set = std::abs(settings_.set_rpm);
  if (!mark_) {
    mark_ = Mark{time, angle};
    return;
  }
  const double rotor = sign * rpm((angle - mark_->angle) / (time - mark_->time) / settings_.pole_pairs);
  const double drive = rpm_of_steps(view.steps_per_second, settings_.pole_pairs);
  mark_ = Mark{time, angle};
  findings_.dip = std::max(findings_.dip, 1 - rotor / set);
  const bool other = rotor < StartJudge::kStandStill * set ||
                     std::abs(rotor - drive) > StartJudge::kOtherSpeed * std::max({rotor, drive, 0.1 * set});
  const bool in_step = claims_ && !astray_ && !other;
  if (!claims_ || in_step) {
    silent_since_ = std::nullopt;
  } else if (!silent_since_) {
    silent_since_ = time;
  }
  const bool well = in_step && std::abs(rotor - set) <= StartJudge::kAtSpeed * set;
  if (!well) last_unwell_ = time;
  claims_ = claims_lock(state_);
  astray_ = false;
  if (silent_since_ && time - *silent_since_ >= StartJudge::kNoticeTime) {
    findings_.outcome = After::kSilentStepOut;
    decided_ = true;
  } else if (!disturbance_->for_good &&
             time - std::max(last_unwell_, disturbance_->until_s) >= settings_.held()) {
    findings_.outcome = After::kRecovered;
    findings_.recovery_s = last_unwell_ - disturbance_->from_s;
    decided_ = true;
  }
}

void Aftermath::time_is_over() {
  if (decided_ || !disturbance_) return;
  if (findings_.end_s - last_unwell_ < settings_.held()) return;
  findings_.outcome = After::kRecovered;
  findings_.recovery_s = last_unwell_ - disturbance_->from_s;
}

}  // namespace steplock
