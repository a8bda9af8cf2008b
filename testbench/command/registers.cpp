#include <fmt/format.h>

#include <functional>
#include <memory>
#include <vector>

#include "testbench/command/command.hpp"
#include "testbench/registers/registers.hpp"

namespace steplock {

void add_registers_command(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("registers", "Print the register map of a drive.");
  auto of_sinusoidal = std::make_shared<bool>(false);
  command->add_flag("--sinusoidal", *of_sinusoidal, "that of the sinusoidal drive; else of the six-step drive");
  auto* kind = command->add_option_group("form");
  auto printers = std::make_shared<std::vector<std::function<void()>>>();
  const auto add = [&](const char* flag, const char* what, std::string (*print)(const registers::Map&)) {
    auto wanted = std::make_shared<bool>(false);
    kind->add_flag(flag, *wanted, what);
    printers->push_back([print, wanted, of_sinusoidal] {
      if (*wanted) fmt::print("{}", print(*of_sinusoidal ? registers::sinusoidal() : registers::six_step()));
    });
  };
  add("--markdown", "as a page: docs/six_step_registers.md", registers::markdown);
  add("--c-header", "for C: rtl/host/steplock_registers.h", registers::c_header);
  add("--systemrdl", "in SystemRDL 2.0: rtl/host/steplock.rdl", registers::systemrdl);
  add("--ip-xact", "in IP-XACT (IEEE 1685-2014), alone: tools/ip_xact puts bus, ports and files around it", registers::ip_xact);
  kind->require_option(1);
  command->callback([printers, &exit_code] {
    for (const auto& print : *printers) print();
    exit_code = kWell;
  });
  command->footer("Example: steplock registers --markdown > docs/six_step_registers.md");
}

}  // namespace steplock
