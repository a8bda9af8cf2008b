// PWM generator: on-time in clocks to a pulse, and the drive's slow time base.
//
//     on while  lead <= position < lead + on_clocks       lead = 0, or (period - on_clocks) / 2 if centred
//
// Period and on-time are taken together at the first clock of a period, so no pulse is made of two
// settings.  0 and `period` are exact: never on, and on without a gap from period to period.  An on- or
// off-time shorter than `minimum` becomes none.
//
//     latency      on-time to pulse: the next period      period 0: off, and the words are read each clock
//     registers    58 bits     multipliers  none
//
// Doc: docs/blocks/pwm_generator.md   Test: tests/hls/pwm_generator_test.cpp

#pragma once

#include "hls/numeric/bits.hpp"
#include "hls/six_step/words.hpp"

namespace steplock {

class PwmGenerator {
 public:
  struct In {
    Clocks on_clocks = 0;      // clocks of on-time; the period or more is 100 %
    Clocks period = 0;         // clocks
    Clocks minimum = 0;        // clocks
    bool centred = false;      // pulse in the middle of the period
    UInt<8> tick_periods = 1;  // periods per tick; 0 counts as 1
  };

  struct Out {
    bool on = false;     // the pulse
    bool start = false;  // first clock of a period
    bool tick = false;   // first clock of every `tick_periods`-th period
  };

  Out tick(const In& in) {
    const bool start = position_ == 0 && period_ != 0;
    const bool tick = start && periods_ == 0;
    const Clocks lead = in.centred ? wrap<Clocks>((period_ - on_) >> 1) : Clocks(0);
    const bool on = wrap<Clocks>(position_ - lead) < on_;

    const bool last = position_ + 1 >= period_;  // period 0 as well
    if (start) {
      periods_ = periods_ != 0            ? wrap<UInt<8>>(periods_ - 1)
                 : in.tick_periods == 0 ? UInt<8>(0)
                                          : wrap<UInt<8>>(in.tick_periods - 1);
    }
    if (last) {
      position_ = 0;
      period_ = in.period;
      on_ = pulse(in);
    } else {
      position_ = wrap<Clocks>(position_ + 1);
    }
    return {.on = on, .start = start, .tick = tick};
  }

 private:
  static Clocks pulse(const In& in) {
    if (in.on_clocks < in.minimum) return 0;
    return in.on_clocks + in.minimum > in.period ? in.period : in.on_clocks;
  }

  Clocks position_ = 0;
  Clocks period_ = 0;
  Clocks on_ = 0;
  UInt<8> periods_ = 0;  // to the next tick
};

}  // namespace steplock
