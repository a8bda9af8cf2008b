// Commutation: step and PWM to six gate requests.
//
//     step      0     1     2     3     4     5
//     chopped   U+    U+    V+    V+    W+    W+      high side follows the PWM
//     on        V-    W-    W-    U-    U-    V-      low side on throughout
//     off       W     V     U     W     V     U       floats: its back-EMF is watched
//
// Reverse rotation needs no other table: the steps count down.  The reset pattern has U and V high
// and W low; complementary PWM closes the low side of a chopped leg in the off-time.
//
//     latency      none: gates and gates only     registers  none     multipliers  none
//
// Doc: docs/blocks/commutation.md   Test: tests/hls/commutation_test.cpp

#pragma once

#include "hls/numeric/bits.hpp"

namespace steplock {

enum class Pattern : std::uint8_t { kOff, kDrive, kSettle, kReset, kBrake };

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

class Commutation {
 public:
  struct In {
    Pattern pattern = Pattern::kOff;  // kSettle is step 1, whatever `step` says
    UInt<3> step = 0;                 // 0 to 5; 6 and 7 are off
    bool chop = false;                // PWM and current limit: on
    bool complementary = false;       // low side of a chopped leg on while chop is off
  };

  using Out = Gates;

  Out tick(const In& in) {
    const bool reset = in.pattern == Pattern::kReset;
    const bool drive = in.pattern == Pattern::kDrive;
    const UInt<3> step = in.pattern == Pattern::kSettle ? UInt<3>(1) : in.step;
    const bool steps = drive || in.pattern == Pattern::kSettle;

    const bool brake = in.pattern == Pattern::kBrake && in.chop;
    const bool u_high = reset || (steps && (step == 0 || step == 1));
    const bool v_high = reset || (steps && (step == 2 || step == 3));
    const bool w_high = steps && (step == 4 || step == 5);
    const bool u_low = steps && (step == 3 || step == 4);
    const bool v_low = steps && (step == 0 || step == 5);
    const bool w_low = reset || (steps && (step == 1 || step == 2));
    const bool freewheel = in.complementary && !in.chop;
    return {.uh = u_high && in.chop,
            .ul = u_low || brake || (u_high && freewheel),
            .vh = v_high && in.chop,
            .vl = v_low || brake || (v_high && freewheel),
            .wh = w_high && in.chop,
            .wl = w_low || brake || (w_high && freewheel)};
  }

  bool operator==(const Commutation&) const = default;
};

}  // namespace steplock
