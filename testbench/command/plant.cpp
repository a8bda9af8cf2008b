#include <fmt/format.h>

#include <fstream>
#include <memory>

#include "testbench/command/command.hpp"
#include "testbench/drive_file/gate_events.hpp"
#include "testbench/report/report.hpp"
#include "testbench/run/check.hpp"

namespace steplock {
namespace {

struct Arguments {
  std::string file, gates, out;
  double dt = 1e-5;
  std::optional<double> duration;
  double angle_deg = 0;
};

int replay_gates(const Arguments& arguments) {
  const DriveFile file = open_drive_file(arguments.file);
  std::ifstream in(arguments.gates);
  if (!in) {
    throw BadInput(fmt::format("{}:1: cannot read this file; check the name", arguments.gates));
  }
  const std::vector<plant::GateEvent> events = read_gate_events(in, arguments.gates);
  const double duration = arguments.duration.value_or(events.back().time);

  std::string csv = "time_s,iu,iv,iw,vu,vv,vw,speed_rad_s,angle_rad,neutral_v,bus_v,source_a,torque_nm\n";
  plant::replay(plant_parameters(file.settings), initial_state(file.settings, arguments.angle_deg),
                events, arguments.dt, duration, [&](const plant::Sample& s) {
                  csv += fmt::format("{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.12g},{:.9g},{:.9g},{:.9g},{:.9g}\n",
                                     s.time, s.iu, s.iv, s.iw, s.vu, s.vv, s.vw, s.speed_rad_s,
                                     s.angle_rad, s.neutral_v, s.bus_v, s.source_a, s.torque_nm);
                });
  // Only when all of it is known: a failure leaves no half a file.
  write_file(arguments.out, csv);
  return kWell;
}

}  // namespace

void add_plant_command(CLI::App& app, int& exit_code) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command =
      app.add_subcommand("plant", "Replay gate events into the motor of a drive file.");
  command->add_option("FILE", arguments->file, "drive file")->required();
  command
      ->add_option("--gates", arguments->gates,
                   "CSV of events: time_s,uh,ul,vh,vl,wh,wl,load_nm; each holds until the next")
      ->required();
  command
      ->add_option("--out", arguments->out,
                   "CSV to write: time_s,iu,iv,iw,vu,vv,vw,speed_rad_s,angle_rad,neutral_v,bus_v,source_a,torque_nm")
      ->required();
  command->add_option("--dt", arguments->dt, "seconds between samples (default 1e-5)")
      ->check(CLI::Range(1e-9, 10.0));
  command->add_option("--duration", arguments->duration, "seconds (default: to the last event)")
      ->check(CLI::Range(0.0, 1000.0));
  command->add_option("--angle", arguments->angle_deg, "electrical degrees of the rotor at t = 0");
  command->footer(
      "Example: steplock plant drives/m2310p_servo.toml --gates gates.csv --out plant.csv --dt 1e-6");
  command->callback([arguments, &exit_code] { exit_code = replay_gates(*arguments); });
}

}  // namespace steplock
