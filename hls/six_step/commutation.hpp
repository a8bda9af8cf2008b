// Commutation: the gates of a step and PWM to six gate requests.
//
//     step      0     1     2     3     4     5
//     chopped   U+    U+    V+    V+    W+    W+      high side follows the PWM
//     on        V-    W-    W-    U-    U-    V-      low side on throughout
//     off       W     V     U     W     V     U       floats: its back-EMF is watched
//
// Reverse rotation needs no other table: the steps count down.  The alignment pattern has U and V high
// and W low; complementary PWM closes the low side of a chopped leg in the off-time.
//
//     latency      none: gates and gates only     registers  none     multipliers  none
//
// Doc: docs/blocks/commutation.md   Test: tests/hls/commutation_test.cpp

#pragma once

#include "hls/bridge/bridge.hpp"
#include "hls/numeric/bits.hpp"
#include "hls/numeric/one_hot.hpp"

namespace steplock {

enum class Pattern : std::uint8_t { kOff, kDrive, kPreAlign, kAlign, kBrake };

class Commutation {
 public:
  struct In {
    OneHot<Pattern, 5> pattern = Pattern::kOff;
    Gates legs;                       // the gates of the step; kPreAlign is step 1, whatever they say
    bool chop = false;                // PWM and current limit: on
    bool complementary = false;       // low side of a chopped leg on while chop is off
  };

  using Out = Gates;

  // The two gates that conduct in a step, 0 to 5; 6 and 7 are off.  Known a clock before it, they wait in a register.
  static Gates legs(UInt<3> step) {
    return {.uh = step == 0 || step == 1,
            .ul = step == 3 || step == 4,
            .vh = step == 2 || step == 3,
            .vl = step == 0 || step == 5,
            .wh = step == 4 || step == 5,
            .wl = step == 1 || step == 2};
  }

  Out tick(const In& in) {
    const bool drive = in.pattern.holds(Pattern::kDrive);
    const bool align = in.pattern.holds(Pattern::kAlign);
    const bool pre_align = in.pattern.holds(Pattern::kPreAlign);
    const bool brake = in.pattern.holds(Pattern::kBrake) && in.chop;
    const bool u_high = align || pre_align || (drive && in.legs.uh);
    const bool v_high = align || (drive && in.legs.vh);
    const bool w_high = drive && in.legs.wh;
    const bool freewheel = in.complementary && !in.chop;
    return {.uh = u_high && in.chop,
            .ul = (drive && in.legs.ul) || brake || (u_high && freewheel),
            .vh = v_high && in.chop,
            .vl = (drive && in.legs.vl) || brake || (v_high && freewheel),
            .wh = w_high && in.chop,
            .wl = align || pre_align || (drive && in.legs.wl) || brake || (w_high && freewheel)};
  }

  bool operator==(const Commutation&) const = default;
};

}  // namespace steplock
