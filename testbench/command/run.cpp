#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <memory>

#include "testbench/command/command.hpp"
#include "testbench/command/terminal.hpp"
#include "testbench/report/report.hpp"
#include "testbench/run/check.hpp"
#include "testbench/run/summary.hpp"
#include "testbench/run/trace_writer.hpp"

namespace steplock {
namespace {

struct Arguments {
  std::string file, out;
  EngineKind engine = EngineKind::kRtl;
  bool json = false, trace = false;
  std::optional<double> angle_deg;
  std::optional<int> seed;
};

int run(const Arguments& arguments) {
  DriveFile file = open_drive_file(arguments.file);
  if (arguments.seed) file.settings.sensors.seed = *arguments.seed;
  const std::filesystem::path out =
      arguments.out.empty() ? std::filesystem::path("out") /
                                  (std::filesystem::path(arguments.file).stem().string() + "-" +
                                   name_of(arguments.engine))
                            : std::filesystem::path(arguments.out);
  std::filesystem::create_directories(out);

  RunOptions options{.engine = arguments.engine,
                     .angle_deg = arguments.angle_deg.value_or(file.settings.scenario.start_angle_deg)};
  std::unique_ptr<TraceWriter> trace;
  if (arguments.trace) {
    trace = std::make_unique<TraceWriter>((out / "wave.fst").string(),
                                          file.settings.motor.pole_pairs);
    options.trace = trace.get();
  }
  Record record;
  {
    Interrupt interrupt;
    ProgressBar bar(fmt::format("{} ({})", file.settings.drive.name, name_of(options.engine)));
    options.progress = [&](double done) {
      bar.show(done);
      return !interrupt.asked();
    };
    record = run_drive(file.settings, options);
  }
  trace.reset();
  const Summary summary = summarise(file.settings, options, record);
  const ReportFiles files = write_report(out, file, summary, record, arguments.trace);

  if (arguments.json) {
    fmt::print("{}\n", to_json(summary).dump(2));
  } else {
    fmt::print("{}", to_text(summary));
    for (const auto& path : files.paths) fmt::print("  wrote {}\n", path.string());
  }
  for (const std::string& warning : files.warnings) fmt::print(stderr, "steplock: {}\n", warning);
  if (summary.interrupted) return kInterrupted;
  return summary.failures().empty() ? kWell : kFailed;
}

}  // namespace

void add_run_command(CLI::App& app, int& exit_code) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("run", "Simulate the scenario of a drive file and report.");
  command->add_option("FILE", arguments->file, "drive file, such as drives/amano2003.toml")
      ->required();
  const std::map<std::string, EngineKind> kinds = {{"rtl", EngineKind::kRtl},
                                                   {"fixed", EngineKind::kFixed},
                                                   {"float", EngineKind::kFloat}};
  command->add_option("--engine", arguments->engine,
                      "what plays the drive: rtl (generated SystemVerilog, the default), fixed (its "
                      "C++ source), float (the reference)")
      ->transform(CLI::CheckedTransformer(kinds, CLI::ignore_case));
  command->add_option("--out", arguments->out,
                      "directory of the report (default out/<file>-<engine>)");
  command->add_flag("--json", arguments->json, "print summary.json on standard output");
  command->add_flag("--trace", arguments->trace, "write wave.fst and wave.gtkw for GTKWave");
  command->add_option("--angle", arguments->angle_deg,
                      "electrical degrees of the rotor at the start (default: the file's)");
  command->add_option("--seed", arguments->seed, "of all noise (default: the file's)")
      ->check(CLI::NonNegativeNumber);
  command->footer("Example: steplock run drives/amano2003.toml --engine fixed --angle 60 --json");
  command->callback([arguments, &exit_code] { exit_code = run(*arguments); });
}

}  // namespace steplock
