#include "testbench/sinusoidal/run.hpp"

#include <chrono>
#include <ctime>
#include <stdexcept>

#include "testbench/sinusoidal/fixed_engine.hpp"
#include "testbench/sinusoidal/rtl_engine.hpp"

namespace steplock::sinusoidal {
namespace {

template <class Engine>
Record run_with(const design::Settings& s, const RunOptions& options) {
  using Clock = std::chrono::steady_clock;
  const auto wall = Clock::now();
  auto reported = wall;
  const auto cpu_seconds = [] { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; };
  const double cpu = cpu_seconds();
  const Timeline events = timeline(s);
  BenchOf<Engine> bench(s, s, events, options.angle_deg);
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

}  // namespace

Record run(const design::Settings& s, const RunOptions& options) {
  switch (options.engine) {
    case EngineKind::kFloat: return run_with<FloatEngine>(s, options);
    case EngineKind::kFixed: return run_with<FixedEngine>(s, options);
    case EngineKind::kRtl: return run_with<RtlEngine>(s, options);
  }
  throw std::invalid_argument("no such engine");
}

}  // namespace steplock::sinusoidal
