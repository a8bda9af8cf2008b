#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "testbench/command/command.hpp"
#include "testbench/command/terminal.hpp"
#include "testbench/range/load_envelope.hpp"
#include "testbench/report/report.hpp"
#include "testbench/run/check.hpp"

namespace steplock {
namespace {

struct Arguments {
  std::vector<std::string> files;
  std::string out = "out/load";
  int speed = 0;
};

int print_envelope(const Arguments& arguments) {
  namespace fs = std::filesystem;
  const std::vector<DriveFile> files = open_six_step_files(arguments.files, "the envelope");
  std::vector<LoadEnvelope> all;
  {
    Interrupt interrupt;
    ProgressBar bar("load");
    for (std::size_t i = 0; i < files.size(); ++i) {
      const std::string stem = fs::path(files[i].path).stem().string();
      all.push_back(measure_envelope(files[i], stem, arguments.speed, [&](double done) {
        bar.show((static_cast<double>(i) + done) / static_cast<double>(files.size()), stem);
        return !interrupt.asked();
      }));
    }
  }
  const fs::path out = arguments.out;
  std::vector<Figure> figures;
  for (const LoadEnvelope& e : all) figures.push_back(envelope_figure(e));
  draw_all(figures, out / "figures");
  write_file(out / "load.md", envelope_page(all));
  fmt::print("  wrote {}\n", (out / "load.md").string());
  return kWell;
}

}  // namespace

void add_envelope_command(CLI::App& app, int& exit_code) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand(
      "envelope", "Raise the load at several speeds until the rotor is lost: torque against speed.");
  command->add_option("FILES", arguments->files, "drive files")->required();
  command->add_option("--speed", arguments->speed,
                      "only this one of the four set speeds, counted from 1 (default all)")
      ->check(CLI::Range(1, 4));
  command->add_option("--out", arguments->out, "directory of load.md and its figures (default out/load)");
  command->footer("Example: steplock envelope drives/bly172s.toml");
  command->callback([arguments, &exit_code] { exit_code = print_envelope(*arguments); });
}

}  // namespace steplock
