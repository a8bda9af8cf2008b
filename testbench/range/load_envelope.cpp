#include "testbench/range/load_envelope.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "model/design/design.hpp"
#include "model/design/config.hpp"
#include "testbench/drive/six_step/recorder.hpp"
#include "testbench/drive/six_step/fixed_engine.hpp"
#include "testbench/drive/six_step/config.hpp"
#include "testbench/run/cosimulation.hpp"
#include "testbench/run/drive_loop.hpp"
#include "testbench/run/units.hpp"

namespace steplock {
namespace {

constexpr int kStairs = 20;
constexpr double kHeld = 0.05;         // of the set speed; the load is rising all the time
constexpr double kLeastStair = 0.08;   // s
constexpr double kNoticeTime = 0.5;    // s, as of a sweep: by then a drive must have noticed
constexpr double kTurnsPerStair = 12;  // electrical

struct Plan {
  Timeline timeline;
  double first_s = 0, stair_s = 0, stair_nm = 0;
};

// When a load may be added: the file's own time for its load step, by which its set speed stands.
Plan plan_for(const design::Settings& s, double rpm, double most_nm) {
  const design::ScenarioSection& n = s.scenario;
  Plan p;
  p.first_s = n.load_step_s.value_or(n.duration_s / 2);
  p.stair_s = std::max(kLeastStair, kTurnsPerStair * 60 / (rpm * s.motor.pole_pairs));
  p.stair_nm = most_nm / kStairs;
  const auto clock = [&](double t) { return static_cast<std::uint64_t>(t * s.control.clock_hz); };
  p.timeline.events.push_back({0, {}, 0, "off"});
  p.timeline.events.push_back({clock(n.run_s), {.run = true}, 0, "run"});
  for (int i = 1; i <= kStairs; ++i) {
    p.timeline.events.push_back({clock(p.first_s + (i - 1) * p.stair_s), {.run = true},
                                 i * p.stair_nm, "load"});
  }
  const double end = p.first_s + kStairs * p.stair_s;
  p.timeline.clocks = clock(end + kNoticeTime);  // the last stair goes on
  p.timeline.steady_end_s = end;
  return p;
}

// Mean speed over the second half of stair i; 0 is the span before the first one.
double mean_rpm(const Record& record, const Plan& p, int i) {
  const double to = p.first_s + i * p.stair_s, from = to - p.stair_s / 2;
  const auto a = std::ranges::lower_bound(record.overview, from, {}, &Sample::time);
  const auto b = std::ranges::lower_bound(record.overview, to, {}, &Sample::time);
  if (a >= b || b == record.overview.end()) return 0;
  return rpm((b->plant.angle - a->plant.angle) / (b->time - a->time));
}

}  // namespace

LoadPoint measure_load(const design::Settings& s, double set_rpm, double most_nm) {
  design::Parameters parameters = design::design_drive(s).parameters;
  parameters.speed.target = design::steps_per_second(s, set_rpm);
  const double clock_hz = s.control.clock_hz;
  FixedEngine engine(hls_config(design::quantise(parameters, clock_hz).config), clock_hz);
  const Plan plan = plan_for(s, set_rpm, most_nm);

  plant::Plant plant(plant_parameters(s), initial_state(s, s.scenario.start_angle_deg));
  RecorderSettings settings = recorder_settings(s, plan.timeline);
  settings.duration_s = plan.timeline.steady_end_s;
  settings.electrical_turn_s = 60 / (set_rpm * s.motor.pole_pairs);
  Recorder recorder(settings);
  Cosimulation simulation(engine, plant, plan.timeline, recorder, clock_hz);
  // Until the lock is gone; what the drive does then is another matter (docs/sweep.md).
  const auto look = static_cast<std::uint64_t>(plan.stair_s * clock_hz / 4);
  bool was_locked = false;
  double lost_s = plan.timeline.steady_end_s + kNoticeTime;
  LoadPoint point{.rpm = set_rpm, .how = "kept"};
  while (simulation.clock() < plan.timeline.clocks) {
    simulation.run_until(std::min(plan.timeline.clocks, simulation.clock() + look));
    const double now = static_cast<double>(simulation.clock()) / clock_hz;
    const bool locked = engine.watch().locked();
    if (now < plan.first_s) continue;
    if (!was_locked && !locked) break;
    was_locked = true;
    if (!locked || recorder.step_outs() > 0) lost_s = std::min(lost_s, now);
    if (!locked) {
      point.how = name_of(engine.watch().reason());
      break;
    }
    if (now > lost_s + kNoticeTime) {
      point.how = "silent";
      break;
    }
  }
  const Record record = recorder.take();
  point.locked = was_locked;
  if (!was_locked) return point;
  for (int i = 0; i <= kStairs && plan.first_s + i * plan.stair_s < lost_s; ++i) {
    const double mean = mean_rpm(record, plan, i);
    if (mean <= 0) break;
    if (std::abs(mean - set_rpm) <= kHeld * set_rpm) point.held_nm = i * plan.stair_nm;
    point.kept_nm = i * plan.stair_nm;
    point.least_rpm = mean;
  }
  return point;
}

LoadEnvelope measure_envelope(const DriveFile& file, const std::string& stem, int only,
                              const std::function<bool(double done)>& progress) {
  const design::Settings& s = file.settings;
  const design::Design d = design::design_drive(s);
  LoadEnvelope e{s.drive.name, stem, d.rated_torque, rpm(d.motor.no_load), {}};
  // Beyond the limit's current no torque can be had.
  const double most = 1.2 * d.motor.k_e * s.sensors.limit_a;
  constexpr int kSpeeds = 4;
  const double low = 1.3 * d.hand_over_rpm, high = std::min(s.scenario.speed_rpm, 0.9 * e.no_load_rpm);
  for (int i = 0; i < kSpeeds; ++i) {
    if (only != 0 && only != i + 1) continue;
    e.points.push_back(measure_load(s, low + (high - low) * i / (kSpeeds - 1), most));
    if (progress && !progress(double(i + 1) / kSpeeds)) throw Stopped();
  }
  return e;
}

Figure envelope_figure(const LoadEnvelope& e) {
  Figure f{.name = "load_" + e.file, .title = e.drive + ": load that it takes", .axis = "set speed, r/min",
           .caption = "Opposing torque, raised slowly at a set speed: up to where the speed is held, and up to "
                      "where the lock is kept."};
  Curve held{"speed held", palette::kV, {}, 1.6}, kept{"lock kept", palette::kU, {}, 1.6},
      rated{"rated", palette::kQuiet, {}, 1};
  for (const LoadPoint& p : e.points) {
    if (!p.locked) continue;
    held.points.push_back({p.rpm, p.held_nm});
    kept.points.push_back({p.rpm, p.kept_nm});
    rated.points.push_back({p.rpm, e.rated_nm});
  }
  f.panels.push_back({.label = "torque, N m", .curves = {held, kept, rated}, .weight = 1.8,
                      .extra = "set yrange [0:*]\n"});
  return f;
}

std::string envelope_page(const std::vector<LoadEnvelope>& all) {
  std::string text = fmt::format(
      "# Load\n\nPrinted by `steplock envelope`; the test `pages_are_current_load` fails when this page is stale.\n\n"
      "Each drive is started, brought to a set speed, and loaded: an opposing torque rises in {} stairs to 1.2 times "
      "what the current limit can give (engine `fixed`, which equals the RTL on every clock; words as in the "
      "drive's file). *Held*: the speed stayed within {:.0f} %. *Kept*: the lock did, at whatever speed the "
      "voltage allowed. *End*: the reason that the drive gave when the lock ended; `silent` would be a step lost "
      "unnoticed. Every torque is also given in parts of the rated one.\n",
      kStairs, 100 * kHeld);
  for (const LoadEnvelope& e : all) {
    text += fmt::format("\n## {}\n\nRated {:.3g} N m; no load at {:.0f} r/min. [{}.toml](../drives/{}.toml)\n\n"
                        "| set speed, r/min | held, N m | of rated | kept, N m | of rated | at, r/min | end |\n"
                        "|---:|---:|---:|---:|---:|---:|---|\n",
                        e.drive, e.rated_nm, e.no_load_rpm, e.file, e.file);
    for (const LoadPoint& p : e.points) {
      text += p.locked ? fmt::format("| {:.0f} | {:.3g} | {:.2f} | {:.3g} | {:.2f} | {:.0f} | {} |\n", p.rpm,
                                     p.held_nm, p.held_nm / e.rated_nm, p.kept_nm, p.kept_nm / e.rated_nm,
                                     p.least_rpm, p.how)
                       : fmt::format("| {:.0f} | no lock | | | | | |\n", p.rpm);
    }
    text += fmt::format("\n![{}](figures/load_{}.svg)\n", envelope_figure(e).title, e.file);
  }
  return text;
}

}  // namespace steplock
