// The six-step drive behind an SPI slave, for a companion MCU: wires between the blocks, and nothing else.
//
//     SPI -> Spi -> SixStepCsr -> gates
//
// The map is docs/six_step_registers.md, the frames are in docs/blocks/spi.md.  The drive's fault pin and its
// heartbeat watchdog do not pass the bus.
//
//     fault pin to all six gates off    3 clocks, as without the bus
//     sclk                              f_clk / 8 at most
//
// Doc: docs/blocks/six_step_spi.md   Test: tests/hls/six_step_spi_test.cpp

#pragma once

#include "hls/bus/six_step_csr.hpp"
#include "hls/bus/spi.hpp"

namespace steplock {

class SixStepSpi {
 public:
  struct In {
    Parts with;
    Synchroniser::Pins pins;  // asynchronous
    Kilohertz clock_khz = 0;  // constant: what CLOCK shows
    Spi::Pins spi;            // asynchronous
  };

  struct Out {
    Gates gates;
    bool interrupt = false;  // level
    bool locked = false;     // running under speed control
    bool fault = false;      // the drive's fault is latched
    SpiAnswers spi;
  };

  Out tick(const In& in) {
    const auto bus = bus_.tick({.pins = in.spi, .reply = reply_});
    const auto drive = drive_.tick({.with = in.with, .pins = in.pins, .clock_khz = in.clock_khz, .request = bus.request});
    reply_ = spi_reply(bus, drive);
    return {.gates = drive.gates,
            .interrupt = drive.interrupt,
            .locked = drive.locked,
            .fault = drive.fault,
            .spi = spi_answers(bus)};
  }

 private:
  Spi bus_;
  SixStepCsr drive_;
  Spi::Reply reply_;
};

}  // namespace steplock
