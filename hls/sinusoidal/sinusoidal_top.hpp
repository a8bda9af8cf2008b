// The sinusoidal drive: wires between the blocks, and nothing else.
//
//     codes -> CurrentSense -> SinusoidalControl -> next period -> 3 x PwmGenerator -> GateGuard -> gates
//                               ^ on-clocks of the period that ended
//
// PilotPulses is asked first in a start by pilot pulses: one leg's on-time for all, its choice of
// legs, SinusoidalControl for its arithmetic.  It sees what the others gave a clock before.
//
// SinusoidalControl is one program, begun when a sample has been taken.  SinusoidalSequence says who
// is closed when; DriveProtection watches.  What the sequence says is taken over when a sample is
// taken, so that all of it works under the same orders.
//
// `sample` is a strobe at the start of a PWM period: the ADCs are to hold what stands then,
// and give their codes with `valid` so early that the sample is done before the next period.  Codes
// that come while one is under way are not taken, and DriveProtection counts the lost sample.
//
//     `sample` to new on-clocks          230 clocks, if the codes come at once
//     `sample` to `done`                 477 clocks: less than a period
//     fault pin to all six gates off     3 clocks
//
// Doc: docs/blocks/sinusoidal_top.md   Test: tests/hls/sinusoidal_top_test.cpp

#pragma once

#include "hls/bridge/gate_guard.hpp"
#include "hls/bridge/pwm_generator.hpp"
#include "hls/bridge/synchroniser.hpp"
#include "hls/sinusoidal/current_sense.hpp"
#include "hls/sinusoidal/drive_protection.hpp"
#include "hls/sinusoidal/pilot_pulses.hpp"
#include "hls/sinusoidal/sinusoidal_control.hpp"
#include "hls/sinusoidal/sinusoidal_sequence.hpp"
#include "hls/sinusoidal/config.hpp"

namespace steplock {

class SinusoidalTop {
 public:
  struct In {
    bool fault = false;          // asynchronous pin, active high
    CurrentSense::Codes codes;   // from the ADCs
    Command command;
    SinusoidalConfig config;
  };

  struct Out {
    Gates gates;
    SinusoidalState state = SinusoidalState::kIdle;
    SinusoidalReason reason = SinusoidalReason::kNone;
    bool sample = false;      // strobe: hold currents and dc voltage now
    bool locked = false;      // running, the estimate is claimed to be right
    bool estimating = false;  // the loop is closed
    bool done = false;        // strobe: a sample is worked through
    bool busy = false;        // one is under way: codes of the next clock are not taken
    bool reverse = false;     // the wanted direction
    UInt<4> retries = 0;      // attempts that failed and were followed by another one, since `run` was obeyed
    Angle angle = 0;          // u0.24, electrical turns, at the last sample
    Angle initial = 0;        // u0.24, where the estimate begins: once found, by pilot pulses
    Int<16> speed = 0;        // s0.15 of 1/16 turn per sample, smoothed
    Int<16> reference = 0;    // the same, slewed, in the wanted direction
    Int<16> i_gamma = 0;      // s0.15
    Int<16> i_delta = 0;      // s0.15
    Int<16> wanted = 0;       // s0.15, i_delta*
    UInt<12> v_dc = 0;        // u0.12, of the last sample
    LegClocks on_u = 0;       // clocks, of the next period
    LegClocks on_v = 0;
    LegClocks on_w = 0;
    bool operator==(const Out&) const = default;
  };

  Out tick(const In& in) {
    const SinusoidalConfig& config = in.config;
    auto codes = in.codes;
    codes.valid = in.codes.valid && !busy_;
    const auto pins = synchroniser_.tick({.fault = in.fault});
    const auto pilot = pilot_.tick({.rest = orders_.calibrate && !busy_,  // a sample under way reads what is cleared
                                    .enable = orders_.pilot,
                                    .period = seen_.period,
                                    .taken = seen_.taken,
                                    .sampled = seen_.sampled,
                                    .over = seen_.over,
                                    .i_gamma = seen_.i_gamma,
                                    .backward = seen_.backward,
                                    .config = config.pilot});
    const auto sense = sense_.tick(
        {.codes = codes,
         .calibrate = orders_.calibrate,
         .over_current = waiting_ ? config.pilot.decayed : config.fault.over_current});
    const auto control = control_.tick({{.estimate = orders_.estimate,
                                         .regulate = orders_.regulate,
                                         .locked = orders_.locked,
                                         .reverse = orders_.reverse,
                                         .slow_down = orders_.slow_down,
                                         .hold = orders_.hold,
                                         .hold_u = orders_.hold_u,
                                         .hold_v = orders_.hold_v,
                                         .hold_w = orders_.hold_w,
                                         .pilot = orders_.pilot,
                                         .search = pilot.search,
                                         .a = pilot.a,
                                         .b = pilot.b,
                                         .initial = pilot.angle,
                                         .i_u = sense.i_u,
                                         .i_v = sense.i_v,
                                         .v_dc = sense.v_dc,
                                         .ended = ended_,
                                         .bridge = config.bridge,
                                         .estimator = config.estimator,
                                         .speed = config.speed,
                                         .control = config.control,
                                         .hold_voltage = config.sequence.hold_voltage},
                                        sense.taken});
    const auto& legs = control.early;
    const auto& speed = control.speed;

    const auto u = pwm_u_.tick(pulse(legs.on_u, config.bridge));
    const auto v = pwm_v_.tick(pulse(legs.on_v, config.bridge));
    const auto w = pwm_w_.tick(pulse(legs.on_w, config.bridge));

    // Until the words are there, no sample is due and no current too large.
    const bool configured = in.command.configured;
    const auto faults = protection_.tick({.restart = restart_,
                                          .period = u.start && configured,
                                          .sampled = control.done,
                                          .over_current = sense.over && !waiting_ && configured,
                                          .regulating = orders_.regulate,
                                          .saturated = control.limited || speed.saturated,
                                          .locked = orders_.locked,
                                          .fast = speed.fast,
                                          .slow = speed.slow,
                                          .plausible = speed.plausible,
                                          .config = config.fault});
    const auto now = sequence_.tick({.command = in.command,
                                     .fault_pin = pins.fault,
                                     .period = u.start,
                                     .sampled = control.done,
                                     .measured = sense.measured,
                                     .fast = speed.fast,
                                     .plausible = speed.plausible,
                                     .stopping = speed.stopping,
                                     .found = pilot.found,
                                     .still = still_,
                                     .fatal = faults.fatal,
                                     .failed = orders_.pilot ? pilot.failed : faults.failed,
                                     .config = config.sequence});

    const bool off = !now.modulate && !(now.pilot && pilot.pulse);
    const bool on_u = now.pilot ? pilot.high_u && u.on : u.on;
    const bool on_v = now.pilot ? pilot.high_v && u.on : v.on;
    const bool on_w = now.pilot ? pilot.high_w && u.on : w.on;
    const auto gates = guard_.tick({.request = {.uh = !off && on_u,
                                                .ul = now.brake || (!off && !on_u),
                                                .vh = !off && on_v,
                                                .vl = now.brake || (!off && !on_v),
                                                .wh = !off && on_w,
                                                .wl = now.brake || (!off && !on_w)},
                                    .enable = configured,
                                    .fault = pins.fault,
                                    .dead_time = config.bridge.dead_time});

    still_ = config.speed.target == 0;
    restart_ = now.entered;
    waiting_ = pilot.waiting;
    seen_ = {.period = u.start,
             .taken = sense.taken,
             .sampled = control.done,
             .over = sense.over,
             .i_gamma = control.i_gamma,
             .backward = control.i_delta.negative()};
    if (codes.valid) orders_ = now;
    busy_ = (busy_ || codes.valid) && !control.done;
    if (u.start) {
      ended_ = running_;
      running_ = legs;
    }
    return {.gates = gates,
            .state = now.state,
            .reason = now.reason,
            .sample = u.start,
            .locked = now.locked,
            .estimating = now.regulate,
            .done = control.done,
            .busy = busy_,
            .reverse = now.reverse,
            .retries = now.retries,
            .angle = control.angle,
            .initial = pilot.angle,
            .speed = speed.speed,
            .reference = speed.reference,
            .i_gamma = control.i_gamma,
            .i_delta = control.i_delta,
            .wanted = speed.current,
            .v_dc = sense.v_dc,
            .on_u = legs.on_u,
            .on_v = legs.on_v,
            .on_w = legs.on_w};
  }

 protected:  // testbench/drive/sinusoidal/skipping_top.hpp counts with these
  // What PilotPulses hears of a clock in the next one.
  struct Seen {
    bool period = false;
    bool taken = false;
    bool sampled = false;
    bool over = false;
    Int<16> i_gamma = 0;  // s0.15
    bool backward = false;
  };

  static PwmGenerator::In pulse(LegClocks on, const BridgeConfig& config) {
    return {.on_clocks = on, .period = config.period, .minimum = config.minimum, .centred = true};
  }

  Synchroniser synchroniser_;
  PilotPulses pilot_;
  CurrentSense sense_;
  SinusoidalLoop control_;
  PwmGenerator pwm_u_;
  PwmGenerator pwm_v_;
  PwmGenerator pwm_w_;
  DriveProtection protection_;
  SinusoidalSequence sequence_;
  GateGuard<> guard_;

  SinusoidalSequence::Out orders_;  // as of the present sample
  SpaceVector::Out running_;        // of the present period
  SpaceVector::Out ended_;          // of the one before
  Seen seen_;
  bool busy_ = false;               // a sample is under way
  bool restart_ = false;
  bool still_ = false;  // the set speed is 0
  bool waiting_ = false;            // for the current to decay
};

}  // namespace steplock
