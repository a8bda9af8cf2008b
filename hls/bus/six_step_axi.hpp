// The six-step drive behind an AXI4-Lite slave: wires between the blocks, and nothing else.
//
//     AXI4-Lite -> AxiLite -> SixStepCsr -> gates
//
// The map is docs/six_step_registers.md.
//
//     fault pin to all six gates off    3 clocks, as without the bus
//     write of CONTROL to the drive     2 clocks
//
// Doc: docs/blocks/six_step_axi.md   Test: tests/hls/six_step_axi_test.cpp

#pragma once

#include "hls/bus/axi_lite.hpp"
#include "hls/bus/six_step_csr.hpp"

namespace steplock {

class SixStepAxi {
 public:
  struct In {
    Parts with;
    Synchroniser::Pins pins;  // asynchronous
    Kilohertz clock_khz = 0;  // constant: what CLOCK shows
    AxiLite::In axi;
  };

  struct Out {
    Gates gates;
    bool interrupt = false;  // level
    bool locked = false;     // running under speed control
    bool fault = false;      // the drive's fault is latched
    AxiAnswers axi;
  };

  Out tick(const In& in) {
    const auto bus = axi_.tick(in.axi);
    const auto drive = drive_.tick({.with = in.with, .pins = in.pins, .clock_khz = in.clock_khz, .request = bus.request});
    return {.gates = drive.gates,
            .interrupt = drive.interrupt,
            .locked = drive.locked,
            .fault = drive.fault,
            .axi = axi_answers(bus, drive)};
  }

 private:
  AxiLite axi_;
  SixStepCsr drive_;
};

}  // namespace steplock
