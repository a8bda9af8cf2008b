// Motor, inverter and sensors as a SystemC module: looks at the gates and shows the pins on every
// rising edge.
//
// Time is that of the clock's edges, counted: SystemC rounds a period to picoseconds, the plant
// none.
//
// Doc: docs/plant.md   Test: tests/testbench/CMakeLists.txt
#pragma once

#include <cstdint>
#include <systemc>

#include "model/plant/plant.hpp"
#include "testbench/systemc/drive_signals.hpp"

namespace steplock {

class MotorModule : public sc_core::sc_module {
 public:
  sc_core::sc_in<bool> clk{"clk"};

  SC_HAS_PROCESS(MotorModule);
  MotorModule(sc_core::sc_module_name name, DriveSignals& pins, plant::Plant plant, double clock_hz)
      : sc_module(name), pins_(pins), plant_(std::move(plant)), clock_hz_(clock_hz) {
    SC_METHOD(tick);
    sensitive << clk.pos();
    dont_initialize();
  }

  double rpm() {
    plant_.advance_to(time());
    return plant_.state().speed * 60 / (2 * 3.14159265358979);
  }
  std::uint64_t shoot_throughs() const { return plant_.shoot_throughs(); }

 private:
  double time() const { return static_cast<double>(clocks_) / clock_hz_; }

  void tick() {
    ++clocks_;
    const plant::Gates gates{.uh = pins_.gate[0].read(),
                             .ul = pins_.gate[1].read(),
                             .vh = pins_.gate[2].read(),
                             .vl = pins_.gate[3].read(),
                             .wh = pins_.gate[4].read(),
                             .wl = pins_.gate[5].read()};
    const bool changed = !(gates == plant_.gates());
    if (!changed && time() < plant_.next_event()) return;
    plant_.advance_to(time());
    if (changed) plant_.set_gates(gates);
    const plant::Pins& seen = plant_.pins();
    for (int k = 0; k < 3; ++k) {
      pins_.comparator[k] = seen.comparator[static_cast<std::size_t>(k)];
      pins_.hall[k] = seen.hall[static_cast<std::size_t>(k)];
    }
    pins_.limit = seen.limit;
  }

  DriveSignals& pins_;
  plant::Plant plant_;
  double clock_hz_;
  std::uint64_t clocks_ = 0;
};

}  // namespace steplock
