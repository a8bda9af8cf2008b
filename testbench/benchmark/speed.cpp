// How fast the engines run, and what bench and plant cost on top: docs/speed.md.
//
//     bare       the Verilated drive alone, fed the very pins that a closed loop showed it
//     rtl        the same with its motor: `steplock run --engine rtl` without the report
//     fixed      the native blocks with their motor
//     float      the reference with its motor
//
// All on the start of a drive file, of either drive.  Time is CPU time; the least of the repetitions counts, because a busy
// machine only ever adds.  What is watched is instructions, since times and even ratios of times are those of a machine: at
// commit cf48881 ratios to a Verilated yardstick were 1.36 (bare) and 0.76 (float) of the page's in one run of CI.
//
//     cmake --build build -t benchmark_speed && build/bin/benchmark_speed > docs/speed.md
//     build/bin/benchmark_speed --check docs/speed.md [ENGINE...]    counts again, of all engines unless told
//     build/bin/benchmark_speed --once ENGINE                        what Valgrind counts
//
// Test: tests/tools/CMakeLists.txt
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <fstream>
#include <future>
#include <map>
#include <sstream>

#include "model/design/design.hpp"
#include "model/design/config.hpp"
#include "testbench/benchmark/instructions.hpp"
#include "testbench/drive/six_step/float_engine.hpp"
#include "testbench/drive/six_step/rtl_engine.hpp"
#include "testbench/drive/six_step/config.hpp"
#include "testbench/run/check.hpp"
#include "testbench/drive/six_step/run.hpp"
#include "testbench/run/timeline.hpp"
#include "testbench/drive/sinusoidal/run.hpp"

namespace steplock {
namespace {

// How much of the scenario is run.  In a second: start, lock, set speed.
double duration_s = 1;

design::Settings beginning(const char* path) {
  design::Settings settings = load_drive_file(path).settings;
  design::ScenarioSection& n = settings.scenario;
  n.duration_s = duration_s;
  drop_events(n);
  return settings;
}

struct Scene {
  design::Settings settings = beginning(STEPLOCK_DRIVES "/m2310p_servo.toml");
  design::Parameters parameters;
  SixStepConfig config;

  Scene() {
    parameters = design::design_drive(settings).parameters;
    config = hls_config(design::quantise(parameters, settings.control.clock_hz).config);
  }
  double clock_hz() const { return settings.control.clock_hz; }
  std::uint64_t clocks() const { return timeline(settings).clocks; }
};

const Scene& scene() {
  static const Scene the_scene;
  return the_scene;
}

const design::Settings& sinusoidal_scene() {
  static const design::Settings settings = beginning(STEPLOCK_DRIVES "/m2310p_sinusoidal.toml");
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
    ListeningEngine engine(scene().config, scene().clock_hz());
    run_with(engine, scene().settings, {});
    return engine.shown;
  }();
  return all;
}

void bare() {
  RtlEngine engine(scene().config, scene().clock_hz());
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

template <class Engine, class Setting>
void with_motor(const Setting& setting) {
  Engine engine(setting, scene().clock_hz());
  benchmark::DoNotOptimize(run_with(engine, scene().settings, {}));
}
void rtl() { with_motor<RtlEngine>(scene().config); }
void fixed() { with_motor<FixedEngine>(scene().config); }
void floating() { with_motor<FloatEngine>(scene().parameters); }

template <EngineKind kEngine>
void sinusoidal_drive() {
  benchmark::DoNotOptimize(sinusoidal::run(sinusoidal_scene(), {.engine = kEngine}));
}

struct Row {
  const char* name;
  void (*once)();
  double counted_s;  // of the scenario: under Valgrind a second of the RTL takes many minutes
  const char* what;
};
constexpr Row kRows[] = {
    {"bare", bare, 0.05, "RTL of the six-step drive alone, on the pins that a closed loop showed it"},
    {"rtl", rtl, 0.05, "the same with its motor: `steplock run --engine rtl` without the report"},
    {"fixed", fixed, 0.2, "the C++ blocks with their motor: `--engine fixed`"},
    {"float", floating, 0.2, "the floating-point reference with its motor: `--engine float`"},
    {"sinusoidal_rtl", sinusoidal_drive<EngineKind::kRtl>, 0.05, "RTL of the sinusoidal drive with its motor"},
    {"sinusoidal_fixed", sinusoidal_drive<EngineKind::kFixed>, 0.2, "C++ blocks of the sinusoidal drive with their motor"},
    {"sinusoidal_float", sinusoidal_drive<EngineKind::kFloat>, 0.2, "floating-point reference of the sinusoidal drive with its motor"},
};

std::string names() {
  std::string all;
  for (const Row& row : kRows) all += (all.empty() ? "" : ", ") + std::string(row.name);
  return all;
}

const Row& row_of(std::string_view name) {
  const Row* row = std::ranges::find(kRows, name, &Row::name);
  if (row == std::end(kRows)) throw std::runtime_error(fmt::format("there is no engine '{}'; they are {}", name, names()));
  return *row;
}

// Instructions per clock of each, both cores at work.
std::vector<double> count(const std::vector<Row>& rows) {
  std::vector<double> counts(rows.size());
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t i; (i = next++) < rows.size();)
      counts[i] = instructions(fmt::format("--once {}", rows[i].name)) / (rows[i].counted_s * scene().clock_hz());
  };
  auto other = std::async(std::launch::async, work);
  work();
  other.get();
  return counts;
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
  // Clocks per CPU second; both scenes have as many.
  double rate(const Row& row) const { return static_cast<double>(scene().clocks()) / seconds_.at(row.name); }

 private:
  std::map<std::string, double> seconds_;
};

constexpr const char* kPage = R"(# Speed

Generated by `build/bin/benchmark_speed` (a target); the test `no_engine_takes_more_instructions` counts again
and fails where an engine takes a twentieth more of them, or less, than this page says.

The start of `drives/m2310p_servo.toml` or `drives/m2310p_sinusoidal.toml`, {:.0f} million clocks a second.

- *Clocks per CPU second*: of the first second (start, lock, set speed), the least of several rounds that take turns, on the machine that
  measured this page; *times the RTL*: beside the second row, in the same run. Other machines have other ratios.
- *Instructions per clock*: counted by Valgrind over the first milliseconds. They hardly depend on the machine, and the test watches them.

| engine | million clocks per CPU second | times the RTL | instructions per clock | in the first |
|---|---:|---:|---:|---:|
)";

void print_page() {
  if (timeline(sinusoidal_scene()).clocks != scene().clocks()) throw std::runtime_error("the page says that both drives have one clock");
  shown();  // not on anybody's time
  for (const Row& row : kRows) {
    benchmark::RegisterBenchmark(row.name, [&row](benchmark::State& state) {
      for (auto _ : state) row.once();
    })->Iterations(1)->Repetitions(3);
  }
  char program[] = "benchmark_speed", turns[] = "--benchmark_enable_random_interleaving=true";
  char* options[] = {program, turns, nullptr};
  int option_count = 2;
  benchmark::Initialize(&option_count, options);
  Least least;
  benchmark::RunSpecifiedBenchmarks(&least);
  const std::vector<double> counts = count({std::begin(kRows), std::end(kRows)});
  fmt::print(fmt::runtime(kPage), scene().clock_hz() / 1e6);
  for (std::size_t i = 0; i < std::size(kRows); ++i) {
    const Row& row = kRows[i];
    const double rate = least.rate(row);
    fmt::print("| {} | {:.1f} | {:.2f} | {:.1f} | {:.0f} ms |\n", row.what, rate / 1e6, rate / least.rate(row_of("rtl")), counts[i],
               1000 * row.counted_s);
  }
}

// The instructions per clock that the page shows of an engine.
double count_on(const std::string& page, const Row& row, const char* file) {
  const auto at = page.find(fmt::format("| {} |", row.what));
  if (at == std::string::npos) {
    throw std::runtime_error(fmt::format("{0} has no row '{1}'; measure it: benchmark_speed > {0}", file, row.what));
  }
  std::stringstream line(page.substr(at, page.find('\n', at) - at));
  std::string cell;
  for (int i = 0; i < 5; ++i) std::getline(line, cell, '|');
  return std::stod(cell);
}

// More than what libm chooses for another processor changes.
constexpr double kSame = 0.05;

bool check(const char* file, const std::vector<Row>& rows) {
  std::stringstream text;
  text << std::ifstream(file).rdbuf();
  std::vector<double> page;
  for (const Row& row : rows) page.push_back(count_on(text.str(), row, file));
  const std::vector<double> counts = count(rows);
  bool same = true;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double part = counts[i] / page[i];
    const char* verdict = part > 1 + kSame ? ": lost" : part < 1 - kSame ? ": gained; print the page anew" : "";
    fmt::print("{:<16} {:.1f} instructions per clock, {:.3f} of the page's {:.1f}{}\n", rows[i].name, counts[i], part, page[i],
               verdict);
    same = same && *verdict == '\0';
  }
  return same;
}

int run(const std::vector<std::string>& arguments) {
  if (arguments.empty()) {
    print_page();
    return 0;
  }
  if (arguments.size() == 2 && arguments[0] == "--once") {
    const Row& row = row_of(arguments[1]);
    duration_s = row.counted_s;
    if (row.once == bare) shown();  // not counted
    counted(row.once);
    return 0;
  }
  if (arguments.size() >= 2 && arguments[0] == "--check") {
    std::vector<Row> rows;
    for (std::size_t i = 2; i < arguments.size(); ++i) rows.push_back(row_of(arguments[i]));
    if (rows.empty()) rows.assign(std::begin(kRows), std::end(kRows));
    return check(arguments[1].c_str(), rows) ? 0 : 1;
  }
  throw std::runtime_error("usage: benchmark_speed [--check PAGE [ENGINE...] | --once ENGINE]");
}

}  // namespace
}  // namespace steplock

int main(int argc, char** argv) {
  try {
    return steplock::run({argv + 1, argv + argc});
  } catch (const std::exception& e) {
    fmt::print(stderr, "benchmark_speed: {}\n", e.what());
    return 2;
  }
}
