// The six-step drive behind a Wishbone B4 slave: wires between the blocks, and nothing else.
//
//     Wishbone -> Wishbone -> SixStepCsr -> gates
//
// The map is docs/six_step_registers.md.  A hole and a refused write end in err instead of ack.
//
//     fault pin to all six gates off    3 clocks, as without the bus
//     write of CONTROL to the drive     2 clocks
//
// Doc: docs/blocks/six_step_wb.md   Test: tests/hls/six_step_wb_test.cpp

#pragma once

#include "hls/bus/six_step_csr.hpp"
#include "hls/bus/wishbone.hpp"

namespace steplock {

class SixStepWb {
 public:
  struct In {
    Parts with;
    Synchroniser::Pins pins;  // asynchronous
    Kilohertz clock_khz = 0;  // constant: what CLOCK shows
    Wishbone::In wb;
  };

  struct Out {
    Gates gates;
    bool interrupt = false;  // level
    bool locked = false;     // running under speed control
    bool fault = false;      // the drive's fault is latched
    WishboneAnswers wb;
  };

  Out tick(const In& in) {
    const auto bus = bus_.tick(in.wb);
    const auto drive = drive_.tick({.with = in.with, .pins = in.pins, .clock_khz = in.clock_khz, .request = bus.request});
    return {.gates = drive.gates,
            .interrupt = drive.interrupt,
            .locked = drive.locked,
            .fault = drive.fault,
            .wb = wishbone_answers(bus, in.wb.we, drive)};
  }

 private:
  Wishbone bus_;
  SixStepCsr drive_;
};

}  // namespace steplock
