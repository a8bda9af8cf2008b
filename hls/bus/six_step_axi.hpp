// The six-step drive behind an AXI4-Lite slave: wires between the blocks, and nothing else.
//
//     AXI4-Lite -> AxiLite -> WordRegisters -> words -> SixStepTop -> gates
//                        \-> DriveRegisters <- status <-/
//
// The map is docs/registers.md.  A second PwmGenerator with the drive's own period runs in step
// with that of the drive and tells its boundaries, so that the drive needs no further port.
//
//     fault pin to all six gates off    3 clocks, as without the bus
//     write of CONTROL to the drive     2 clocks
//
// Doc: docs/blocks/six_step_axi.md   Test: tests/hls/six_step_axi_test.cpp

#pragma once

#include "hls/bus/axi_lite.hpp"
#include "hls/bus/drive_registers.hpp"
#include "hls/bus/word_registers.hpp"
#include "hls/six_step/six_step_top.hpp"

namespace steplock {

class SixStepAxi {
 public:
  struct In {
    Synchroniser::Pins pins;  // asynchronous
    AxiLite::In axi;
  };

  struct Axi {
    bool awready = false;
    bool wready = false;
    bool bvalid = false;
    UInt<2> bresp = 0;  // 0 okay, 2 SLVERR
    bool arready = false;
    bool rvalid = false;
    UInt<32> rdata = 0;
    UInt<2> rresp = 0;
  };

  struct Out {
    Gates gates;
    bool interrupt = false;  // level
    bool locked = false;     // running under speed control
    bool fault = false;      // the drive's fault is latched
    Axi axi;
  };

  Out tick(const In& in) {
    const auto bus = axi_.tick(in.axi);
    const auto words =
        words_.tick({.request = bus.request, .stopped = stopped_, .boundary = boundary_});
    const auto pwm = pwm_.tick({.on_clocks = 0,
                                .period = words.words.pwm.period,
                                .minimum = 0,
                                .centred = false,
                                .tick_periods = words.words.pwm.tick_periods});
    const auto drive = drive_.tick({.pins = in.pins, .command = command_, .words = words.words});
    const auto registers = registers_.tick({.request = bus.request,
                                            .word = words.data,
                                            .hole = words.hole,
                                            .refused = words.refused,
                                            .unlocked = words.unlocked,
                                            .tick = pwm.tick,
                                            .drive = {.state = drive.state,
                                                      .reason = drive.reason,
                                                      .locked = drive.locked,
                                                      .reverse = drive.reverse,
                                                      .frequency = drive.frequency,
                                                      .duty = drive.duty,
                                                      .phase_error = drive.phase_error,
                                                      .counts = drive.counts}});

    // Both have to rest: what was told to run may have left idle since.
    stopped_ = registers.stopped && !command_.run && !registers.command.run;
    command_ = registers.command;
    boundary_ = pwm.start;
    return {.gates = drive.gates,
            .interrupt = registers.interrupt,
            .locked = drive.locked,
            .fault = drive.state == State::kFault,
            .axi = {.awready = bus.awready,
                    .wready = bus.wready,
                    .bvalid = bus.bvalid,
                    .bresp = registers.write_error ? UInt<2>(2) : UInt<2>(0),
                    .arready = bus.arready,
                    .rvalid = bus.rvalid,
                    .rdata = registers.data,
                    .rresp = registers.read_error ? UInt<2>(2) : UInt<2>(0)}};
  }

 private:
  AxiLite axi_;
  WordRegisters words_;
  PwmGenerator pwm_;  // of the drive's period alone, for its boundaries and ticks
  SixStepTop drive_;
  DriveRegisters registers_;

  Command command_;
  bool stopped_ = true;
  bool boundary_ = false;
};

}  // namespace steplock
