// The six-step drive behind an APB4 slave: wires between the blocks, and nothing else.
//
//     APB -> Apb -> SixStepCsr -> gates
//
// The map is docs/six_step_registers.md.  A hole and a refused write end with pslverr.
//
//     fault pin to all six gates off    3 clocks, as without the bus
//     write of CONTROL to the drive     2 clocks
//
// Doc: docs/blocks/six_step_apb.md   Test: tests/hls/six_step_apb_test.cpp

#pragma once

#include "hls/bus/apb.hpp"
#include "hls/bus/six_step_csr.hpp"

namespace steplock {

class SixStepApb {
 public:
  struct In {
    Parts with;
    Synchroniser::Pins pins;  // asynchronous
    Kilohertz clock_khz = 0;  // constant: what CLOCK shows
    Apb::In apb;
  };

  struct Out {
    Gates gates;
    bool interrupt = false;  // level
    bool locked = false;     // running under speed control
    bool fault = false;      // the drive's fault is latched
    ApbAnswers apb;
  };

  Out tick(const In& in) {
    const auto bus = bus_.tick(in.apb);
    const auto drive = drive_.tick({.with = in.with, .pins = in.pins, .clock_khz = in.clock_khz, .request = bus.request});
    return {.gates = drive.gates,
            .interrupt = drive.interrupt,
            .locked = drive.locked,
            .fault = drive.fault,
            .apb = apb_answers(bus, in.apb.pwrite, drive)};
  }

 private:
  Apb bus_;
  SixStepCsr drive_;
};

}  // namespace steplock
