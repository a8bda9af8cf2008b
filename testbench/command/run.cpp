#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "testbench/command/command.hpp"
#include "testbench/command/terminal.hpp"
#include "testbench/drive/drive.hpp"
#include "testbench/report/watch_chart.hpp"
#include "testbench/run/units.hpp"
#include "testbench/sweep/row.hpp"

namespace steplock {
namespace {

struct Arguments {
  std::string file, out;
  EngineKind engine = EngineKind::kRtl;
  bool json = false, trace = false, compare = false, lockstep = false, watch = false;
  std::optional<double> angle_deg;
  std::optional<int> seed;
  std::optional<std::uint64_t> replay;
};

namespace fs = std::filesystem;

std::string stem(const Arguments& arguments) { return fs::path(arguments.file).stem().string(); }

fs::path make_folder(const Arguments& arguments) {
  const fs::path out = arguments.out.empty()
                           ? fs::path("out") / (stem(arguments) + "-" + name_of(arguments.engine))
                           : fs::path(arguments.out);
  fs::create_directories(out);
  return out;
}

void print_files(const ReportFiles& files, bool json) {
  for (const auto& path : files.paths) {
    if (!json) fmt::print("  wrote {}\n", path.string());
  }
  for (const std::string& warning : files.warnings) fmt::print(stderr, "steplock: {}\n", warning);
}

// Column by column, as a line of runs.csv would be.
void print_row(const Row& row, bool json) {
  nlohmann::ordered_json j;
  std::string text = csv_line(row);
  for_each_column(row.table(), row, [&](const char* name, const auto&) {
    const std::size_t comma = text.find(',');
    j[name] = text.substr(0, comma);
    text.erase(0, comma == text.npos ? comma : comma + 1);
  });
  if (row.matrix() == Matrix::kDisturb && row.table().sinusoidal()) j["drive_reason"] = start_reason(row);
  for (const auto& [name, value] : j.items()) {
    if (!json) fmt::print("  {:<16}{}\n", name, value.get<std::string>());
  }
  if (json) fmt::print("{}\n", j.dump(2));
}

[[noreturn]] void refuse(const DriveFile& file, const std::string& what) {
  throw BadInput(fmt::format("{}:{}: {}", file.path, file.line_of.at("drive.kind"), what));
}

std::unique_ptr<TraceWriter> make_trace(const Arguments& arguments, const fs::path& out, const WaveTable& wave,
                                        int pole_pairs) {
  if (!arguments.trace) return nullptr;
  return std::make_unique<TraceWriter>((out / "wave.fst").string(), wave, pole_pairs);
}

// One run of a sweep alone: once to know how long it takes, once with everything written down.
template <class Drive>
int replay(const Arguments& arguments, DriveFile file) {
  const RunSeed seed{*arguments.replay};
  if (seed.value >= kSeedEnd) refuse(file, fmt::format("--replay is {}; a sweep's seeds are below {}", seed.value, kSeedEnd));
  if (seed.hard() && !Drive::kHardships) refuse(file, "this seed is of the hard matrix, which serves six-step drives");
  DrawnRun run = drawn_run(file.settings, seed);
  if (seed.disturbed() && !Drive::meets(run.disturbance.kind)) {
    refuse(file, fmt::format("this seed's disturbance, {}, is of six-step drives; replay one of a sweep of this drive", name_of(run.disturbance.kind)));
  }
  const fs::path out = make_folder(arguments);
  Interrupt interrupt;
  SimulateOptions simulation{.engine = arguments.engine, .go_on = [&] { return !interrupt.asked(); }};
  DrawnResult result = Drive::simulate(run, simulation);
  if (result.stopped) return kInterrupted;
  std::unique_ptr<TraceWriter> trace = make_trace(arguments, out, Drive::wave(), run.settings.motor.pole_pairs);
  const double end_s = run.seed.disturbed() ? std::max(result.findings.end_s, result.after.end_s)
                                            : result.findings.end_s;
  typename Drive::Record record;
  Drive::record_into(simulation, record);
  simulation.trace = trace.get();
  simulation.record_s = end_s;
  result = Drive::simulate(run, simulation);
  if (result.stopped) return kInterrupted;
  trace.reset();
  design::Settings drawn = run.settings;
  drawn.scenario.duration_s = end_s;
  const RunOptions options{.engine = arguments.engine,
                           .angle_deg = run.settings.scenario.start_angle_deg};
  const ReportFiles files =
      Drive::report(out, drawn, Drive::summarise(drawn, options, record), record, arguments.trace);
  print_row({.index = 0, .drive = stem(arguments), .seed = run.seed.value, .outside = run.seed.outside(),
             .rtl = "", .conditions = run.conditions, .findings = result.findings,
             .disturbance = run.disturbance, .hardship = run.hardship, .after = result.after, .kind = drawn.drive.kind},
            arguments.json);
  print_files(files, arguments.json);
  const bool well = run.seed.disturbed() ? ends_well(run.disturbance.kind, result.after.outcome)
                                         : result.findings.outcome == Outcome::kStarted;
  return well ? kWell : kFailed;
}

template <class Drive>
int run(const Arguments& arguments, const DriveFile& file) {
  const fs::path out = make_folder(arguments);
  RunOptions options{.engine = arguments.engine,
                     .angle_deg = arguments.angle_deg.value_or(file.settings.scenario.start_angle_deg),
                     .lockstep = arguments.lockstep};
  std::unique_ptr<TraceWriter> trace = make_trace(arguments, out, Drive::wave(), file.settings.motor.pole_pairs);
  options.trace = trace.get();
  typename Drive::Record record;
  typename Drive::Summary summary;
  {
    Interrupt interrupt;
    ProgressBar bar(fmt::format("{} ({})", file.settings.drive.name, name_of(options.engine)));
    const design::ScenarioSection& n = file.settings.scenario;
    WatchChart chart(n.duration_s, n.reverse ? -n.speed_rpm : n.speed_rpm);
    Redrawn screen;
    if (arguments.watch) {
      options.watch = [&](const plant::State& now, const char* state) {
        const auto [least, greatest] = std::ranges::minmax(now.current);
        chart.add(now.time, rpm(now.speed), std::max(-least, greatest), state);
      };
    }
    options.progress = [&](double done) {
      if (arguments.watch) screen.draw(chart.text());
      else bar.show(done);
      return !interrupt.asked();
    };
    record = Drive::run(file.settings, options);
    if (arguments.watch) screen.draw(chart.text());
    summary = Drive::summarise(file.settings, options, record);
    if (arguments.compare && !summary.interrupted) {
      summary.float_errors = Drive::shadow(file.settings, summary, [&](double done) {
        bar.show(done, "fixed against float");
        return !interrupt.asked();
      });
      summary.interrupted = interrupt.asked();
    }
  }
  trace.reset();
  const ReportFiles files = Drive::report(out, file.settings, summary, record, arguments.trace);

  if (arguments.json) {
    fmt::print("{}\n", to_json(summary).dump(2));
  } else {
    fmt::print("{}", to_text(summary));
  }
  print_files(files, arguments.json);
  if (summary.interrupted) return kInterrupted;
  return summary.failures().empty() ? kWell : kFailed;
}

int run_or_replay(const Arguments& arguments) {
  if (arguments.compare && arguments.engine == EngineKind::kFloat) {
    throw BadInput("--compare holds rtl or fixed against float; choose one of them as --engine");
  }
  if (arguments.lockstep && arguments.engine != EngineKind::kRtl) {
    throw BadInput("--lockstep holds the RTL against its source; leave --engine out, or give it rtl");
  }
  if (arguments.watch && isatty(STDERR_FILENO) == 0) throw BadInput("--watch draws on a terminal, and standard error is none; leave it out");
  DriveFile file = open_drive_file(arguments.file);
  if (arguments.seed) file.settings.sensors.seed = *arguments.seed;
  return with_drive(file.settings, [&](auto drive) {
    using Drive = decltype(drive);
    Drive::check(file, arguments.engine);
    return arguments.replay ? replay<Drive>(arguments, file) : run<Drive>(arguments, file);
  });
}

}  // namespace

void add_run_command(CLI::App& app, int& exit_code) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("run", "Simulate the scenario of a drive file and report.");
  command->add_option("FILE", arguments->file, "drive file, such as drives/amano2003.toml")
      ->required();
  command->add_option("--engine", arguments->engine,
                      "what plays the drive: rtl (generated SystemVerilog, the default), fixed (its "
                      "C++ source), float (the reference)")
      ->transform(engine_among({EngineKind::kRtl, EngineKind::kFixed, EngineKind::kFloat}));
  command->add_option("--out", arguments->out,
                      "directory of the report (default out/<file>-<engine>)");
  command->add_flag("--json", arguments->json, "print summary.json on standard output");
  CLI::Option* compare = command->add_flag(
      "--compare", arguments->compare,
      "then hold fixed against float on the same pins, beside the error budget");
  CLI::Option* lockstep = command->add_flag(
      "--lockstep", arguments->lockstep,
      "hold the C++ source beside the RTL: every output on every clock, or the run fails");
  CLI::Option* watch = command->add_flag("--watch", arguments->watch, "draw speed and current on the terminal while it runs");
  command->add_flag("--trace", arguments->trace, "write wave.fst and wave.gtkw for GTKWave");
  CLI::Option* angle = command->add_option("--angle", arguments->angle_deg,
                      "electrical degrees of the rotor at the start (default: the file's)");
  CLI::Option* seed = command->add_option("--seed", arguments->seed, "of all noise (default: the file's)")
                          ->check(CLI::NonNegativeNumber);
  command->add_option("--replay", arguments->replay,
                      "seed of one run of a sweep, from its runs.csv: that run alone, instead of the "
                      "file's scenario")
      ->excludes(compare)->excludes(angle)->excludes(seed)->excludes(lockstep)->excludes(watch);
  command->footer("Example: steplock run drives/amano2003.toml --engine fixed --angle 60 --json");
  command->callback([arguments, &exit_code] { exit_code = run_or_replay(*arguments); });
}

}  // namespace steplock
