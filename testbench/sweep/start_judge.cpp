#include "testbench/sweep/start_judge.hpp"

#include <algorithm>
#include <cmath>

#include "testbench/run/units.hpp"

namespace steplock {

const char* name_of(Outcome o) {
  constexpr const char* kNames[] = {"started", "rough", "latched", "silent_step_out", "unfinished"};
  return kNames[static_cast<int>(o)];
}

const char* name_of(Cause c) {
  constexpr const char* kNames[] = {"lock_lost", "outrun", "not_pulled_in", "wrong_way", "too_weak", "not_followed"};
  return kNames[static_cast<int>(c)];
}

double WitnessSettings::electrical_turn_s() const { return 60 / (std::abs(set_rpm) * pole_pairs); }

void StartJudge::look(const plant::State& s) {
  for (const double i : s.current) {
    findings_.peak_current_a = std::max(findings_.peak_current_a, std::abs(i));
  }
  if (!first_angle_) {
    first_angle_ = s.electrical_angle;
    if (settings_.at_rest) findings_.kick_deg = findings_.peak_speed = 0;
  }
  if (!findings_.kick_deg) return;
  const double turned = rpm(s.speed) * way() / std::abs(settings_.set_rpm);
  findings_.peak_speed = std::max(*findings_.peak_speed, turned);
  const double back = (*first_angle_ - s.electrical_angle) * way();
  findings_.kick_deg = std::max(*findings_.kick_deg, degrees(back));
}

void StartJudge::failed(bool claimed_lock, bool for_good, double time) {
  ++findings_.retries;
  findings_.lost_locks += claimed_lock;
  if (!for_good) return;
  findings_.outcome = Outcome::kLatched;
  findings_.end_s = time;
}

void StartJudge::caused(const plant::State& s, bool claimed_lock, bool pulled_in, double drive_rpm) {
  const double rotor = rpm(s.speed) * way(), slow = kSlow * std::abs(settings_.set_rpm);
  const Cause cause = claimed_lock                           ? Cause::kLockLost
                      : pulled_in && rotor < drive_rpm / 2   ? Cause::kOutrun
                      : pulled_in                            ? Cause::kNotPulledIn
                      : rotor < -slow                        ? Cause::kWrongWay
                      : rotor < slow                         ? Cause::kTooWeak
                                                             : Cause::kNotFollowed;
  findings_.causes += (findings_.causes.empty() ? "" : "+") + std::string(name_of(cause));
}

void StartJudge::claims(bool lock, double time) {
  lock_at_ = slipped_at_ = astray_at_ = full_at_ = highest_at_ = findings_.speed_time_s = std::nullopt;
  slips_before_ = findings_.slips;
  if (lock) {
    lock_at_ = time;
    findings_.lock_time_s = time - settings_.run_s;
  }
}

void StartJudge::slipped(std::uint64_t in_total, double time) {
  findings_.slips = in_total;
  if (findings_.slips > slips_before_ && !slipped_at_) slipped_at_ = time;
}

void StartJudge::turn(const plant::State& s, double drive_rpm, double duty) {
  next_look_ = s.time + settings_.electrical_turn_s();
  marks_.push_back({s.time, s.electrical_angle});
  if (marks_.size() > kAtSpeedTurns + 1) marks_.pop_front();
  judge(s.time, drive_rpm, duty);
}

double StartJudge::mean_rpm(std::size_t turns) const {
  const Mark &last = marks_.back(), &first = marks_[marks_.size() - 1 - turns];
  return rpm((last.angle - first.angle) / (last.time - first.time) / settings_.pole_pairs);
}

// A rotor that stands, or turns the other way, is in no lock even if the drive says that it is slow.
bool StartJudge::other_speed(double drive_rpm) const {
  if (marks_.size() < 2) return false;
  const double set = std::abs(settings_.set_rpm);
  const double rotor = mean_rpm(1) * way();
  if (rotor < kStandStill * set) return true;
  return std::abs(rotor - drive_rpm) > kOtherSpeed * std::max({rotor, drive_rpm, 0.1 * set});
}

// Below the set speed all the while, as the caller knows.
bool StartJudge::bus_gives_no_more(double time, double duty) {
  const double rpm = std::abs(mean_rpm(kAtSpeedTurns));
  if (duty < settings_.maximum_duty) {
    full_at_ = std::nullopt;
  } else if (!full_at_ || rpm > (1 + kCreeps) * full_rpm_) {
    full_at_ = time;
    full_rpm_ = rpm;
  }
  return full_at_ && time - *full_at_ >= std::max(1.0, settings_.held());
}

// Told apart from one that has arrived: the end of a ramp is passed after the speed was first near the set speed.
bool StartJudge::rises(double time) {
  const double rpm = mean_rpm(kAtSpeedTurns) * way();
  if (!highest_at_ || rpm > (1 + kCreeps) * highest_rpm_) {
    highest_at_ = time;
    highest_rpm_ = rpm;
  }
  return time - *highest_at_ < kRisesTurns * settings_.electrical_turn_s();
}

void StartJudge::judge(double time, double drive_rpm, double duty) {
  findings_.end_s = time;
  if (!lock_at_ || decided()) return;
  if (!slipped_at_ && !other_speed(drive_rpm)) {
    astray_at_ = std::nullopt;
  } else if (!astray_at_) {
    astray_at_ = slipped_at_.value_or(time);
  }
  if (astray_at_) {
    full_at_ = std::nullopt;
    if (time - *astray_at_ >= kNoticeTime) findings_.outcome = Outcome::kSilentStepOut;
    return;
  }
  const double set = settings_.set_rpm;
  if (marks_.size() <= kAtSpeedTurns) return;
  const bool higher = rises(time) && findings_.peak_speed;
  if (std::abs(mean_rpm(kAtSpeedTurns) - set) > kAtSpeed * std::abs(set)) {
    const bool below = mean_rpm(kAtSpeedTurns) * way() < std::abs(set);
    if (below && bus_gives_no_more(time, duty)) findings_.beyond = "bus";
    return;
  }
  if (!findings_.speed_time_s) findings_.speed_time_s = time - settings_.run_s;
  if (time - *lock_at_ < settings_.held() || higher) return;
  findings_.beyond = beyond();
  findings_.outcome = findings_.beyond.empty() ? Outcome::kStarted : Outcome::kRough;
}

std::string StartJudge::beyond() const {
  if (!settings_.bounds) return "";
  const design::StartBounds& b = *settings_.bounds;
  const Findings& f = findings_;
  std::string text;
  const auto add = [&](const char* what, double x, double bound) {
    if (x > bound) text += (text.empty() ? "" : "+") + std::string(what);
  };
  add("current", f.peak_current_a, b.current_a);
  add("kick", f.kick_deg.value_or(0), b.kick_deg);
  add("speed", f.peak_speed.value_or(0), b.speed);
  add("lock", f.lock_time_s.value_or(0), b.lock_s);
  return text;
}

}  // namespace steplock
