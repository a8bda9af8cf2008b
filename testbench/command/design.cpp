#include <fmt/format.h>

#include <cctype>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>

#include "model/design/analog_circuit.hpp"
#include "model/design/design.hpp"
#include "model/design/config.hpp"
#include "testbench/command/command.hpp"
#include "testbench/drive/drive.hpp"
#include "testbench/drive/six_step/config.hpp"
#include "testbench/registers/registers.hpp"
#include "testbench/drive/six_step/design_report.hpp"
#include "testbench/drive/sinusoidal/design_report.hpp"
#include "testbench/drive/sinusoidal/config.hpp"

namespace steplock {
namespace {

struct Arguments {
  std::string file, out;
  bool json = false, c_header = false, verilog = false, mem = false, circuit = false;
  std::optional<double> clock_hz;
};

// The file's name, as part of a comment or an identifier.
std::string name_of(const Arguments& arguments) {
  std::string name = std::filesystem::path(arguments.file).stem().string();
  for (char& c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  }
  return name;
}

// One part alone: the analog circuit, or the words for steplock_init() of rtl/host/steplock.h, or around
// rtl/six_step_standalone.sv or rtl/sinusoidal_standalone.sv.
int print_part(SixStepDrive, const DriveFile& file, const Arguments& arguments) {
  if (arguments.circuit) {
    fmt::print("{}", design::circuit_text(file.settings, design::circuit_of(file.settings)));
    return kWell;
  }
  const double clock_hz = file.settings.control.clock_hz;
  const auto designed = design::design_drive(file.settings);
  const SixStepConfig config = hls_config(design::quantise(designed.parameters, clock_hz).config);
  const std::string name = name_of(arguments);
  fmt::print("{}", arguments.c_header ? registers::config_c_header(config, name, clock_hz)
                   : arguments.mem    ? registers::config_mem(config, name, clock_hz)
                                      : registers::config_verilog(config, name, clock_hz));
  return kWell;
}

int print_part(SinusoidalDrive, const DriveFile& file, const Arguments& arguments) {
  if (arguments.circuit) {
    throw BadInput(fmt::format("{}: --circuit is for six-step drives; leave it out", arguments.file));
  }
  const std::string name = name_of(arguments);
  const double clock_hz = file.settings.control.clock_hz;
  try {
    const SinusoidalConfig config = sinusoidal::config_of(file.settings);
    fmt::print("{}", arguments.c_header ? registers::config_c_header(config, name, clock_hz)
                     : arguments.mem    ? registers::config_mem(config, name, clock_hz)
                                        : registers::config_verilog(config, sinusoidal::adc_config_of(file.settings),
                                                                   name, clock_hz));
  } catch (const std::invalid_argument& e) {
    throw BadInput(fmt::format("{}: {}", arguments.file, e.what()));
  }
  return kWell;
}

int print_design(SixStepDrive, const DriveFile& file, const Arguments& arguments) {
  const DesignReport report = design_report(file.settings);
  fmt::print("{}", arguments.json ? report.json.dump(2) + "\n" : report.text);
  // With --json alone nothing but JSON is asked for.
  if (arguments.json && arguments.out.empty()) return kWell;
  namespace fs = std::filesystem;
  const fs::path out = arguments.out.empty()
                           ? fs::path("out") / (fs::path(arguments.file).stem().string() + "-design")
                           : fs::path(arguments.out);
  fs::create_directories(out);
  if (!draw(report.bode, out)) {
    fmt::print(stderr, "steplock: gnuplot does not run, so there is no Bode plot; "
                       "install gnuplot-nox\n");
    return kWell;
  }
  if (!arguments.json) fmt::print("  wrote {}\n", (out / "bode.svg").string());
  return kWell;
}

int print_design(SinusoidalDrive, const DriveFile& file, const Arguments& arguments) {
  fmt::print("{}", arguments.json ? sinusoidal::design_json(file.settings).dump(2) + "\n"
                                  : sinusoidal::design_text(file.settings));
  return kWell;
}

int design_drive_file(const Arguments& arguments) {
  DriveFile file = open_drive_file(arguments.file);
  if (arguments.clock_hz) {
    file.settings.control.clock_hz = *arguments.clock_hz;
    check_drive_file(file);  // words that fitted the file's clock need not fit this one
  }
  const bool part = arguments.c_header || arguments.verilog || arguments.mem || arguments.circuit;
  return with_drive(file.settings, [&](auto drive) {
    return part ? print_part(drive, file, arguments) : print_design(drive, file, arguments);
  });
}

}  // namespace

void add_design_command(CLI::App& app, int& exit_code) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand(
      "design", "Show what the design library makes of a drive file: filter, gains, margins, configuration.");
  command->add_option("FILE", arguments->file, "drive file")->required();
  command->add_flag("--json", arguments->json, "print as JSON");
  command->add_flag("--c-header", arguments->c_header,
                    "print the configuration as C initialisers for rtl/host/steplock.h, nothing else");
  command->add_flag("--verilog", arguments->verilog,
                    "print the configuration as constants around rtl/six_step_standalone.sv or sinusoidal_standalone.sv, nothing else");
  command->add_flag("--mem", arguments->mem,
                    "print the configuration as a list for $readmemh, offset and value of each register, nothing else");
  command->add_flag("--circuit", arguments->circuit,
                    "print dividers, filter, shunt and threshold in front of the FPGA, nothing else");
  command->add_option("--clock-hz", arguments->clock_hz, "clock of the board (default: the file's)");
  command->add_option("--out", arguments->out,
                      "directory for bode.svg (default out/<file>-design; with --json: none)");
  command->footer("Example: steplock design drives/amano2003.toml");
  command->callback([arguments, &exit_code] { exit_code = design_drive_file(*arguments); });
}

}  // namespace steplock
