#include "testbench/sweep/drawn_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "model/design/design.hpp"
#include "model/design/config.hpp"
#include "testbench/drive/six_step/lockstep_engine.hpp"
#include "testbench/drive/six_step/fixed_engine.hpp"
#include "testbench/drive/six_step/float_engine.hpp"
#include "testbench/drive/six_step/rtl_engine.hpp"
#include "testbench/drive/six_step/config.hpp"
#include "testbench/run/drive_loop.hpp"
#include "testbench/sweep/run_until.hpp"
#include "testbench/sweep/sinusoidal_start.hpp"

namespace steplock {
namespace {

// The lock of a watched start.
constexpr double kWatchedTurns = 200, kWatchedTime = 1;

// Wind or weight move its rotor, so that no kick is the drive's.
bool turns_by_itself(const DrawnRun& run) {
  return run.seed.hard() && (run.hardship.kind == Trial::kSwing || run.hardship.kind == Trial::kWind);
}

// Twice the longest way to a latched fault or to set speed that the words allow, with brakes on a
// heavy rotor; then a bounded drive has decided itself.
double longest(const design::Settings& s, const design::Parameters& p) {
  const auto& t = p.start;
  double tries = t.method == design::Method::kFollow ? 4 * 4096 * p.pwm.tick() : 0;  // StartCounters
  for (int k = 0; k <= t.retries; ++k) {
    const int backoff = std::min(k, 3);  // as StartSequence makes them: reset twice as long, the ramp a quarter as steep
    tries += t.detect_spin + t.pull_in + t.retry_delay;
    if (t.method == design::Method::kFollow) continue;
    tries += std::ldexp(t.pre_align + t.align, backoff) + std::ldexp(2 * t.hand_over / t.ramp, 2 * backoff);
  }
  const double brakes = t.slow_down + 20 * (t.brake + t.detect_spin);
  return s.scenario.run_s + 2 * (tries + brakes + 10 * p.speed.target / p.speed.slew);
}

// From a settled start on.
template <class Simulation>
void disturb(Simulation& simulation, Timeline& events, Aftermath& aftermath, const DrawnRun& run,
             DrawnResult& result, const SimulateOptions& options) {
  const design::Settings& s = run.settings;
  const double clock_hz = s.control.clock_hz;
  std::vector<PinFault> faults;
  const std::uint64_t from =
      add_disturbance(events, faults, run.disturbance, run.file, s, simulation.clock());
  for (const PinFault& fault : faults) simulation.add(fault);
  const Trouble kind = run.disturbance.kind;
  const double rpm = design::rpm_of(run.file, speed_after(run.file, run.disturbance));
  const double from_s = static_cast<double>(from) / clock_hz;
  aftermath.disturb({.from_s = from_s,
                     .until_s = static_cast<double>(events.events.back().clock) / clock_hz,
                     .set_rpm = rpm * (s.scenario.reverse ? -1 : 1),
                     .for_good = for_good(kind),
                     .look_at_freewheeling = kind == Trouble::kDemagnetisation});
  const auto end = static_cast<std::uint64_t>((from_s + run.limit_s) * clock_hz);
  run_until(simulation, end, clock_hz, result, options, [&] { return aftermath.decided(); });
  aftermath.time_is_over();
}

template <class Engine>
DrawnResult simulate_with(Engine& engine, const DrawnRun& run, const SimulateOptions& options) {
  const design::Settings& s = run.settings;
  Timeline events = start_timeline(s, run.limit_s);
  if (run.seed.disturbed()) {
    for (Event& e : events.events) {
      e.command.set_speed =
          run.disturbance.set_speed * design::steps_per_second(run.file, run.file.scenario.speed_rpm);
    }
  }
  plant::Plant plant(plant_parameters(s), initial_state(s, s.scenario.start_angle_deg));

  std::optional<Recorder> recorder;
  if (options.record != nullptr || options.trace != nullptr) {
    RecorderSettings settings = recorder_settings(s, events);
    settings.steady_end_s = settings.duration_s = options.record_s > 0 ? options.record_s : run.limit_s;
    recorder.emplace(settings, options.trace);
  }
  Aftermath aftermath(witness_settings(run), recorder ? &*recorder : nullptr);
  Cosimulation simulation(engine, plant, events, aftermath, s.control.clock_hz);
  const auto began = std::chrono::steady_clock::now();
  DrawnResult result;
  run_until(simulation, events.clocks, s.control.clock_hz, result, options,
            [&] { return aftermath.start_decided(); });
  result.findings = aftermath.start();
  if (run.seed.disturbed() && result.findings.outcome == Outcome::kStarted) {
    disturb(simulation, events, aftermath, run, result, options);
  }
  result.after = aftermath.findings();
  if (options.record != nullptr) {
    *options.record = recorder->take();
    Record& r = *options.record;
    conclude(r, simulation, plant, s.control.clock_hz);
    r.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  }
  return result;
}

}  // namespace

Timeline start_timeline(const design::Settings& s, double limit_s) {
  design::Settings only_start = s;
  only_start.scenario.duration_s = limit_s;
  return timeline(only_start);
}

WitnessSettings witness_settings(const DrawnRun& run) {
  const design::Settings& s = run.settings;
  const design::ScenarioSection& n = s.scenario;
  const double part = run.seed.disturbed() ? run.disturbance.set_speed : 1;
  WitnessSettings w{.run_s = n.run_s,
                    .set_rpm = part * n.speed_rpm * (n.reverse ? -1 : 1),
                    .pole_pairs = s.motor.pole_pairs,
                    .advance_deg = s.loop.advance_deg,
                    .at_rest = n.start_speed_rpm == 0 && !turns_by_itself(run)};
  if (run.file.drive.kind == design::DriveKind::kSixStep) w.maximum_duty = static_cast<double>(run.config.speed.maximum.raw()) / 0x8000;
  if (run.seed.disturbed()) return w;
  if (run.seed.watched()) w.held_turns = kWatchedTurns, w.held_s = kWatchedTime;
  w.bounds = design::start_bounds(run.file, s);
  return w;
}

DrawnRun drawn_run(const design::Settings& file, RunSeed seed) {
  DrawnRun run;
  run.seed = seed;
  run.file = file;
  run.conditions = draw_conditions(file, seed);
  if (seed.disturbed()) run.disturbance = draw_disturbance(file, run.conditions, seed);
  if (seed.disturbed() && run.disturbance.kind == Trouble::kDemagnetisation) {
    // The load of this one comes later.
    run.conditions.load = run.conditions.fan = 0;
    run.conditions.inductance = inductance_for(file, run.disturbance);
    // Outside the envelope, so the looks of a follower are too short for it.
    run.file.start.method = design::Method::kRamp;
  }
  if (seed.hard()) {
    run.hardship = draw_hardship(file, seed);
    choose_load(run.conditions, run.hardship, file);
  }
  run.settings = settings_under(file, run.conditions, seed);
  if (seed.hard()) meet(run.settings, run.hardship, file);
  if (file.drive.kind == design::DriveKind::kSinusoidal) {
    run.limit_s = sinusoidal::longest_start(file) + witness_settings(run).held();
    return run;
  }
  run.parameters = design::design_drive(run.file).parameters;
  run.config = hls_config(design::quantise(run.parameters, file.control.clock_hz).config);
  run.limit_s = longest(run.file, run.parameters) + witness_settings(run).held();
  return run;
}

DrawnResult simulate(const DrawnRun& run, const SimulateOptions& options) {
  if (run.file.drive.kind == design::DriveKind::kSinusoidal) {
    return sinusoidal::simulate_start(run, options);
  }
  const double clock_hz = run.settings.control.clock_hz;
  if (options.rtl_beside) {
    LockstepEngine engine(run.config, clock_hz);
    DrawnResult result = simulate_with(engine, run, options);
    result.rtl_agrees = engine.found().equal();
    if (!result.rtl_agrees) {
      result.rtl_difference = fmt::format("{} at clock {}", engine.found().first_port, engine.found().first_clock);
    }
    return result;
  }
  switch (options.engine) {
    case EngineKind::kFloat: {
      FloatEngine engine(run.parameters, clock_hz);
      return simulate_with(engine, run, options);
    }
    case EngineKind::kRtl: {
      RtlEngine engine(run.config, clock_hz);
      return simulate_with(engine, run, options);
    }
    default: {
      FixedEngine engine(run.config, clock_hz);
      return simulate_with(engine, run, options);
    }
  }
}

}  // namespace steplock
