// turn DRIVE.toml: the bit-exact model of the six-step drive turns the motor of a drive file, clock
// by clock, from rest to its set speed.  Exit code 0: locked, and within 5 % of it.
#include <cmath>
#include <cstdio>

#include "hls/six_step/six_step_top.hpp"
#include "model/design/design.hpp"
#include "testbench/drive_file/drive_file.hpp"
#include "testbench/drive/six_step/fixed_engine.hpp"
#include "testbench/drive/six_step/config.hpp"

int main(int count, char** arguments) {
  using namespace steplock;
  if (count != 2) return std::fprintf(stderr, "turn: want DRIVE.toml\n"), 2;
  try {
    const design::Settings settings = load_drive_file(arguments[1]).settings;
    const double clock_hz = settings.control.clock_hz;
    const auto quantised = design::quantise(design::design_drive(settings).parameters, clock_hz);
    plant::Plant motor(plant_parameters(settings), initial_state(settings, 0));

    SixStepTop drive;
    SixStepTop::In in{.command = {.configured = true, .run = true},
                      .config = hls_config(quantised.config)};
    SixStepTop::Out out;
    for (double clock = 0; clock < 0.5 * clock_hz; ++clock) {
      const double now = clock / clock_hz;
      if (now >= motor.next_event()) motor.advance_to(now);
      put_pins(in.pins, motor.pins());
      out = drive.tick(in);
      if (const plant::Gates gates = watch_of(out).gates(); gates != motor.gates()) {
        motor.advance_to(now);
        motor.set_gates(gates);
      }
    }
    const double rpm = motor.state().speed * 60 / (2 * 3.14159265358979);
    const double wanted = settings.scenario.speed_rpm;
    std::printf("%s: %.0f r/min of %.0f after 0.5 s\n", out.locked ? "locked" : "not locked", rpm,
                wanted);
    return out.locked && std::abs(rpm - wanted) < 0.05 * wanted ? 0 : 1;
  } catch (const BadInput& problem) {
    std::fprintf(stderr, "%s\n", problem.what());
    return 1;
  }
}
