#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <memory>

#include "testbench/command/command.hpp"
#include "testbench/drive_file/decades_motor.hpp"
#include "testbench/drive_file/drawn_motor.hpp"

namespace steplock {
namespace {

namespace fs = std::filesystem;

struct Arguments {
  std::uint64_t count = 10, seed = 1;
  std::string out = "out/motors";
  bool decades = false;
};

// Files that could not be written whole are none of the folder's.
void write_motors(const Arguments& arguments) {
  fs::create_directories(arguments.out);
  for (std::uint64_t k = 0; k < arguments.count; ++k) {
    const std::string name = arguments.decades ? decades_motor_name(k) : drawn_motor_name(k);
    const fs::path path = fs::path(arguments.out) / (name + ".toml"), part = path.string() + ".part";
    std::ofstream file(part);
    file << (arguments.decades ? decades_motor_file(arguments.seed, k) : drawn_motor_file(arguments.seed, k));
    file.close();
    if (!file) throw std::runtime_error(fmt::format("{} cannot be written; is the disk full?", part.string()));
    fs::rename(part, path);
  }
  fmt::print("wrote {} drive files into {}\n", arguments.count, arguments.out);
}

}  // namespace

void add_motors_command(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("motors", "Write drive files of plausible motors, drawn from a seed.");
  auto arguments = std::make_shared<Arguments>();
  command->add_option("--count", arguments->count, "how many")->check(CLI::Range(1, 9999))->capture_default_str();
  command->add_option("--seed", arguments->seed, "other motors")->capture_default_str();
  command->add_flag("--decades", arguments->decades,
                    "of any size: 2 to 800 V, 0.1 to 1000 A, 100 to 1,000,000 electrical r/min, 0.1 g cm^2 to 10 kg m^2");
  command->add_option("--out", arguments->out, "their folder")->capture_default_str();
  command->footer("Example: steplock motors --count 30 && steplock sweep out/motors/*.toml --runs 300");
  command->callback([arguments, &exit_code] {
    write_motors(*arguments);
    exit_code = kWell;
  });
}

}  // namespace steplock
