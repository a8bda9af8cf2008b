// How fast the engines run, and what bench and plant cost on top, as ratios: docs/speed.md.
//
//     yardstick  a small Verilated core that never changes (yardstick.sv): the unit
//     bare       the Verilated drive alone, fed the very pins that a closed loop showed it
//     rtl        the same with its motor: `steplock run --engine rtl` without the report
//     fixed      the native blocks with their motor
//     float      the reference with its motor
//
// All on the first second of a drive file, of either drive: start, lock, set speed.  CPU time; the least of
// the repetitions counts, because a busy machine only ever adds.
//
//     cmake --build build -t benchmark_speed && build/bin/benchmark_speed > docs/speed.md
//     build/bin/benchmark_speed --check docs/speed.md    fails where a fifth of a ratio is lost, also
//                                                         after two more rounds; with --once without them
//
// Test: tests/tools/CMakeLists.txt
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cstring>
#include <fstream>
#include <map>
#include <sstream>

#include "model/design/design.hpp"
#include "model/design/words.hpp"
#include "testbench/engine/float.hpp"
#include "testbench/engine/rtl.hpp"
#include "testbench/engine/words.hpp"
#include "testbench/run/check.hpp"
#include "testbench/run/drive_loop.hpp"
#include "testbench/sinusoidal/run.hpp"
#include "verilated_yardstick/Vyardstick.h"

namespace steplock {
namespace {

// The first second of a drive file's scenario: start, lock, set speed.
design::Settings first_second(const char* path) {
  design::Settings settings = load_drive_file(path).settings;
  design::ScenarioSection& n = settings.scenario;
  n.duration_s = 1;
  n.load_step_s.reset();
  n.load_off_s.reset();
  n.reverse_s.reset();
  n.stop_s.reset();
  return settings;
}

struct Scene {
  design::Settings settings = first_second(STEPLOCK_DRIVES "/m2310p_servo.toml");
  design::Parameters parameters;
  Words words;

  Scene() {
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

const design::Settings& sinusoidal_scene() {
  static const design::Settings settings = first_second(STEPLOCK_DRIVES "/m2310p_sinusoidal.toml");
  return settings;
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
}

constexpr std::uint64_t kYardstickClocks = 3'000'000;

void yardstick(benchmark::State& state) {
  for (auto _ : state) {
    Vyardstick core;
    core.period = 1199;
    std::uint32_t seen = 0;
    for (std::uint64_t clock = 0; clock < kYardstickClocks; ++clock) {
      core.rst = clock == 0;
      core.clk = 1;
      core.eval();
      seen ^= core.watch;
      core.clk = 0;
      core.eval();
    }
    core.final();
    benchmark::DoNotOptimize(seen);
  }
}

template <class Engine, class Setting>
void with_motor(benchmark::State& state, const Setting& setting) {
  for (auto _ : state) {
    Engine engine(setting, scene().clock_hz());
    benchmark::DoNotOptimize(run_with(engine, scene().settings, {}));
  }
}
void rtl(benchmark::State& state) { with_motor<RtlEngine>(state, scene().words); }
void fixed(benchmark::State& state) { with_motor<FixedEngine>(state, scene().words); }
void floating(benchmark::State& state) { with_motor<FloatEngine>(state, scene().parameters); }

template <EngineKind kEngine>
void sinusoidal_drive(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(sinusoidal::run(sinusoidal_scene(), {.engine = kEngine}));
}

// Keeps the least CPU time of each, and prints nothing.
class Least : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.run_type != Run::RT_Iteration) continue;
      const double s = run.cpu_accumulated_time / static_cast<double>(run.iterations);
      auto [it, first] = seconds_.try_emplace(run.run_name.function_name, s);
      if (!first) it->second = std::min(it->second, s);
    }
  }
  // Clocks per CPU second.
  double rate(const char* name, std::uint64_t clocks) const {
    return static_cast<double>(clocks) / seconds_.at(name);
  }

 private:
  std::map<std::string, double> seconds_;
};

struct Row {
  const char* name;
  void (*function)(benchmark::State&);
  const char* what;
};
constexpr Row kRows[] = {
    {"bare", bare, "RTL of the six-step drive alone, on the pins that a closed loop showed it"},
    {"rtl", rtl, "the same with its motor: `steplock run --engine rtl` without the report"},
    {"fixed", fixed, "the C++ blocks with their motor: `--engine fixed`"},
    {"float", floating, "the floating-point reference with its motor: `--engine float`"},
    {"sinusoidal_rtl", sinusoidal_drive<EngineKind::kRtl>, "RTL of the sinusoidal drive with its motor"},
    {"sinusoidal_fixed", sinusoidal_drive<EngineKind::kFixed>, "C++ blocks of the sinusoidal drive with their motor"},
    {"sinusoidal_float", sinusoidal_drive<EngineKind::kFloat>, "floating-point reference of the sinusoidal drive with its motor"},
};

// Clocks per CPU second; both scenes have as many.
double rate(const Least& least, const Row& row) { return least.rate(row.name, scene().clocks()); }
double ratio(const Least& least, const Row& row) {
  return rate(least, row) / least.rate("yardstick", kYardstickClocks);
}

constexpr const char* kPage = R"(# Speed

Generated by `build/bin/benchmark_speed` (a target); the test `no_engine_lost_a_fifth_of_its_speed` measures again
and fails where a ratio is less than 0.8 of this page's.

One second of `drives/m2310p_servo.toml` or `drives/m2310p_sinusoidal.toml`, {:.0f} million clocks each: start,
lock, set speed. CPU time, the least of several rounds that take turns. The last column says how many clocks an engine simulates while
`testbench/benchmark/yardstick.sv`, a Verilated core of 16 channels that does not change with the drive,
simulates one: such a ratio hardly depends on the machine. Clocks per second do, and are those of the
machine that measured this page.

| engine | million clocks per CPU second | clocks per clock of the yardstick |
|---|---:|---:|
)";

void print_page(const Least& least) {
  fmt::print(fmt::runtime(kPage), static_cast<double>(scene().clocks()) / 1e6);
  for (const Row& row : kRows)
    fmt::print("| {} | {:.1f} | {:.3f} |\n", row.what, rate(least, row) / 1e6, ratio(least, row));
}

// The ratio that the page shows of an engine.
std::optional<double> ratio_on(const std::string& page, const Row& row) {
  const auto at = page.find(fmt::format("| {} |", row.what));
  if (at == std::string::npos) return {};
  const auto line = page.substr(at, page.find('\n', at) - at);
  const auto end = line.rfind(" |");
  const auto begin = line.rfind('|', end - 1) + 1;
  return std::stod(line.substr(begin, end - begin));
}

constexpr double kLost = 0.8;

bool is_kept(const Least& least, const std::string& page) {
  return std::all_of(std::begin(kRows), std::end(kRows), [&](const Row& row) {
    return ratio(least, row) >= kLost * ratio_on(page, row).value();
  });
}

int check(Least& least, const char* file, int more) {
  std::stringstream text;
  text << std::ifstream(file).rdbuf();
  const std::string page = text.str();
  for (const Row& row : kRows) {
    if (ratio_on(page, row)) continue;
    fmt::print(stderr, "{} has no row '{}'; measure it: benchmark_speed > {}\n", file, row.what,
               file);
    return 1;
  }
  // The least time of more rounds is nearer to what the code needs, on a busy machine.
  for (; more > 0 && !is_kept(least, page); --more)
    benchmark::RunSpecifiedBenchmarks(&least);
  for (const Row& row : kRows) {
    const double now = ratio(least, row), then = *ratio_on(page, row);
    fmt::print("{:<16} {:.3f} clocks per clock of the yardstick, {:.2f} of the page's {:.3f}{}\n",
               row.name, now, now / then, then, now >= kLost * then ? "" : ": lost");
  }
  return is_kept(least, page) ? 0 : 1;
}

}  // namespace
}  // namespace steplock

int main(int argc, char** argv) {
  using namespace steplock;
  const bool once = argc == 4 && std::strcmp(argv[3], "--once") == 0;
  const char* checked = nullptr;
  if ((argc == 3 || once) && std::strcmp(argv[1], "--check") == 0) checked = argv[2];
  if (argc != 1 && checked == nullptr) {
    fmt::print(stderr, "benchmark_speed: '{}' is no option; usage: benchmark_speed [--check PAGE [--once]]\n",
               argv[argc - 1]);
    return 2;
  }
  shown();  // not on anybody's time
  if (timeline(sinusoidal_scene()).clocks != scene().clocks()) return 2;  // the page says both have as many
  const auto add = [](const char* name, void (*function)(benchmark::State&)) {
    benchmark::RegisterBenchmark(name, function)->Iterations(1)->Repetitions(3);
  };
  add("yardstick", yardstick);
  for (const Row& row : kRows) add(row.name, row.function);
  char program[] = "benchmark_speed", turns[] = "--benchmark_enable_random_interleaving=true";
  char* options[] = {program, turns, nullptr};
  int count = 2;
  benchmark::Initialize(&count, options);
  Least least;
  benchmark::RunSpecifiedBenchmarks(&least);
  if (checked != nullptr) return check(least, checked, once ? 0 : 2);
  print_page(least);
  return 0;
}
