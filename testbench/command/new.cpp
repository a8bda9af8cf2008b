#include <fmt/format.h>

#include <cctype>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>

#include "testbench/command/command.hpp"
#include "testbench/data_sheet/data_sheet.hpp"
#include "testbench/drive/drive.hpp"
#include "testbench/run/check.hpp"

namespace steplock {
namespace {

namespace fs = std::filesystem;

struct Arguments {
  DataSheet sheet;
  std::string out;
  bool force = false, every_key = false;
};

bool told_nothing(const DataSheet& sheet) {
  for (const SheetEntry& e : sheet_entries()) {
    if (sheet.*e.value) return false;
  }
  return true;
}

// One line each; an empty answer is what the sheet does not print.
void ask(DataSheet& sheet) {
  fmt::print(stderr, "What the data sheet prints, a number each; an empty line where it prints none.\n");
  for (const SheetEntry& e : sheet_entries()) {
    for (;;) {
      fmt::print(stderr, "{} ({}): ", e.question, e.mistake);
      std::string answer;
      if (!std::getline(std::cin, answer) || answer.empty()) break;
      try {
        std::size_t read = 0;
        const double value = std::stod(answer, &read);
        if (read != answer.size() || !(value >= e.least && value <= e.most)) throw std::invalid_argument(answer);
        sheet.*e.value = value;
        break;
      } catch (const std::exception&) {
        fmt::print(stderr, "  '{}' is no number from {:g} to {:g}\n", answer, e.least, e.most);
      }
    }
  }
}

int make(Arguments& arguments) {
  const std::string& name = arguments.sheet.name;
  for (const char c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '_') {
      throw BadInput(fmt::format("steplock new: '{}' is to be a file's name; letters, digits and _ make one", name));
    }
  }
  const fs::path path = arguments.out.empty() ? fs::path(name + ".toml") : fs::path(arguments.out);
  if (fs::exists(path) && !arguments.force) {
    throw BadInput(fmt::format("steplock new: {} is there already; name another one by --out, or add --force", path.string()));
  }
  if (told_nothing(arguments.sheet)) ask(arguments.sheet);
  std::string text = drive_file_of(arguments.sheet);
  if (arguments.every_key) text = with_every_key(text, path.string());
  // What the loader, the plant and the design library say of it, before anything is written.
  DriveFile file = parse_drive_file(text, path.string());
  check_drive_file(file);

  if (path.has_parent_path()) fs::create_directories(path.parent_path());
  const fs::path part = path.string() + ".part";
  std::ofstream to(part);
  to << text;
  to.close();
  if (!to) throw std::runtime_error(fmt::format("{} cannot be written; is the disk full?", part.string()));
  fs::rename(part, path);
  fmt::print("wrote {}\n", path.string());
  for (const std::string& assumed : file.settings.drive.assumed) fmt::print("  assumed: {}\n", assumed);
  fmt::print("next: steplock run {0} --engine fixed && steplock design {0}\n", path.string());
  return kWell;
}

}  // namespace

void add_new_command(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("new", "Write a drive file from what a motor's data sheet prints; asks, if it is told nothing.");
  auto arguments = std::make_shared<Arguments>();
  command->add_option("NAME", arguments->sheet.name, "of the motor and of the file: letters, digits and _")->required();
  for (const SheetEntry& e : sheet_entries()) {
    command->add_option(e.option, arguments->sheet.*e.value, fmt::format("{}: {}", e.question, e.mistake))
        ->check(CLI::Range(e.least, e.most));
  }
  command->add_flag("--trapezoidal", arguments->sheet.trapezoidal, "its back-EMF has flat tops (default: sinusoidal)");
  command->add_option("--clock-mhz", arguments->sheet.clock_mhz, "of the FPGA")->check(CLI::Range(1, 400))->capture_default_str();
  command->add_option("--pwm-khz", arguments->sheet.pwm_khz, "of the bridge")->check(CLI::Range(1, 500))->capture_default_str();
  command->add_option("--out", arguments->out, "the file (default: NAME.toml)");
  command->add_flag("--template", arguments->every_key, "every other key as well, as a comment with its default, unit and meaning");
  command->add_flag("--force", arguments->force, "write over a file that is there");
  command->footer("Example: steplock new outrunner --bus 24 --poles 14 --kv 270 --resistance-line 0.11 --inductance-line 60e-6 --rated-current 12");
  command->callback([arguments, &exit_code] { exit_code = make(*arguments); });
}

}  // namespace steplock
