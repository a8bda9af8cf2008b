#include <fmt/format.h>

#include "testbench/command/command.hpp"

namespace steplock {

void add_keys_command(CLI::App& app, int& exit_code) {
  CLI::App* command =
      app.add_subcommand("keys", "Print every key of a drive file: unit, default, range, meaning.");
  command->footer("Example: steplock keys > docs/drive_file.md");
  command->callback([&exit_code] {
    fmt::print("{}", drive_file_reference());
    exit_code = kWell;
  });
}

}  // namespace steplock
