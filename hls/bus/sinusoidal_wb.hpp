// The sinusoidal drive behind a Wishbone B4 slave: wires between the blocks, and nothing else.
//
//     Wishbone -> Wishbone -> SinusoidalCsr -> gates
//
// The map is docs/sinusoidal_registers.md.  A hole and a refused write end in err instead of ack.
//
//     fault pin to all six gates off    3 clocks, as without the bus
//     write of CONTROL to the drive     2 clocks
//
// Doc: docs/blocks/sinusoidal_wb.md   Test: tests/hls/sinusoidal_wb_test.cpp

#pragma once

#include "hls/bus/sinusoidal_csr.hpp"
#include "hls/bus/wishbone.hpp"

namespace steplock {

class SinusoidalWb {
 public:
  struct In {
    bool fault = false;         // asynchronous pin, active high
    CurrentSense::Codes codes;  // from the ADCs, once for each `sample`
    Kilohertz clock_khz = 0;    // constant: what CLOCK shows
    Wishbone::In wb;
  };

  struct Out {
    Gates gates;
    bool sample = false;     // strobe: hold currents and dc voltage now
    bool interrupt = false;  // level
    bool locked = false;     // running, the estimate is claimed to be right
    bool fault = false;      // the drive's fault is latched
    WishboneAnswers wb;
  };

  Out tick(const In& in) {
    const auto bus = bus_.tick(in.wb);
    const auto drive = drive_.tick({.fault = in.fault, .codes = in.codes, .clock_khz = in.clock_khz, .request = bus.request});
    return {.gates = drive.gates,
            .sample = drive.sample,
            .interrupt = drive.interrupt,
            .locked = drive.locked,
            .fault = drive.fault,
            .wb = wishbone_answers(bus, in.wb.we, drive)};
  }

 private:
  Wishbone bus_;
  SinusoidalCsr drive_;
};

}  // namespace steplock
