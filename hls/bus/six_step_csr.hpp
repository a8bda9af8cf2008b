// The six-step drive behind its registers, for any bus: wires between the blocks, and nothing else.
//
//     request -> ConfigRegisters -> words -> SixStepTop -> gates
//            \-> DriveRegisters <- status <-/
//
// The map is docs/six_step_registers.md.  A second PwmGenerator with the drive's own period runs in step
// with that of the drive and tells its boundaries, so that the drive needs no further port.
//
//     request to its answer             1 clock, kept until the next request of its kind
//     fault pin to all six gates off    3 clocks, as without the registers
//
// Doc: docs/blocks/six_step_csr.md   Test: tests/hls/six_step_csr_test.cpp

#pragma once

#include "hls/bus/drive_registers.hpp"
#include "hls/bus/six_step_registers.hpp"
#include "hls/bus/config_registers.hpp"
#include "hls/six_step/six_step_top.hpp"

namespace steplock {

class SixStepCsr {
 public:
  struct In {
    Parts with;
    Synchroniser::Pins pins;  // asynchronous
    Kilohertz clock_khz = 0;  // constant: what CLOCK shows
    BusRequest request;
  };

  struct Out {
    Gates gates;
    bool interrupt = false;    // level
    bool locked = false;       // running under speed control
    bool fault = false;        // the drive's fault is latched
    UInt<32> data = 0;         // of the last read
    bool read_error = false;   // it was of a hole
    bool write_error = false;  // the last write was refused
  };

  Out tick(const In& in) {
    const auto config =
        config_registers_.tick({.request = in.request, .stopped = stopped_, .boundary = boundary_});
    const auto pwm = pwm_.tick({.on_clocks = 0,
                                .period = config.config.pwm.period,
                                .minimum = 0,
                                .centred = false,
                                .tick_periods = config.config.pwm.tick_periods});
    const auto drive = drive_.tick({.with = in.with, .pins = in.pins, .command = command_, .config = config.config});
    const auto registers = registers_.tick({.request = in.request,
                                            .word = config.data,
                                            .hole = config.hole,
                                            .refused = config.refused,
                                            .unlocked = config.unlocked,
                                            .no_period = config.no_period,
                                            .tick = pwm.tick,
                                            .clock_khz = in.clock_khz,
                                            .drive = {.state = drive.state,
                                                      .reason = drive.reason,
                                                      .locked = drive.locked,
                                                      .reverse = drive.reverse,
                                                      .frequency = drive.frequency,
                                                      .duty = drive.duty,
                                                      .phase_error = drive.phase_error,
                                                      .counts = drive.counts}});

    UInt<32> absent = 0;
    if (read_capability_ && !in.with.hall_decoder) absent = absent | UInt<32>::of(mask_of(field("CAPABILITY", "hall")));
    if (read_capability_ && !in.with.telemetry) absent = absent | UInt<32>::of(mask_of(field("CAPABILITY", "counters")));
    if (read_capability_ && !in.with.ramp) absent = absent | UInt<32>::of(mask_of(field("CAPABILITY", "ramp")));
    if (read_capability_ && !in.with.follower) absent = absent | UInt<32>::of(mask_of(field("CAPABILITY", "follower")));
    if (in.request.read) read_capability_ = in.request.index == UInt<10>(index_of("CAPABILITY"));

    // Both have to rest: what was told to run may have left idle since.
    stopped_ = registers.stopped && !command_.run && !registers.command.run;
    command_ = registers.command;
    boundary_ = pwm.start;
    return {.gates = drive.gates,
            .interrupt = registers.interrupt,
            .locked = drive.locked,
            .fault = drive.state == State::kFault,
            .data = registers.data & ~absent,
            .read_error = registers.read_error,
            .write_error = registers.write_error};
  }

 private:
  ConfigRegisters<> config_registers_;
  PwmGenerator pwm_;  // of the drive's period alone, for its boundaries and ticks
  SixStepTop drive_;
  DriveRegisters<> registers_;

  Command command_;
  bool stopped_ = true;
  bool boundary_ = false;
  bool read_capability_ = false;
};

}  // namespace steplock
