#include "testbench/drive/six_step/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "model/design/bounds.hpp"
#include "testbench/run/span.hpp"
#include "testbench/run/timeline.hpp"
#include "testbench/run/units.hpp"
#include "testbench/drive/six_step/advice.hpp"

namespace steplock {
namespace {

bool claims_lock(State s) { return s == State::kRun || s == State::kSlowDown; }

double signed_set_speed(const design::Settings& s, bool reverse) {
  return reverse ? -s.scenario.speed_rpm : s.scenario.speed_rpm;
}

SpeedResult speed_in(const Span<Sample>& p, double set_rpm) {
  SpeedResult r;
  if (!p) return r;
  r.from_s = p.first->time;
  r.to_s = p.last->time;
  r.mean_rpm = p.mean_rpm();
  r.error_percent = 100 * (r.mean_rpm - set_rpm) / std::abs(set_rpm);
  return r;
}

// When the speed, averaged over a turn of the set speed, first comes within 1 %, while locked.
std::optional<double> reached(const std::vector<Sample>& samples, double from, double to,
                              double set_rpm) {
  const double turn = 60 / std::abs(set_rpm);
  std::size_t back = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Sample& now = samples[i];
    if (now.time > to) break;
    while (samples[back].time < now.time - turn) ++back;
    if (now.time < from || back == i || !claims_lock(now.watch.state())) continue;
    const Sample& then = samples[back];
    const double mean = rpm((now.plant.angle - then.plant.angle) / (now.time - then.time));
    if (std::abs(mean - set_rpm) < 0.01 * std::abs(set_rpm)) return now.time;
  }
  return std::nullopt;
}

double last_half(double from, double to) { return from + (to - from) / 2; }
double last_fifth(double from, double to) { return to - (to - from) / 5; }

void judge_steady(Summary& sum, const Record& record, double from, double to, double set_rpm) {
  const Span<Sample> p = span(record.overview, from, to);
  sum.steady = speed_in(p, set_rpm);
  sum.ripple = ripple(record.overview, from, to, record.steady);
  sum.power = power(record.overview, from, to);
  if (!p) return;
  const Totals &a = p.first->totals, &b = p.last->totals;
  sum.rms_current_a = std::sqrt((b.current_squared - a.current_squared) / p.length());
  const auto n = static_cast<double>(b.commutations - a.commutations);
  if (n == 0) return;
  sum.phase_error_rms_deg = std::sqrt((b.phase_error_squared - a.phase_error_squared) / n);
  sum.commutation_error_mean_deg = (b.commutation_deg - a.commutation_deg) / n;
  sum.commutation_error_rms_deg = std::sqrt((b.commutation_squared - a.commutation_squared) / n);
}

void judge_load_step(Summary& sum, const design::Settings& s, const Record& record,
                     double load_step_nm) {
  const design::ScenarioSection& n = s.scenario;
  if (!n.load_step_s) return;
  const double from = *n.load_step_s;
  const double to = std::min(load_end(n), record.simulated_s);
  const double set = signed_set_speed(s, n.reverse);
  sum.load_step_nm = load_step_nm;
  sum.loaded = speed_in(span(record.overview, last_fifth(from, to), to), set);
  sum.loaded_power = power(record.overview, last_fifth(from, to), to);
  double least = std::abs(set);
  for (const Sample& x : record.overview) {
    if (x.time >= from && x.time <= to) least = std::min(least, std::abs(rpm(x.plant.speed)));
  }
  sum.load_dip_percent = 100 * (std::abs(set) - least) / std::abs(set);
}

void judge_reversal(Summary& sum, const design::Settings& s, const Record& record) {
  const design::ScenarioSection& n = s.scenario;
  if (!n.reverse_s || *n.reverse_s >= record.simulated_s) return;
  const double to = std::min(n.stop_s.value_or(n.duration_s), record.simulated_s);
  const double set = signed_set_speed(s, !n.reverse);
  bool left = false;
  for (const StateChange& c : record.changes) {
    if (c.time < *n.reverse_s || c.time > to) continue;
    left = left || c.state != State::kRun;
    if (left && c.state == State::kRun && !sum.reverse_time_s) {
      sum.reverse_time_s = c.time - *n.reverse_s;
    }
  }
  const double begun = *n.reverse_s + sum.reverse_time_s.value_or(0);
  sum.reversed = speed_in(span(record.overview, last_fifth(begun, to), to), set);
}

// Locks that ended although nobody asked: run, direction and fault pin as the scenario has them.
void judge_locks(Summary& sum, const design::Settings& s, const Record& record) {
  State was = State::kIdle;
  for (const StateChange& c : record.changes) {
    const bool stopping = s.scenario.stop_s && c.time >= *s.scenario.stop_s;
    const bool failed = c.state == State::kRetryDelay || c.state == State::kFault;
    if (claims_lock(was) && failed && !stopping) ++sum.lost_locks;
    if (failed && was != State::kRetryDelay) sum.reasons.push_back(name_of(c.reason));
    if (c.state == State::kFault) sum.fault = name_of(c.reason);
    if (c.state == State::kRun && !sum.lock_time_s) sum.lock_time_s = c.time;
    was = c.state;
  }
}

}  // namespace

Summary summarise(const design::Settings& s, const RunOptions& options, const Record& record) {
  const design::ScenarioSection& n = s.scenario;
  const Timeline events = timeline(s);
  const double set = signed_set_speed(s, n.reverse);
  const double end = std::min(events.steady_end_s, record.simulated_s);

  Summary sum;
  sum.drive = s.drive.name;
  sum.engine = name_of(options.engine);
  sum.angle_deg = options.angle_deg;
  sum.set_speed_rpm = set;
  judge_locks(sum, s, record);

  const double lock = sum.lock_time_s.value_or(n.run_s);
  const auto at_speed = reached(record.overview, lock, end, set);
  if (at_speed) sum.start_time_s = *at_speed - n.run_s;
  judge_steady(sum, record, last_half(at_speed.value_or(lock), end), end, set);
  const auto before = std::ranges::upper_bound(record.overview, end, {}, &Sample::time);
  sum.locked = before != record.overview.begin() && (before - 1)->watch.locked();
  judge_load_step(sum, s, record, events.load_step_nm);
  judge_reversal(sum, s, record);
  sum.profile = profile(s, record.simulated_s, record.overview);

  sum.step_outs = record.step_outs;
  sum.peak_current_a = record.peak_current;
  sum.current_bound_a = design::current_bound(s);
  if (!record.overview.empty()) {
    // The counters are cleared when `run` rises, so the last sample holds the whole run's.
    const DriveView& v = record.overview.back().drive;
    sum.crossings = v.crossings;
    sum.missed = v.missed;
    sum.freewheel_long = v.freewheel_long;
    sum.limit_hits = v.limit_hits;
    sum.retries = v.retries;
  }
  sum.shoot_throughs = record.shoot_throughs;
  sum.clocks = record.clocks;
  sum.simulated_s = record.simulated_s;
  sum.wall_s = record.wall_s;
  sum.clocks_per_cpu_second =
      record.cpu_s > 0 ? static_cast<double>(record.clocks) / record.cpu_s : 0;
  sum.energy_residual = record.energy_residual;
  sum.interrupted = record.interrupted;
  sum.lockstep = record.lockstep;
  sum.advice = advice(s, sum, record);
  return sum;
}

std::vector<std::string> Summary::failures() const {
  std::vector<std::string> why;
  const auto need = [&](bool holds, std::string text) {
    if (!holds) why.push_back(std::move(text));
  };
  const auto speed = [&](const char* what, const SpeedResult& r, double tolerance) {
    need(std::abs(r.error_percent) <= tolerance && r.to_s > r.from_s,
         fmt::format("{}: mean speed {:.1f} rpm, {:+.3f} % off", what, r.mean_rpm, r.error_percent));
  };
  need(!interrupted, "interrupted");
  need(locked, "not locked at the end of the undisturbed run");
  need(step_outs == 0, fmt::format("{} steps slipped", step_outs));
  need(lost_locks == 0, fmt::format("{} locks lost", lost_locks));
  need(fault == "none", fmt::format("fault latched: {}", fault));
  need(peak_current_a <= current_bound_a,
       fmt::format("phase current: {:.2f} A, beyond its bound of {:.2f} A", peak_current_a, current_bound_a));
  need(shoot_throughs == 0, fmt::format("{} shoot-throughs", shoot_throughs));
  speed("steady", steady, kSpeedTolerancePercent);
  if (loaded) speed("under load", *loaded, kRecoveredPercent);
  if (reversed) speed("in reverse", *reversed, kSpeedTolerancePercent);
  if (reversed) need(reverse_time_s.has_value(), "no lock in reverse");
  for (const std::string& line : steplock::failures(profile)) need(false, line);
  need(!lockstep || lockstep->equal(), "the RTL is not its C++");
  need(!float_errors || float_errors->within(), "fixed point is beyond its error budget");
  return why;
}

}  // namespace steplock
