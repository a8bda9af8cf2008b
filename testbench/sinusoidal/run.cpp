#include "testbench/sinusoidal/run.hpp"

#include <chrono>
#include <ctime>

namespace steplock::sinusoidal {
Bench::Bench(const design::Settings& believed, const design::Settings& real, const Timeline& events,
             double angle_deg, std::size_t samples)
    : timeline_(events),
      clock_hz_(believed.control.clock_hz),
      plant_(plant_parameters(real), initial_state(real, angle_deg)),
      engine_(design::sinusoidal::design_drive(believed).parameters, adc_parameters(believed),
              clock_hz_),
      recorder_(static_cast<double>(events.clocks) / clock_hz_, samples),
      simulation_(engine_, plant_, timeline_, recorder_, clock_hz_) {}

void Bench::run_until(double seconds) {
  simulation_.run_until(static_cast<std::uint64_t>(seconds * clock_hz_));
}

Record Bench::take() {
  Record record = recorder_.take();
  record.clocks = simulation_.clock();
  record.simulated_s = time();
  record.shoot_throughs = plant_.shoot_throughs();
  const plant::Energy energy = plant_.state().energy;
  record.energy_residual = energy.supplied > 0 ? energy.residual() / energy.supplied : 0;
  return record;
}

Record run(const design::Settings& s, const RunOptions& options) {
  using Clock = std::chrono::steady_clock;
  const auto wall = Clock::now();
  auto reported = wall;
  const auto cpu_seconds = [] { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; };
  const double cpu = cpu_seconds();
  const Timeline events = timeline(s);
  Bench bench(s, s, events, options.angle_deg);
  bool interrupted = false;
  const double duration = s.scenario.duration_s;
  constexpr double kChunk = 0.01;  // s between two looks at the wall clock
  for (double t = kChunk; !interrupted && bench.time() < duration; t += kChunk) {
    bench.run_until(std::min(t, duration) + 0.5 / s.control.clock_hz);
    const auto now = Clock::now();
    if (options.progress && now - reported > std::chrono::milliseconds(100)) {
      reported = now;
      interrupted = !options.progress(bench.time() / duration);
    }
  }
  Record record = bench.take();
  record.interrupted = interrupted;
  record.wall_s = std::chrono::duration<double>(Clock::now() - wall).count();
  record.cpu_s = cpu_seconds() - cpu;
  return record;
}

}  // namespace steplock::sinusoidal
