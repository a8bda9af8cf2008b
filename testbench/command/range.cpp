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
  std::string file = "drives/br2804_drone.toml", out = "out/range";
  double least_erpm = 0;
};

int print_range(const Arguments& arguments) {
  namespace fs = std::filesystem;
  const DriveFile file = open_drive_file(arguments.file);
  const RangePlan plan = with_drive(file.settings, [](auto drive) { return drive.range(); });
  Range range;
  {
    Interrupt interrupt;
    ProgressBar bar("range");
    range = measure_range(plan, file.settings, arguments.least_erpm, [&](double done) {
      bar.show(done);
      return !interrupt.asked();
    });
  }
  const fs::path out = arguments.out;
  const fs::path figure = out / "figures" / (plan.stem + ".svg"), page = out / (plan.stem + ".md");
  draw_all({range_figure(plan, range)}, out / "figures");
  write_file(page, range_page(plan, range));
  fmt::print("  wrote {}\n  wrote {}\n", figure.string(), page.string());
  return kWell;
}

}  // namespace

void add_range_command(CLI::App& app, int& exit_code) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand(
      "range", "Measure up to which speed the drive locks, and how well it commutates.");
  command->add_option("FILE", arguments->file,
                      "drive file that lends what is not varied (default drives/br2804_drone.toml)");
  command->add_option("--from", arguments->least_erpm,
                      "only from this electrical speed on, r/min (default all; slow ones take longest)");
  command->add_option("--out", arguments->out, "directory of the page and its figure (default out/range)");
  command->footer("Example: steplock range --out docs");
  command->callback([arguments, &exit_code] { exit_code = print_range(*arguments); });
}

}  // namespace steplock
