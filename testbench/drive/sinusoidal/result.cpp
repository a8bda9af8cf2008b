// What a run amounts to, as numbers, JSON and text.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "model/design/bounds.hpp"
#include "model/design/design.hpp"
#include "model/design/settings_keys.hpp"
#include "testbench/drive/sinusoidal/advice.hpp"
#include "testbench/drive/sinusoidal/run.hpp"

namespace steplock::sinusoidal {
namespace {

const Sample* at_or_after(const std::vector<Sample>& samples, double time) {
  const auto found = std::ranges::lower_bound(samples, time, {}, &Sample::time);
  return found == samples.end() ? nullptr : &*found;
}

double mean_rpm(const Sample& a, const Sample& b) {
  return rpm((b.plant.angle - a.plant.angle) / (b.time - a.time));
}

// When the speed first comes within 1 %, locked.
std::optional<double> reached(const std::vector<Sample>& samples, double set) {
  for (const Sample& s : samples) {
    if (s.watch.locked() && std::abs(rpm(s.plant.speed) - set) < 0.01 * std::abs(set)) return s.time;
  }
  return std::nullopt;
}

void judge_steady(Result& r, const std::vector<Sample>& samples, const std::vector<Sample>& fine, double from, double to) {
  const Sample *a = at_or_after(samples, from + (to - from) / 2), *b = at_or_after(samples, to);
  if (!b && !samples.empty()) b = &samples.back();
  if (!a || !b || b->time <= a->time) return;
  r.mean_rpm = mean_rpm(*a, *b);
  r.ripple = ripple(samples, a->time, b->time, fine);
  r.power = power(samples, a->time, b->time);
  for (const Sample& x : samples) {
    if (x.time >= a->time && x.time <= b->time) r.delta_theta_worst_deg = std::max(r.delta_theta_worst_deg, std::abs(x.delta_theta_deg));
  }
  r.speed_error_percent = 100 * (r.mean_rpm - r.set_speed_rpm) / std::abs(r.set_speed_rpm);
  r.rms_current_a = std::sqrt((b->totals.current_squared - a->totals.current_squared) /
                              (b->time - a->time));
  const auto n = static_cast<double>(b->totals.angles - a->totals.angles);
  if (n == 0) return;
  r.delta_theta_mean_deg = (b->totals.angle_deg - a->totals.angle_deg) / n;
  r.delta_theta_rms_deg = std::sqrt((b->totals.angle_squared - a->totals.angle_squared) / n);
}

void judge_load(Result& r, const design::Settings& s, const std::vector<Sample>& samples) {
  const auto& n = s.scenario;
  if (!n.load_step_s) return;
  const double from = *n.load_step_s;
  const double to = load_end(n);
  r.load_step_nm = design::load_step_torque(s);
  double least = std::abs(r.set_speed_rpm), worst = 0;
  for (const Sample& x : samples) {
    if (x.time < from || x.time > to) continue;
    least = std::min(least, std::abs(rpm(x.plant.speed)));
    worst = std::max(worst, std::abs(x.delta_theta_deg));
  }
  r.load_dip_percent = 100 * (1 - least / std::abs(r.set_speed_rpm));
  r.loaded_delta_theta_worst_deg = worst;
  const Sample *a = at_or_after(samples, to - (to - from) / 5), *b = at_or_after(samples, to);
  if (!b && !samples.empty()) b = &samples.back();
  if (a && b && b->time > a->time) {
    r.loaded_error_percent =
        100 * (mean_rpm(*a, *b) - r.set_speed_rpm) / std::abs(r.set_speed_rpm);
    r.loaded_power = power(samples, a->time, b->time);
  }
}

double number(double x) { return std::stod(fmt::format("{:.7g}", x)); }

}  // namespace

Result summarise(const design::Settings& s, const RunOptions& options, const Record& record) {
  Result r;
  r.drive = s.drive.name;
  r.engine = name_of(options.engine);
  r.estimator = enum_words(design::Estimator{})[static_cast<std::size_t>(s.sinusoidal.estimator)];
  r.start_by = enum_words(design::StartBy{})[static_cast<std::size_t>(s.sinusoidal_start.by)];
  r.angle_deg = options.angle_deg;
  const double way = s.scenario.reverse ? -1 : 1;
  r.set_speed_rpm = way * s.scenario.speed_rpm;
  r.peak_current_a = record.peak_current;
  r.current_bound_a = design::current_bound(s);
  r.shoot_throughs = record.shoot_throughs;
  r.clocks = record.clocks;
  r.simulated_s = record.simulated_s;
  r.wall_s = record.wall_s;
  r.cpu_s = record.cpu_s;
  r.energy_residual = record.energy_residual;
  r.interrupted = record.interrupted;
  r.lockstep = record.lockstep;
  for (const StateChange& c : record.changes) {
    if (c.state == State::kRun && !r.lock_time_s) r.lock_time_s = c.time;
    if (c.state == State::kStarting && s.sinusoidal_start.by == design::StartBy::kPilot) {
      r.position_error_deg = std::remainder(c.drive.pilot_deg - c.angle_deg, 360);
    }
    if (c.state == State::kRetryDelay || c.state == State::kFault) r.reasons.push_back(name_of(c.reason));
    if (c.state == State::kFault) r.fault = name_of(c.reason);
    if (c.state == State::kIdle) r.fault = "none";
  }
  const auto& samples = record.overview;
  if (samples.empty()) return r;
  const double origin = samples.front().plant.angle;
  const double back = way > 0 ? origin - record.least_angle_rad : record.greatest_angle_rad - origin;
  r.backward_deg = degrees(back) * s.motor.pole_pairs;
  const double steady_end = std::min(timeline(s).steady_end_s, record.simulated_s);
  if (const auto from = reached(samples, r.set_speed_rpm); from && *from < steady_end) {
    r.locked = true;
    r.speed_time_s = from;
    judge_steady(r, samples, record.steady, *from, steady_end);
  }
  judge_load(r, s, samples);
  r.profile = profile(s, record.simulated_s, samples);
  if (s.scenario.stop_s) r.stopped_rpm = rpm(samples.back().plant.speed);
  r.advice = advice(s, r, record);
  return r;
}

std::vector<std::string> Result::failures() const {
  std::vector<std::string> all;
  if (interrupted) all.push_back("interrupted");
  if (!locked) all.push_back("never locked at set speed");
  if (fault != "none") all.push_back("ended in fault: " + fault);
  if (locked && std::abs(speed_error_percent) > 0.5) {
    all.push_back(fmt::format("speed error {:.3f} %, more than 0.5 %", speed_error_percent));
  }
  if (loaded_error_percent && std::abs(*loaded_error_percent) > 2) {
    all.push_back(fmt::format("speed error under load {:.2f} %, more than 2 %", *loaded_error_percent));
  }
  if (stopped_rpm && std::abs(*stopped_rpm) > 0.01 * std::abs(set_speed_rpm)) {
    all.push_back(fmt::format("still turning at {:.1f} rpm after the stop", *stopped_rpm));
  }
  for (const std::string& line : steplock::failures(profile)) all.push_back(line);
  if (lockstep && !lockstep->equal()) all.push_back("the RTL is not its C++");
  if (float_errors && !float_errors->within()) all.push_back("fixed point is beyond its error budget");
  if (peak_current_a > current_bound_a) {
    all.push_back(fmt::format("phase current: {:.2f} A, beyond its bound of {:.2f} A", peak_current_a, current_bound_a));
  }
  if (shoot_throughs > 0) all.push_back(fmt::format("{} shoot-throughs", shoot_throughs));
  return all;
}

nlohmann::ordered_json to_json(const Result& r) {
  nlohmann::ordered_json j;
  j["drive"] = r.drive;
  j["kind"] = "sinusoidal";
  j["engine"] = r.engine;
  j["estimator"] = r.estimator;
  j["start_by"] = r.start_by;
  j["angle_deg"] = r.angle_deg;
  j["passed"] = r.failures().empty();
  j["failures"] = r.failures();
  j["advice"] = r.advice;
  const auto put = [&](const char* name, const std::optional<double>& x) {
    if (x) j[name] = number(*x);
    else j[name] = nullptr;
  };
  j["locked"] = r.locked;
  put("lock_time_s", r.lock_time_s);
  put("position_error_deg", r.position_error_deg);
  put("backward_deg", r.backward_deg);
  j["fault"] = r.fault;
  j["reasons"] = r.reasons;
  put("set_speed_rpm", r.set_speed_rpm);
  put("mean_rpm", r.mean_rpm);
  put("speed_error_percent", r.speed_error_percent);
  to_json(j, r.ripple);
  j["power"] = to_json(r.power);
  j["loaded_power"] = r.loaded_power ? to_json(*r.loaded_power) : nlohmann::ordered_json(nullptr);
  put("delta_theta_mean_deg", r.delta_theta_mean_deg);
  put("delta_theta_rms_deg", r.delta_theta_rms_deg);
  put("delta_theta_worst_deg", r.delta_theta_worst_deg);
  put("rms_current_a", r.rms_current_a);
  put("peak_current_a", r.peak_current_a);
  put("current_bound_a", r.current_bound_a);
  put("load_step_nm", r.load_step_nm);
  put("load_dip_percent", r.load_dip_percent);
  put("loaded_error_percent", r.loaded_error_percent);
  put("loaded_delta_theta_worst_deg", r.loaded_delta_theta_worst_deg);
  put("stopped_rpm", r.stopped_rpm);
  j["profile"] = nlohmann::ordered_json::array();
  for (const Piece& p : r.profile) j["profile"].push_back(to_json(p));
  j["shoot_throughs"] = r.shoot_throughs;
  j["clocks"] = r.clocks;
  put("simulated_s", r.simulated_s);
  put("wall_s", r.wall_s);
  put("cpu_s", r.cpu_s);
  put("energy_residual", r.energy_residual);
  j["fixed_against_float"] = r.float_errors ? to_json(*r.float_errors) : nlohmann::ordered_json(nullptr);
  j["rtl_equals_fixed"] = r.lockstep ? to_json(*r.lockstep) : nlohmann::ordered_json(nullptr);
  j["interrupted"] = r.interrupted;
  return j;
}

std::string to_text(const Result& r) {
  std::string t = fmt::format("{}, engine {}, {} model, start by {} from {:g} degrees\n", r.drive,
                              r.engine, r.estimator, r.start_by, r.angle_deg);
  const auto line = [&](const char* what, const std::string& text) {
    t += fmt::format("  {:<22}{}\n", what, text);
  };
  if (r.position_error_deg) {
    line("initial position", fmt::format("{:+.2f} degrees off", *r.position_error_deg));
  }
  line("lock", r.lock_time_s ? fmt::format("after {:.3f} s, {:.1f} electrical degrees backward",
                                           *r.lock_time_s, r.backward_deg)
                             : "never");
  line("speed", fmt::format("{:.2f} rpm of {:g}, error {:+.4f} %", r.mean_rpm, r.set_speed_rpm,
                            r.speed_error_percent));
  line("speed ripple", speed_text(r.ripple));
  line("torque", torque_text(r.ripple));
  line("delta theta", fmt::format("mean {:+.2f}, rms {:.2f}, at most {:.2f} degrees", r.delta_theta_mean_deg,
                                  r.delta_theta_rms_deg, r.delta_theta_worst_deg));
  line("current", fmt::format("{:.2f} A rms, peak {:.2f} A of at most {:.2f} A", r.rms_current_a, r.peak_current_a,
                              r.current_bound_a));
  if (r.load_dip_percent) {
    line("load step", fmt::format("{:.3g} N m: dip {:.1f} %, then error {:+.3f} %, delta theta at most {:.1f} degrees",
                                  *r.load_step_nm, *r.load_dip_percent,
                                  r.loaded_error_percent.value_or(0),
                                  r.loaded_delta_theta_worst_deg.value_or(0)));
  }
  line("power", to_text(r.power));
  if (r.loaded_power) line("power under load", to_text(*r.loaded_power));
  for (const Piece& p : r.profile) line("profile", to_text(p));
  if (r.stopped_rpm) line("stop", fmt::format("{:.2f} rpm at the end", *r.stopped_rpm));
  line("fault", r.reasons.empty() ? r.fault
                                  : fmt::format("{} (tries failed: {})", r.fault, fmt::join(r.reasons, ", ")));
  line("simulation", fmt::format("{:.3g} s in {:.2f} s; energy residual {:.1e}", r.simulated_s, r.wall_s,
                                 r.energy_residual));
  if (r.lockstep) line("rtl = fixed", to_text(*r.lockstep));
  if (r.float_errors) t += to_text(*r.float_errors);
  for (const std::string& f : r.failures()) line("FAILED", f);
  for (const std::string& a : r.advice) line("advice", a);
  return t;
}

}  // namespace steplock::sinusoidal
