#include "testbench/run/run_drive.hpp"

#include <chrono>
#include <ctime>

#include "model/design/design.hpp"
#include "model/design/words.hpp"
#include "testbench/engine/fixed.hpp"
#include "testbench/engine/float.hpp"
#include "testbench/engine/rtl.hpp"
#include "testbench/engine/words.hpp"
#include "testbench/run/cosimulation.hpp"

namespace steplock {
namespace {

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

RecorderSettings recorder_settings(const design::Settings& s, const Timeline& t) {
  return {.advance_deg = s.loop.advance_deg,
          .electrical_turn_s = 60 / (s.scenario.speed_rpm * s.motor.pole_pairs),
          .steady_end_s = t.steady_end_s,
          .duration_s = s.scenario.duration_s,
          .pwm_s = 1 / s.control.pwm_hz};
}

template <class Engine>
Record run_with(Engine& engine, const design::Settings& s, const RunOptions& options) {
  using Clock = std::chrono::steady_clock;
  const Timeline events = timeline(s);
  plant::Plant plant(plant_parameters(s), initial_state(s, options.angle_deg));
  Recorder recorder(recorder_settings(s, events), options.trace);
  Cosimulation simulation(engine, plant, events, recorder, s.control.clock_hz);

  const auto wall = Clock::now();
  const double cpu = cpu_seconds();
  auto reported = wall;
  bool interrupted = false;
  constexpr std::uint64_t kChunk = 1 << 18;  // clocks between two looks at the wall clock
  while (simulation.clock() < events.clocks && !interrupted) {
    simulation.run_until(std::min(events.clocks, simulation.clock() + kChunk));
    const auto now = Clock::now();
    if (options.progress && now - reported > std::chrono::milliseconds(100)) {
      reported = now;
      interrupted = !options.progress(static_cast<double>(simulation.clock()) /
                                      static_cast<double>(events.clocks));
    }
  }
  const plant::Energy energy = plant.state().energy;
  Record record = recorder.take();
  record.interrupted = interrupted;
  record.clocks = simulation.clock();
  record.simulated_s = static_cast<double>(record.clocks) / s.control.clock_hz;
  record.wall_s = std::chrono::duration<double>(Clock::now() - wall).count();
  record.cpu_s = cpu_seconds() - cpu;
  record.shoot_throughs = plant.shoot_throughs();
  record.energy_residual = energy.supplied > 0 ? energy.residual() / energy.supplied : 0;
  return record;
}

}  // namespace

const char* name_of(EngineKind kind) {
  switch (kind) {
    case EngineKind::kRtl: return "rtl";
    case EngineKind::kFixed: return "fixed";
    case EngineKind::kFloat: return "float";
  }
  return "";
}

Record run_drive(const design::Settings& s, const RunOptions& options) {
  const design::Design designed = design::design_drive(s);
  const double clock_hz = s.control.clock_hz;
  if (options.engine == EngineKind::kFloat) {
    FloatEngine engine(designed.parameters, clock_hz);
    return run_with(engine, s, options);
  }
  const Words words = hls_words(design::quantise(designed.parameters, clock_hz).words);
  if (options.engine == EngineKind::kFixed) {
    FixedEngine engine(words, clock_hz);
    return run_with(engine, s, options);
  }
  RtlEngine engine(words, clock_hz);
  return run_with(engine, s, options);
}

}  // namespace steplock
