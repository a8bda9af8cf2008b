#include "testbench/sweep/sinusoidal_start.hpp"

#include <fmt/format.h>

#include "model/design/sinusoidal/design.hpp"
#include "testbench/run/drive_loop.hpp"
#include "testbench/drive/sinusoidal/float_engine.hpp"
#include "testbench/drive/sinusoidal/lockstep_engine.hpp"
#include "testbench/sweep/run_until.hpp"
#include "testbench/sweep/sinusoidal_witness.hpp"

namespace steplock::sinusoidal {
namespace {

template <class Engine>
DrawnResult simulate_with(Engine& engine, const DrawnRun& run, const SimulateOptions& options) {
  const design::Settings& s = run.settings;
  const double clock_hz = s.control.clock_hz;
  const Timeline events = start_timeline(s, run.limit_s);
  plant::Plant plant(plant_parameters(s), initial_state(s, s.scenario.start_angle_deg));
  std::optional<Recorder> recorder;
  if (options.sinusoidal_record != nullptr || options.trace != nullptr) {
    RecorderSettings settings = recorder_settings(s, events);
    settings.steady_end_s = settings.duration_s = options.record_s > 0 ? options.record_s : run.limit_s;
    recorder.emplace(settings, options.trace);
  }
  Witness witness(witness_settings(run), recorder ? &*recorder : nullptr);
  Cosimulation<Engine, Witness> simulation(engine, plant, events, witness, clock_hz);
  DrawnResult result;
  run_until(simulation, events.clocks, clock_hz, result, options, [&] { return witness.decided(); });
  result.findings = witness.findings();
  if (options.sinusoidal_record != nullptr) {
    *options.sinusoidal_record = recorder->take();
    conclude(*options.sinusoidal_record, simulation, plant, clock_hz);
  }
  return result;
}

}  // namespace

double longest_start(const design::Settings& s) {
  const auto p = design::sinusoidal::design_drive(s).parameters;
  const auto& t = p.start;
  // A lock may be found false only at the end of the way to set speed.
  const double find = t.by == design::StartBy::kPilot     ? p.pilot.decay_s
                      : t.by == design::StartBy::kPattern ? t.pattern_s
                                                          : 0;
  const double notice = p.protection.saturated_s + p.protection.slow_s + p.protection.emf_s;
  const double once = find + t.give_up_s + p.speed.target / p.speed.slew + notice + t.retry_delay_s;
  return s.scenario.run_s + 2 * (1 + t.retries) * once;
}

// The engine is the file's; ADCs belong to the plant, and are drawn.
DrawnResult simulate_start(const DrawnRun& run, const SimulateOptions& options) {
  const plant::AdcParameters adc = adc_parameters(run.settings);
  if (options.rtl_beside) {
    LockstepEngine engine(run.file, adc);
    engine.spoil(options.spoil_clock);
    DrawnResult result = simulate_with(engine, run, options);
    result.rtl_agrees = engine.found().equal();
    if (!result.rtl_agrees) {
      result.rtl_difference = fmt::format("{} at clock {}", engine.found().first_port, engine.found().first_clock);
    }
    return result;
  }
  switch (options.engine) {
    case EngineKind::kFloat: {
      FloatEngine engine(run.file, adc);
      return simulate_with(engine, run, options);
    }
    case EngineKind::kRtl: {
      RtlEngine engine(run.file, adc);
      return simulate_with(engine, run, options);
    }
    default: {
      FixedEngine engine(run.file, adc);
      return simulate_with(engine, run, options);
    }
  }
}

}  // namespace steplock::sinusoidal
