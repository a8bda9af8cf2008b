// Current limit: fixed off-time, on the comparator of the shunt (Amano 2003, Fig. 9).
//
// Each switch-on begins with `blanking` clocks in which the comparator is not believed.  From then on a
// high comparator cuts the pulse: off for `off_time` clocks whatever the PWM does, then the PWM rules
// again, and the next switch-on is blanked anew.  With all gates off in a cut (`fast`) the bus takes the current down as
// steeply as it drove it up, so a quarter of the off-time is enough, and more of the limit's current is left.
//
// A current that the limit has in hand falls below it in the off-time.  Cuts in a row in which it
// never did are counted: a shorted winding, or a shunt that lies.
//
//     latency      none from PWM to pulse; 1 clock from comparator to pulse
//     registers    21 bits: one counter is blanking or off-time     multipliers  none
//
// Doc: docs/blocks/current_limit.md   Test: tests/hls/current_limit_test.cpp

#pragma once

#include "hls/bridge/bridge.hpp"
#include "hls/numeric/bits.hpp"

namespace steplock {

class CurrentLimit {
 public:
  struct In {
    bool on = false;          // the PWM's pulse
    bool comparator = false;  // synchronised: current above the limit
    bool fast = false;        // while cut all gates are off
    LimitConfig config = {};
  };

  struct Out {
    bool on = false;    // what is left of the pulse
    bool cut = false;   // off-time
    bool hit = false;   // one clock, the first of an off-time
    UInt<4> stuck = 0;  // cuts in a row without release, stops at 15
  };

  Out tick(const In& in) {
    const Out out{.on = in.on && !cut_, .cut = cut_, .hit = hit_, .stuck = stuck_};

    const bool heard = in.on && none_;
    const bool hit = heard && in.comparator && in.config.off_time != 0;
    const bool cut_ends = cut_ && due_;
    const UInt<12> off_time = in.fast ? wrap<UInt<12>>(in.config.off_time >> 2) : in.config.off_time;

    if (cut_ends) {
      stuck_ = released_ || !in.comparator ? UInt<4>(0) : saturate<UInt<4>>(stuck_ + 1);
    } else if (heard && !in.comparator) {
      stuck_ = 0;
    }
    released_ = cut_ && (released_ || !in.comparator);

    // Whether none is left is told by the counter's own steps: asking all its bits would take too long.
    if (hit) {
      left_ = off_time;
      due_ = off_time < 2;
      none_ = false;
    } else if (cut_ends || !(in.on || cut_)) {
      left_ = in.config.blanking;
      due_ = in.config.blanking < 2;
      none_ = in.config.blanking == 0;
    } else if (!heard) {
      due_ = due_ || left_ == 2;
      none_ = left_ == 1;
      left_ = wrap<UInt<12>>(left_ - 1);
    }
    cut_ = hit || (cut_ && !cut_ends);
    hit_ = hit;
    return out;
  }

  // Quiet clocks (docs/theory.md): until this block does more than count, and that many at once.
  std::uint64_t quiet(bool on) const {
    return !counts(on) ? ~std::uint64_t{0} : left_ < 2 ? 0 : left_.raw() - 1;
  }
  void skip(bool on, std::uint64_t clocks) {
    if (!counts(on)) return;
    left_ = UInt<12>::of(left_.raw() - clocks);
    due_ = left_ < 2;
    none_ = left_ == 0;
  }
  bool operator==(const CurrentLimit&) const = default;

 private:
  bool counts(bool on) const { return cut_ || (on && left_ != 0); }

  UInt<12> left_ = 0;      // clocks of off-time (cut) or of blanking
  bool due_ = true;        // of them 1 or none
  bool none_ = true;       // none; in an off-time there is always one
  bool cut_ = false;       // off-time
  bool released_ = false;  // the comparator fell in this off-time
  bool hit_ = false;       // the first clock of an off-time
  UInt<4> stuck_ = 0;      // cuts in a row without release
};

}  // namespace steplock
