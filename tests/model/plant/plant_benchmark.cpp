// What the plant costs: CPU time per simulated second, driven as the co-simulation drives it, from
// a clock loop that looks at next_event() each clock.  Not in ctest: build/bin/plant_benchmark.
#include <benchmark/benchmark.h>

#include <array>

#include "tests/model/plant/six_step.hpp"

namespace steplock::plant {
namespace {

constexpr double kClock = 12e6;  // Hz
constexpr int kPwmClocks = 400;  // 30 kHz
constexpr int kDeadClocks = 6;   // 0.5 us

Parameters parameters(BackEmfShape::Kind kind, double noise) {
  Parameters p;
  p.motor.shape.kind = kind;
  p.load.inertia = 1e-5;
  for (auto& c : p.sensing.comparator) c.noise = noise;
  return p;
}

// Hall-commutated six-step, 30 kHz, complementary chopping with dead time: four gate changes per
// period. bare_clock_loop is to be subtracted.
void six_step(benchmark::State& bench, BackEmfShape::Kind kind, double noise, double tolerance) {
  Parameters p = parameters(kind, noise);
  p.accuracy.tolerance = tolerance;
  Plant plant(p, {.angle = 0.2});
  std::int64_t clock = 0;
  int phase = 0;
  const int off = kPwmClocks * 4 / 10;
  const auto chop = [&](bool high, bool low) {
    const Step step = forward_step(plant.pins().hall);
    std::array<bool, 3> up = {}, down = {};
    up[step.high] = high;
    down[step.high] = low;
    down[step.low] = true;
    plant.advance_to(static_cast<double>(clock) / kClock);
    plant.set_gates(gates_of(up, down));
  };
  for (auto _ : bench) {
    for (int n = 0; n < 120000; ++n) {  // 10 ms
      const double time = static_cast<double>(clock) / kClock;
      if (time >= plant.next_event()) plant.advance_to(time);
      if (phase == 0) chop(true, false);
      if (phase == off) chop(false, false);
      if (phase == off + kDeadClocks) chop(false, true);
      if (phase == kPwmClocks - kDeadClocks) chop(false, false);
      if (++phase == kPwmClocks) phase = 0;
      ++clock;
    }
  }
  const double simulated = static_cast<double>(clock) / kClock;
  bench.counters["simulated_s_per_cpu_s"] =
      benchmark::Counter(simulated, benchmark::Counter::kIsRate);
  bench.counters["steps_per_simulated_s"] = static_cast<double>(plant.steps()) / simulated;
  bench.counters["rpm"] = plant.state().speed * 60 / kTurn;
}

void bare_clock_loop(benchmark::State& bench) {
  std::int64_t clock = 0;
  double next = 1e300;
  for (auto _ : bench) {
    for (int n = 0; n < 120000; ++n) {
      benchmark::DoNotOptimize(next);
      if (static_cast<double>(clock) / kClock >= next) break;
      ++clock;
    }
  }
  bench.counters["simulated_s_per_cpu_s"] =
      benchmark::Counter(static_cast<double>(clock) / kClock, benchmark::Counter::kIsRate);
}

using Kind = BackEmfShape::Kind;
BENCHMARK_CAPTURE(six_step, trapezoidal, Kind::kTrapezoidal, 0.0, 1e-8);
BENCHMARK_CAPTURE(six_step, trapezoidal_1e7, Kind::kTrapezoidal, 0.0, 1e-7);
BENCHMARK_CAPTURE(six_step, sinusoidal, Kind::kSinusoidal, 0.0, 1e-8);
BENCHMARK_CAPTURE(six_step, trapezoidal_noisy, Kind::kTrapezoidal, 0.01, 1e-8);
BENCHMARK(bare_clock_loop);

}  // namespace
}  // namespace steplock::plant
