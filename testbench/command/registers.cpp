#include <fmt/format.h>

#include <memory>

#include "testbench/command/command.hpp"
#include "testbench/registers/registers.hpp"

namespace steplock {

void add_registers_command(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("registers", "Print the register map of the drive.");
  auto* kind = command->add_option_group("form");
  const auto add = [&](const char* flag, const char* what, std::string (*print)()) {
    kind->add_flag_callback(flag, [print, &exit_code] {
      fmt::print("{}", print());
      exit_code = kWell;
    }, what);
  };
  add("--markdown", "as a page: docs/registers.md", registers::markdown);
  add("--c-header", "for C: rtl/host/steplock_registers.h", registers::c_header);
  add("--systemrdl", "in SystemRDL 2.0: rtl/host/steplock.rdl", registers::systemrdl);
  add("--ip-xact", "in IP-XACT (IEEE 1685-2014): rtl/host/steplock.xml", registers::ip_xact);
  kind->require_option(1);
  command->footer("Example: steplock registers --markdown > docs/registers.md");
}

}  // namespace steplock
