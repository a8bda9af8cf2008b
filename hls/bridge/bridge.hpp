// The bridge's own terms: what every drive says to it, and what firmware sets of it.
//
// Every configuration word is an input of the top and may change at any clock; where a change
// takes effect later, its comment says when.  A "tick" is `tick_periods` PWM periods, about a
// millisecond: the time base of everything slow.
//
// Doc: docs/theory.md

#pragma once

#include "hls/numeric/bits.hpp"

namespace steplock {

using Clocks = UInt<14>;     // durations up to a PWM period
using Duty = UInt<16>;       // u1.15, 0x8000 is 100 %
using Ticks = UInt<12>;      // about milliseconds

// Six switches, or the wish that they be closed.
struct Gates {
  bool uh = false;  // phase U, high side
  bool ul = false;  // phase U, low side
  bool vh = false;  // phase V, high side
  bool vl = false;  // phase V, low side
  bool wh = false;  // phase W, high side
  bool wl = false;  // phase W, low side
  bool operator==(const Gates&) const = default;
};

struct PwmConfig {
  Clocks period = 0;             // clocks; 0 keeps the high sides off; taken at the period's start
  Clocks minimum = 0;            // clocks; shorter on or off times become 0 % or 100 %
  bool centred = false;          // pulses centred in the period instead of at its start
  bool complementary = false;    // the chopped leg's low side conducts in the off-time
  UInt<8> dead_time = 0;         // clocks; the floor fixed at synthesis wins
  UInt<8> tick_periods = 1;      // PWM periods per tick; 0 counts as 1
};

struct LimitConfig {
  UInt<8> blanking = 0;          // clocks after switch-on in which the comparator is not believed
  UInt<12> off_time = 0;         // clocks; 0 disables the current limit
};

struct Command {
  bool configured = false;       // the words are valid; until then all six gates are off
  bool run = false;
  bool reverse = false;
  bool brake_to_stop = false;    // else coast
  bool clear_fault = false;      // a rising edge re-arms, once `run` is low and the cause is gone
};

}  // namespace steplock
