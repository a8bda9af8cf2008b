// One drive with its host and its motor.  `Drive` is SixStepAxiModule, or the module that
// `verilator --sc` makes of rtl/six_step_axi.f: nothing else changes.
//
//     HostModule  --TLM-2.0-->  AxiAdapter  --AXI4-Lite-->  Drive  --gates-->  MotorModule
//         <---------------------- interrupt ----------------   <-- comparators, limit --
//
// Doc: docs/systemc.md   Test: tests/testbench/CMakeLists.txt
#pragma once

#include <cmath>
#include <systemc>

#include "model/design/design.hpp"
#include "testbench/bus/register_config.hpp"
#include "testbench/drive_file/drive_file.hpp"
#include "testbench/drive/six_step/config.hpp"
#include "testbench/systemc/axi_adapter.hpp"
#include "testbench/systemc/drive_signals.hpp"
#include "testbench/systemc/host_module.hpp"
#include "testbench/systemc/motor_module.hpp"

namespace steplock {

inline HostModule::Plan plan_of(const design::Settings& s) {
  const double clock_hz = s.control.clock_hz;
  const design::Parameters p = design::design_drive(s).parameters;
  const SixStepConfig config = hls_config(design::quantise(p, clock_hz).config);
  // The ramp of the set speed from hand-over on, and what the speed then swings for.
  const double settle_s = (p.speed.target - p.start.hand_over) / p.speed.slew + 0.1;
  const auto erpm = static_cast<std::uint32_t>(s.scenario.speed_rpm * s.motor.pole_pairs);
  return {.config = register_config(config),
          .speed = steplock_speed(erpm, static_cast<std::uint32_t>(clock_hz),
                                  static_cast<unsigned>(config.loop.divide.raw())),
          .settle_s = settle_s};
}

template <class Drive>
class Bench : public sc_core::sc_module {
 public:
  sc_core::sc_in<bool> clk{"clk"}, rst{"rst"};
  DriveSignals wires;
  Drive drive{"drive"};
  AxiAdapter adapter{"adapter", wires};
  MotorModule motor;
  HostModule host;

  SC_HAS_PROCESS(Bench);
  Bench(sc_core::sc_module_name name, const design::Settings& s)
      : sc_module(name),
        motor("motor", wires, plant::Plant(plant_parameters(s), initial_state(s, 0)),
              s.control.clock_hz),
        host("host", plan_of(s)) {
    drive.clk(clk);
    drive.rst(rst);
    wires.bind(drive);
    wires.clock_khz = static_cast<std::uint32_t>(std::lround(s.control.clock_hz / 1e3));
    adapter.clk(clk);
    adapter.rst(rst);
    motor.clk(clk);
    host.socket.bind(adapter.socket);
    host.interrupt(wires.interrupt);
    SC_METHOD(measure);
    sensitive << host.measured;
    dont_initialize();
  }

  double measured_rpm() const { return rpm_; }  // when the host took its telemetry

 private:
  void measure() { rpm_ = motor.rpm(); }

  double rpm_ = 0;
};

}  // namespace steplock
