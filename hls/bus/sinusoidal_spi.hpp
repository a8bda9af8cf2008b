// The sinusoidal drive behind an SPI slave, for a companion MCU: wires between the blocks, and nothing else.
//
//     SPI -> Spi -> SinusoidalCsr -> gates
//
// The map is docs/sinusoidal_registers.md, the frames are in docs/blocks/spi.md.  The drive's fault pin and
// its heartbeat watchdog do not pass the bus.
//
//     fault pin to all six gates off    3 clocks, as without the bus
//     sclk                              f_clk / 8 at most
//
// Doc: docs/blocks/sinusoidal_spi.md   Test: tests/hls/sinusoidal_spi_test.cpp

#pragma once

#include "hls/bus/sinusoidal_csr.hpp"
#include "hls/bus/spi.hpp"

namespace steplock {

class SinusoidalSpi {
 public:
  struct In {
    bool fault = false;         // asynchronous pin, active high
    CurrentSense::Codes codes;  // from the ADCs, once for each `sample`
    Kilohertz clock_khz = 0;    // constant: what CLOCK shows
    Spi::Pins spi;              // asynchronous
  };

  struct Out {
    Gates gates;
    bool sample = false;     // strobe: hold currents and dc voltage now
    bool interrupt = false;  // level
    bool locked = false;     // running, the estimate is claimed to be right
    bool fault = false;      // the drive's fault is latched
    SpiAnswers spi;
  };

  Out tick(const In& in) {
    const auto bus = bus_.tick({.pins = in.spi, .reply = reply_});
    const auto drive = drive_.tick({.fault = in.fault, .codes = in.codes, .clock_khz = in.clock_khz, .request = bus.request});
    reply_ = spi_reply(bus, drive);
    return {.gates = drive.gates,
            .sample = drive.sample,
            .interrupt = drive.interrupt,
            .locked = drive.locked,
            .fault = drive.fault,
            .spi = spi_answers(bus)};
  }

 private:
  Spi bus_;
  SinusoidalCsr drive_;
  Spi::Reply reply_;
};

}  // namespace steplock
