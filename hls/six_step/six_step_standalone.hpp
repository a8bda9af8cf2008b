// The six-step drive without a host: its words stand still, and pins run it.
//
//     run      high starts, low stops: by braking if `brake_to_stop`, else all six gates off
//     reverse  direction of rotation; a change while running slows down, and turns round
//     speed    (speed + 1) / 4 of the set speed, but never less than the hand-over frequency
//
// A switch bounces: what the pins say is taken every 2^17 clocks (11 ms at 12 MHz), but for the end
// of `run`, which counts at once.  A latched fault is re-armed by taking `run` away: again and again
// until its cause is gone.
//
//     fault pin to all six gates off    3 clocks, as without this block around it
//     `run` low to the drive            3 clocks, all gates off another 2 when it coasts
//     registers    30 bits beyond the drive's     multipliers  none
//
// Doc: docs/blocks/six_step_standalone.md   Test: tests/hls/six_step_standalone_test.cpp

#pragma once

#include "hls/six_step/six_step_top.hpp"

namespace steplock {

class SixStepStandalone {
 public:
  struct Controls {
    bool run = false;
    bool reverse = false;
    UInt<2> speed = 0;  // 0 to 3: a quarter to the whole of the set speed
  };

  struct In {
    Parameter<true> with_hall_decoder;
    Parameter<true> with_ramp;
    Parameter<true> with_follower;
    Synchroniser::Pins pins;  // asynchronous
    Controls controls;        // asynchronous too
    bool brake_to_stop = false;  // else coast; fixed at synthesis, as are the words
    SixStepConfig config;
  };

  struct Out {
    Gates gates;
    bool locked = false;  // running under speed control
    bool fault = false;   // latched
    bool turn = false;    // the divided VCO signal: a tachometer, one period per electrical turn
  };

  Out tick(const In& in) {
    SixStepConfig config = in.config;
    config.speed.target = target(in.config);
    const auto drive = drive_.tick({.with = {.hall_decoder = in.with_hall_decoder,
                                             .ramp = in.with_ramp,
                                             .follower = in.with_follower,
                                             .telemetry = false},  // no port shows a count
                                    .pins = in.pins,
                                    .command = {.configured = true,
                                                .run = run_,
                                                .reverse = taken_.reverse,
                                                .brake_to_stop = in.brake_to_stop,
                                                .clear_fault = takes_ && !run_},
                                    .config = config});
    run_ = taken_.run && second_.run;
    if (takes_) taken_ = second_;
    taken_.run = taken_.run && second_.run;
    takes_ = bounce_ == Bounce(0);
    bounce_ = wrap<Bounce>(bounce_ + 1);
    second_ = first_;
    first_ = in.controls;
    return {.gates = drive.gates,
            .locked = drive.locked,
            .fault = drive.state == State::kFault,
            .turn = drive.turn};
  }

 private:
  using Bounce = UInt<17>;

  // Quarters are sums of halves; below the hand-over no drive runs well.  All four are bounded before one
  // is taken: where the words are constants so are they, and the pins choose last.
  Frequency target(const SixStepConfig& config) const {
    const Frequency whole = config.speed.target;
    const Frequency half = whole >> 1;
    const Frequency quarter = whole >> 2;
    const Frequency least = config.start.hand_over;
    switch (taken_.speed.raw()) {
      case 0: return bounded(quarter, least);
      case 1: return bounded(half, least);
      case 2: return bounded(wrap<Frequency>(half + quarter), least);
      default: return bounded(whole, least);
    }
  }
  static Frequency bounded(Frequency part, Frequency least) { return part < least ? least : part; }

  SixStepTop drive_;
  Controls first_;   // two flip-flops for each pin; nothing but the second reads the first
  Controls second_;
  Controls taken_;   // what the drive is told
  bool run_ = false;    // and whether to run
  bool takes_ = false;  // the pins are taken in this clock
  Bounce bounce_ = 0;
};

}  // namespace steplock
