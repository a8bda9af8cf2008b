#include "testbench/compare/coefficients.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "testbench/command/command.hpp"
#include "testbench/command/terminal.hpp"
#include "testbench/run/check.hpp"

namespace steplock {
namespace {

int coefficients(const std::vector<std::string>& names) {
  const std::vector<DriveFile> files = open_six_step_files(names, "the table");
  std::vector<CoefficientsOf> drives;
  {
    Interrupt interrupt;
    ProgressBar bar("");
    for (const DriveFile& file : files) {
      const std::string drive = std::filesystem::path(file.path).stem().string();
      const design::Settings& s = file.settings;
      const Told told = told_of(s, s.scenario.start_angle_deg, [&](double done) {
        bar.show(done, drive.c_str());
        return !interrupt.asked();
      });
      if (interrupt.asked()) return kInterrupted;
      drives.push_back(coefficients_of(drive, told));
    }
  }
  fmt::print("{}", coefficients_page(drives));
  return std::ranges::all_of(drives, &CoefficientsOf::passed) ? kWell : kFailed;
}

}  // namespace

void add_coefficients_command(CLI::App& app, int& exit_code) {
  auto files = std::make_shared<std::vector<std::string>>();
  CLI::App* command = app.add_subcommand(
      "coefficients", "How small a change of each coefficient shows where fixed and float are compared update by update.");
  command->add_option("FILES", *files, "drive files; sinusoidal ones are left out")->required();
  command->footer("Example: steplock coefficients drives/bly172s.toml");
  command->callback([files, &exit_code] { exit_code = coefficients(*files); });
}

}  // namespace steplock
