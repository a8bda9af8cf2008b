#include "testbench/disturb/sinusoidal_disturbance.hpp"

#include <fmt/format.h>

#include "model/design/design.hpp"
#include "testbench/disturb/sinusoidal_aftermath.hpp"
#include "testbench/run/drive_loop.hpp"
#include "testbench/drive/sinusoidal/float_engine.hpp"
#include "testbench/drive/sinusoidal/lockstep_engine.hpp"
#include "testbench/sweep/run_until.hpp"

namespace steplock::sinusoidal {
namespace {

// A fault for good that no test of the drive has noticed by then, it never will: the slowest takes a second (sinusoidal_protection).
constexpr double kNoticed = 5;  // s

// From a settled start on.
template <class Simulation>
void disturb(Simulation& simulation, Timeline& events, Aftermath& aftermath, const DrawnRun& run, DrawnResult& result,
             const SimulateOptions& options) {
  const double clock_hz = run.settings.control.clock_hz;
  std::vector<PinFault> none;
  const std::uint64_t from = add_disturbance(events, none, run.disturbance, run.file, run.settings, simulation.clock());
  const double from_s = static_cast<double>(from) / clock_hz;
  const double rpm = design::rpm_of(run.file, speed_after(run.file, run.disturbance));
  aftermath.disturb({.from_s = from_s,
                     .until_s = static_cast<double>(events.events.back().clock) / clock_hz,
                     .set_rpm = rpm * (run.settings.scenario.reverse ? -1 : 1),
                     .for_good = for_good(run.disturbance.kind)});
  run_until(simulation, static_cast<std::uint64_t>((from_s + run.limit_s) * clock_hz), clock_hz, result, options,
            [&] {
              const double passed = static_cast<double>(simulation.clock()) / clock_hz - from_s;
              return aftermath.decided() || (for_good(run.disturbance.kind) && aftermath.findings().retries == 0 && passed > kNoticed);
            });
  aftermath.time_is_over();
}

template <class Engine>
DrawnResult simulate_with(Engine& engine, const DrawnRun& run, const SimulateOptions& options) {
  const design::Settings& s = run.settings;
  const double clock_hz = s.control.clock_hz;
  Timeline events = start_timeline(s, run.limit_s);
  for (Event& e : events.events) {
    e.command.set_speed = run.disturbance.set_speed * design::steps_per_second(run.file, run.file.scenario.speed_rpm);
  }
  plant::Plant plant(plant_parameters(s), initial_state(s, s.scenario.start_angle_deg));
  std::optional<Recorder> recorder;
  if (options.sinusoidal_record != nullptr || options.trace != nullptr) {
    RecorderSettings settings = recorder_settings(s, events);
    settings.steady_end_s = settings.duration_s = options.record_s > 0 ? options.record_s : run.limit_s;
    recorder.emplace(settings, options.trace);
  }
  Aftermath aftermath(witness_settings(run), recorder ? &*recorder : nullptr);
  Cosimulation<Engine, Aftermath> simulation(engine, plant, events, aftermath, clock_hz);
  DrawnResult result;
  run_until(simulation, events.clocks, clock_hz, result, options, [&] { return aftermath.start_decided(); });
  result.findings = aftermath.start();
  if (result.findings.outcome == Outcome::kStarted) {
    disturb(simulation, events, aftermath, run, result, options);
    result.findings.sinusoidal_reason = aftermath.reason();
  }
  result.after = aftermath.findings();
  if (options.sinusoidal_record != nullptr) {
    *options.sinusoidal_record = recorder->take();
    conclude(*options.sinusoidal_record, simulation, plant, clock_hz);
  }
  return result;
}

}  // namespace

bool meets(Trouble kind) {
  switch (kind) {
    case Trouble::kLoadStep:
    case Trouble::kLoadPulse:
    case Trouble::kSetSpeed:
    case Trouble::kBusDip:
    case Trouble::kOpenPhase:
    case Trouble::kInertia: return true;
    default: return false;
  }
}

RunSeed disturbed_seed(const design::Settings& file, const SweepKind& kind, std::uint64_t index) {
  constexpr std::uint64_t kBeyondAnyIndex = std::uint64_t{1} << 40;
  for (std::uint64_t k = index;; k += kBeyondAnyIndex) {
    const RunSeed seed = run_seed(kind, k);
    if (meets(draw_disturbance(file, draw_conditions(file, seed), seed).kind)) return seed;
  }
}

DrawnResult simulate_disturbed(const DrawnRun& run, const SimulateOptions& options) {
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
  if (options.engine == EngineKind::kFloat) {
    FloatEngine engine(run.file, adc);
    return simulate_with(engine, run, options);
  }
  if (options.engine == EngineKind::kRtl) {
    RtlEngine engine(run.file, adc);
    return simulate_with(engine, run, options);
  }
  FixedEngine engine(run.file, adc);
  return simulate_with(engine, run, options);
}

std::optional<Row> disturbed_row(std::uint64_t index, const std::string& drive, const design::Settings& file, RunSeed seed,
                                 const std::function<bool()>& go_on) {
  const DrawnRun run = drawn_run(file, seed);
  const DrawnResult result = simulate_disturbed(run, {.go_on = go_on});
  if (result.stopped) return std::nullopt;
  Row row{.index = index, .drive = drive, .seed = seed.value, .outside = false, .rtl = "",
          .conditions = run.conditions, .findings = result.findings, .disturbance = run.disturbance,
          .hardship = {}, .after = result.after, .kind = file.drive.kind};
  if (!seed.on_rtl()) return row;
  const DrawnResult again = simulate_disturbed(run, {.rtl_beside = true, .go_on = go_on});
  if (again.stopped) return std::nullopt;
  Row other = row;
  other.findings = again.findings;
  other.after = again.after;
  row.rtl = !again.rtl_agrees                  ? again.rtl_difference
            : csv_line(other) != csv_line(row) ? "another outcome"
                                               : "equal";
  return row;
}

}  // namespace steplock::sinusoidal
