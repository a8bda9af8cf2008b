// The sinusoidal drive behind its registers, for any bus: wires between the blocks, and little else.
//
//     request -> ConfigRegisters -> words -> SinusoidalTop -> gates
//            \-> DriveRegisters <- status <----/
//
// The map is docs/sinusoidal_registers.md.  A sample is computed over many clocks, from `valid` to the
// drive's `done`: the set-point is taken over with the codes, as are the orders of the drive's own
// sequence, and the drive takes no codes while a sample is under way.  So no sample of a running
// drive sees two values of a word.
//
//     request to its answer             1 clock, kept until the next request of its kind
//     a tick of the watchdog            16 PWM periods
//     fault pin to all six gates off    3 clocks, as without the registers
//     registers    11 bits beyond those of the blocks     multipliers  none
//
// Doc: docs/blocks/sinusoidal_csr.md   Test: tests/hls/sinusoidal_csr_test.cpp

#pragma once

#include "hls/bus/drive_registers.hpp"
#include "hls/bus/sinusoidal_registers.hpp"
#include "hls/bus/config_registers.hpp"
#include "hls/sinusoidal/sinusoidal_top.hpp"

namespace steplock {

class SinusoidalCsr {
 public:
  struct In {
    bool fault = false;         // asynchronous pin, active high
    CurrentSense::Codes codes;  // from the ADCs, once for each `sample`
    Kilohertz clock_khz = 0;    // constant: what CLOCK shows
    BusRequest request;
  };

  struct Out {
    Gates gates;
    bool sample = false;       // strobe: hold currents and dc voltage now
    bool interrupt = false;    // level
    bool locked = false;       // running, the estimate is claimed to be right
    bool fault = false;        // the drive's fault is latched
    UInt<32> data = 0;         // of the last read
    bool read_error = false;   // it was of a hole
    bool write_error = false;  // the last write was refused
  };

  Out tick(const In& in) {
    const auto config = config_registers_.tick(
        {.request = in.request, .stopped = stopped_, .boundary = in.codes.valid && !busy_});
    const auto drive = drive_.tick({.fault = in.fault,
                                    .codes = in.codes,
                                    .command = command_,
                                    .config = config.config});
    const auto registers = registers_.tick({.request = in.request,
                                            .word = config.data,
                                            .hole = config.hole,
                                            .refused = config.refused,
                                            .unlocked = config.unlocked,
                                            .no_period = config.no_period,
                                            .tick = drive.sample && periods_ == 0,
                                            .clock_khz = in.clock_khz,
                                            .drive = {.state = drive.state,
                                                      .reason = drive.reason,
                                                      .locked = drive.locked,
                                                      .reverse = drive.reverse,
                                                      .speed = drive.speed,
                                                      .reference = drive.reference,
                                                      .i_gamma = drive.i_gamma,
                                                      .i_delta = drive.i_delta,
                                                      .angle = drive.angle.slice<23, 8>(),
                                                      .v_dc = drive.v_dc,
                                                      .on_u = drive.on_u,
                                                      .on_v = drive.on_v,
                                                      .on_w = drive.on_w,
                                                      .retries = drive.retries}});

    // Both have to rest: what was told to run may have left idle since.
    stopped_ = registers.stopped && !command_.run && !registers.command.run;
    command_ = registers.command;
    if (drive.sample) periods_ = wrap<UInt<4>>(periods_ + 1);
    busy_ = drive.busy;
    return {.gates = drive.gates,
            .sample = drive.sample,
            .interrupt = registers.interrupt,
            .locked = drive.locked,
            .fault = drive.state == SinusoidalState::kFault,
            .data = registers.data,
            .read_error = registers.read_error,
            .write_error = registers.write_error};
  }

 private:
  ConfigRegisters<Sinusoidal> config_registers_;
  SinusoidalTop drive_;
  DriveRegisters<Sinusoidal> registers_;

  Command command_;
  bool stopped_ = true;
  bool busy_ = false;     // a sample is under way, as the drive says
  UInt<4> periods_ = 0;   // begun, of a tick
};

}  // namespace steplock
