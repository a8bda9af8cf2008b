// How fast the engines run, and what bench and plant cost on top, as ratios of one run.
//
//     bare       the Verilated drive alone, fed the very pins that a closed loop showed it
//     rtl        the same drive with its motor: `steplock run --engine rtl` without the report
//     fixed      the native blocks with their motor
//     float      the reference with its motor
//
// All on the first second of drives/m2310p_servo.toml: start, lock, set speed.  CPU time; the least of
// the repetitions counts, because a busy machine only ever adds.
//
//     cmake --build build -t benchmark_speed && build/bin/benchmark_speed
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <map>

#include "model/design/design.hpp"
#include "model/design/words.hpp"
#include "testbench/engine/float.hpp"
#include "testbench/engine/rtl.hpp"
#include "testbench/engine/words.hpp"
#include "testbench/run/check.hpp"
#include "testbench/run/drive_loop.hpp"

namespace steplock {
namespace {

struct Scene {
  design::Settings settings = load_drive_file(STEPLOCK_DRIVES "/m2310p_servo.toml").settings;
  design::Parameters parameters;
  Words words;

  Scene() {
    design::ScenarioSection& n = settings.scenario;
    n.duration_s = 1;
    n.load_step_s.reset();
    n.load_off_s.reset();
    n.reverse_s.reset();
    n.stop_s.reset();
    parameters = design::design_drive(settings).parameters;
    words = hls_words(design::quantise(parameters, settings.control.clock_hz).words);
  }
  double clock_hz() const { return settings.control.clock_hz; }
  std::uint64_t clocks() const { return timeline(settings).clocks; }
};

const Scene& scene() {
  static const Scene the_scene;
  return the_scene;
}

// What a closed loop showed its engine, and when.
struct Shown {
  std::uint64_t clock;
  std::optional<plant::Pins> pins;
  std::optional<HostCommand> command;
};

class ListeningEngine : public FixedEngine {
 public:
  using FixedEngine::FixedEngine;
  void set_pins(const plant::Pins& p) {
    FixedEngine::set_pins(p);
    shown.push_back({clock_, p, {}});
  }
  void set_command(const HostCommand& c) {
    FixedEngine::set_command(c);
    shown.push_back({clock_, {}, c});
  }
  void tick() {
    FixedEngine::tick();
    ++clock_;
  }
  void skip(std::uint64_t clocks) {
    FixedEngine::skip(clocks);
    clock_ += clocks;
  }
  std::vector<Shown> shown;

 private:
  std::uint64_t clock_ = 0;
};

const std::vector<Shown>& shown() {
  static const std::vector<Shown> all = [] {
    ListeningEngine engine(scene().words, scene().clock_hz());
    run_with(engine, scene().settings, {});
    return engine.shown;
  }();
  return all;
}

void bare(benchmark::State& state) {
  for (auto _ : state) {
    RtlEngine engine(scene().words, scene().clock_hz());
    std::uint64_t clock = 0;
    std::uint32_t seen = 0;
    const auto run_to = [&](std::uint64_t end) {
      while (clock < end) {
        clock += engine.run(end - clock);
        seen ^= engine.watch().bits;
      }
    };
    for (const Shown& s : shown()) {
      run_to(s.clock);
      if (s.pins) engine.set_pins(*s.pins);
      if (s.command) engine.set_command(*s.command);
    }
    run_to(scene().clocks());
    benchmark::DoNotOptimize(seen);
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * scene().clocks()));
}

template <class Engine, class Setting>
void with_motor(benchmark::State& state, const Setting& setting) {
  for (auto _ : state) {
    Engine engine(setting, scene().clock_hz());
    benchmark::DoNotOptimize(run_with(engine, scene().settings, {}));
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * scene().clocks()));
}
void rtl(benchmark::State& state) { with_motor<RtlEngine>(state, scene().words); }
void fixed(benchmark::State& state) { with_motor<FixedEngine>(state, scene().words); }
void floating(benchmark::State& state) { with_motor<FloatEngine>(state, scene().parameters); }

// Keeps the least CPU time of each.
class Least : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override {
    ConsoleReporter::ReportRuns(runs);
    for (const Run& run : runs) {
      if (run.run_type != Run::RT_Iteration) continue;
      const double s = run.cpu_accumulated_time / static_cast<double>(run.iterations);
      auto [it, first] = seconds.try_emplace(run.run_name.function_name, s);
      if (!first) it->second = std::min(it->second, s);
    }
  }
  std::map<std::string, double> seconds;
};

}  // namespace
}  // namespace steplock

int main(int argc, char** argv) {
  using namespace steplock;
  shown();  // not on anybody's time
  constexpr std::pair<const char*, void (*)(benchmark::State&)> kAll[] = {
      {"bare", bare}, {"rtl", rtl}, {"fixed", fixed}, {"float", floating}};
  for (const auto& [name, function] : kAll) {
    benchmark::RegisterBenchmark(name, function)
        ->Unit(benchmark::kMillisecond)
        ->Iterations(1)
        ->Repetitions(5)
        ->ReportAggregatesOnly(false);
  }
  benchmark::Initialize(&argc, argv);
  Least least;
  benchmark::RunSpecifiedBenchmarks(&least);
  if (least.seconds.size() < 4) return 0;  // a filter left some out
  const double clocks = static_cast<double>(scene().clocks());
  const auto rate = [&](const char* name) { return clocks / least.seconds.at(name) / 1e6; };
  fmt::print("\n{} clocks of drives/m2310p_servo.toml\n", scene().clocks());
  fmt::print("bench and plant on top of the bare RTL  {:+.1f} %       at most +30 %\n",
             100 * (least.seconds.at("rtl") / least.seconds.at("bare") - 1));
  fmt::print("RTL engine, M clocks per CPU second     {:.1f}        at least 10\n", rate("rtl"));
  fmt::print("fixed engine, M clocks per CPU second   {:.1f}\n", rate("fixed"));
  fmt::print("fixed over RTL                          {:.1f}         at least 3\n",
             rate("fixed") / rate("rtl"));
  fmt::print("float engine, M clocks per CPU second   {:.1f}\n", rate("float"));
  return 0;
}
