#include <fmt/format.h>

#include <exception>

#include "testbench/command/command.hpp"

int main(int argc, char** argv) {
  using namespace steplock;
  CLI::App app{
      "A sensorless six-step drive and its motor, simulated together.\n"
      "Exit codes: 0 well, 1 the run failed or a comparison differs, 2 bad input or usage,\n"
      "3 something broke, 130 interrupted."};
  app.name("steplock");
  app.footer("Example: steplock run drives/amano2003.toml --engine rtl --out report");
  app.set_version_flag("--version", "steplock " STEPLOCK_VERSION, "Print the version");
  app.require_subcommand(1);
  int exit_code = kWell;
  add_run_command(app, exit_code);
  add_sweep_command(app, exit_code);
  add_merge_command(app, exit_code);
  add_compare_command(app, exit_code);
  add_coefficients_command(app, exit_code);
  add_design_command(app, exit_code);
  add_paper_command(app, exit_code);
  add_range_command(app, exit_code);
  add_envelope_command(app, exit_code);
  add_gallery_command(app, exit_code);
  add_hold_command(app, exit_code);
  add_plant_command(app, exit_code);
  add_keys_command(app, exit_code);
  add_new_command(app, exit_code);
  add_motors_command(app, exit_code);
  add_registers_command(app, exit_code);
  add_report_command(app, exit_code);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? kWell : kBadInput;
  } catch (const BadInput& e) {
    fmt::print(stderr, "{}\n", e.what());
    return kBadInput;
  } catch (const Stopped&) {
    return kInterrupted;
  } catch (const std::exception& e) {
    fmt::print(stderr, "steplock: {}\n", e.what());
    return kBroken;
  }
  return exit_code;
}
