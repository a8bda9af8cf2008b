#include "testbench/compare/compare.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "testbench/command/command.hpp"
#include "testbench/command/terminal.hpp"
#include "testbench/drive/drive.hpp"
#include "testbench/report/report.hpp"
#include "testbench/run/check.hpp"

namespace steplock {
namespace {

struct Arguments {
  std::string file, out;
  bool json = false, no_lockstep = false;
  std::optional<double> angle_deg;
};

int compare(const Arguments& arguments) {
  const DriveFile file = open_drive_file(arguments.file);
  with_drive(file.settings, [&](auto drive) { decltype(drive)::check(file, EngineKind::kFixed); });
  Comparison result;
  bool interrupted = false;
  {
    Interrupt interrupt;
    ProgressBar bar("");
    result = compare_engines(
        file.settings,
        {.angle_deg = arguments.angle_deg.value_or(file.settings.scenario.start_angle_deg),
         .lockstep = !arguments.no_lockstep,
         .progress = [&](const char* what, double done) {
           bar.show(done, what);
           return !interrupt.asked();
         }});
    interrupted = interrupt.asked();
  }
  const std::string json = to_json(result).dump(2) + "\n";
  fmt::print("{}", arguments.json ? json : file.settings.drive.name + "\n" + to_text(result));
  if (!arguments.out.empty()) {
    const std::filesystem::path path = std::filesystem::path(arguments.out) / "compare.json";
    write_file(path, json);
    if (!arguments.json) fmt::print("  wrote {}\n", path.string());
  }
  if (interrupted) return kInterrupted;
  return result.passed() ? kWell : kFailed;
}

}  // namespace

void add_compare_command(CLI::App& app, int& exit_code) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand(
      "compare", "Hold rtl against fixed, clock by clock, and fixed against float, in units.");
  command->add_option("FILE", arguments->file, "drive file")->required();
  command->add_option("--out", arguments->out, "directory for compare.json (default: none)");
  command->add_flag("--no-lockstep", arguments->no_lockstep, "leave out rtl = fixed, which takes longest");
  command->add_flag("--json", arguments->json, "print the result as JSON");
  command->add_option("--angle", arguments->angle_deg,
                      "electrical degrees of the rotor at the start (default: the file's)");
  command->footer("Example: steplock compare drives/amano2003.toml");
  command->callback([arguments, &exit_code] { exit_code = compare(*arguments); });
}

}  // namespace steplock
