// The sinusoidal drive behind an APB4 slave: wires between the blocks, and nothing else.
//
//     APB -> Apb -> SinusoidalCsr -> gates
//
// The map is docs/sinusoidal_registers.md.  A hole and a refused write end with pslverr.
//
//     fault pin to all six gates off    3 clocks, as without the bus
//     write of CONTROL to the drive     2 clocks
//
// Doc: docs/blocks/sinusoidal_apb.md   Test: tests/hls/sinusoidal_apb_test.cpp

#pragma once

#include "hls/bus/apb.hpp"
#include "hls/bus/sinusoidal_csr.hpp"

namespace steplock {

class SinusoidalApb {
 public:
  struct In {
    bool fault = false;         // asynchronous pin, active high
    CurrentSense::Codes codes;  // from the ADCs, once for each `sample`
    Kilohertz clock_khz = 0;    // constant: what CLOCK shows
    Apb::In apb;
  };

  struct Out {
    Gates gates;
    bool sample = false;     // strobe: hold currents and dc voltage now
    bool interrupt = false;  // level
    bool locked = false;     // running, the estimate is claimed to be right
    bool fault = false;      // the drive's fault is latched
    ApbAnswers apb;
  };

  Out tick(const In& in) {
    const auto bus = bus_.tick(in.apb);
    const auto drive = drive_.tick({.fault = in.fault, .codes = in.codes, .clock_khz = in.clock_khz, .request = bus.request});
    return {.gates = drive.gates,
            .sample = drive.sample,
            .interrupt = drive.interrupt,
            .locked = drive.locked,
            .fault = drive.fault,
            .apb = apb_answers(bus, in.apb.pwrite, drive)};
  }

 private:
  Apb bus_;
  SinusoidalCsr drive_;
};

}  // namespace steplock
