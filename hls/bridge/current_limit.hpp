// Current limit: fixed off-time, on the comparator of the shunt.
//
// The pulse begins with the PWM.  `blanking` clocks later the comparator is believed; when it says
// that the current is above the limit the pulse ends, and stays off for `off_time` clocks whatever the
// PWM does.  Then the PWM rules again, and each new pulse is blanked anew (Amano 2003, Fig. 9).
//
//     latency      none from PWM to pulse; 1 clock from comparator to pulse
//     registers    27 bits     multipliers  none
//
// Doc: docs/blocks/current_limit.md   Test: tests/hls/current_limit_test.cpp

#pragma once

#include "hls/numeric/bits.hpp"
#include "hls/six_step/words.hpp"

namespace steplock {

class CurrentLimit {
 public:
  struct In {
    bool on = false;          // the PWM's pulse
    bool comparator = false;  // synchronised: current above the limit
    LimitWords words;
  };

  struct Out {
    bool on = false;     // the pulse that is left
    bool hit = false;    // one clock: a pulse was cut
    UInt<4> stuck = 0;   // cuts in a row in whose off-time the comparator was never released
  };

  Out tick(const In& in) {
    const bool cut = off_ != 0;
    const bool on = in.on && !cut;
    const bool hit = on && blank_ == 0 && was_on_ && in.comparator && in.words.off_time != 0;

    if (hit) {
      off_ = in.words.off_time;
      if (released_) {
        stuck_ = 0;
      } else {
        stuck_ = saturate<UInt<4>>(stuck_ + 1);
      }
      released_ = false;
    } else if (cut) {
      off_ = wrap<UInt<12>>(off_ - 1);
      if (!in.comparator) released_ = true;
    }
    // A pulse that its blanking outlives without a hit is the proof that the current obeys.
    if (on && was_on_ && blank_ == 0 && !in.comparator) stuck_ = 0;

    if (!on) {
      blank_ = in.words.blanking;
    } else if (blank_ != 0) {
      blank_ = wrap<UInt<8>>(blank_ - 1);
    }
    was_on_ = on;
    return {.on = on, .hit = hit, .stuck = stuck_};
  }

 private:
  UInt<12> off_ = 0;     // clocks of off-time still to come
  UInt<8> blank_ = 0;    // clocks of blanking still to come
  bool was_on_ = false;  // the pulse was on in the last clock
  bool released_ = true; // the comparator fell in this off-time
  UInt<4> stuck_ = 0;
};

}  // namespace steplock
