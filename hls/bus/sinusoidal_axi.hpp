// The sinusoidal drive behind an AXI4-Lite slave: wires between the blocks, and nothing else.
//
//     AXI4-Lite -> AxiLite -> SinusoidalCsr -> gates
//
// The map is docs/sinusoidal_registers.md.
//
//     fault pin to all six gates off    3 clocks, as without the bus
//     write of CONTROL to the drive     2 clocks
//
// Doc: docs/blocks/sinusoidal_axi.md   Test: tests/hls/sinusoidal_axi_test.cpp

#pragma once

#include "hls/bus/axi_lite.hpp"
#include "hls/bus/sinusoidal_csr.hpp"

namespace steplock {

class SinusoidalAxi {
 public:
  struct In {
    bool fault = false;         // asynchronous pin, active high
    CurrentSense::Codes codes;  // from the ADCs, once for each `sample`
    Kilohertz clock_khz = 0;    // constant: what CLOCK shows
    AxiLite::In axi;
  };

  struct Out {
    Gates gates;
    bool sample = false;     // strobe: hold currents and dc voltage now
    bool interrupt = false;  // level
    bool locked = false;     // running, the estimate is claimed to be right
    bool fault = false;      // the drive's fault is latched
    AxiAnswers axi;
  };

  Out tick(const In& in) {
    const auto bus = bus_.tick(in.axi);
    const auto drive = drive_.tick({.fault = in.fault, .codes = in.codes, .clock_khz = in.clock_khz, .request = bus.request});
    return {.gates = drive.gates,
            .sample = drive.sample,
            .interrupt = drive.interrupt,
            .locked = drive.locked,
            .fault = drive.fault,
            .axi = axi_answers(bus, drive)};
  }

 private:
  AxiLite bus_;
  SinusoidalCsr drive_;
};

}  // namespace steplock
