// Guarded leg: one leg of the bridge, two gates that are never on together.
//
//     turn on    after the same request for dead_time + 1 clocks, with both gates off
//     turn off   at once when the request goes, but not before `minimum` clocks; at once with `off`
//
// One counter serves the leg: while a gate is on it holds what is left of the minimum on-time, else
// what is left of the dead time.  It begins anew with every change of the request, so a request of
// dead_time clocks or less never reaches its gate.
//
//     latency      dead_time + 1 clocks from request to gate on, 1 clock to gate off
//     registers    12 bits; the gates are registers, free of glitches     multipliers  none
//
// Doc: docs/blocks/gate_guard.md   Test: tests/hls/gate_guard_test.cpp
// Proof: tests/proofs/gate_guard.sv

#pragma once

#include "hls/numeric/bits.hpp"

namespace steplock {

class GuardedLeg {
 public:
  struct In {
    bool high = false;      // request for the high side; both requested is none
    bool low = false;       // request for the low side
    bool off = true;        // both gates off at the next clock
    UInt<8> dead_time = 1;  // clocks, 1 at least; taken when a request comes, goes or changes
    UInt<8> minimum = 0;    // clocks of on-time at least; taken at turn-on
  };

  struct Out {
    bool high = false;  // gate of the high side
    bool low = false;   // gate of the low side
  };

  Out tick(const In& in) {
    const Out out{.high = gate_.bit(kHigh), .low = gate_.bit(kLow)};
    const bool high = in.high && !in.low;
    const bool low = in.low && !in.high;
    const bool on = gate_ != 0;
    const bool due = (timer_ >> 1) == 0;
    // The request comes late in the clock: all that does not wait for it is asked first.
    const Pair request = Pair(high) << kHigh | Pair(low) << kLow;
    const Pair same = in.off ? Pair(0) : on ? gate_ : was_;
    const bool wanted = (request & same) != 0;
    const bool keeps = on && !in.off && !due;  // its minimum on-time, whatever is requested
    const Pair held = !in.off && !due ? gate_ : Pair(0);
    const Pair ready = on || due ? same : Pair(0);

    if (!wanted && !keeps) {
      timer_ = in.dead_time;
    } else if (due) {
      timer_ = on ? UInt<8>(0) : in.minimum;
    } else {
      timer_ = wrap<UInt<8>>(timer_ - 1);
    }
    gate_ = held | (ready & request);
    was_ = in.off ? Pair(0) : request;
    return out;
  }

  // Quiet clocks (docs/theory.md): until this block does more than count, and that many at once.
  std::uint64_t quiet() const {
    if (gate_ != was_ && timer_ < 2) return 0;
    return !counts() ? ~std::uint64_t{0} : timer_.raw() - 1;
  }
  void skip(std::uint64_t clocks) {
    if (counts()) timer_ = UInt<8>::of(timer_.raw() - clocks);
  }
  bool operator==(const GuardedLeg&) const = default;

 private:
  using Pair = UInt<2>;  // both sides of the leg; never both bits
  static constexpr int kHigh = 0, kLow = 1;

  bool counts() const { return timer_ > 1 && (gate_ != 0 || was_ != 0); }  // Quiet clocks: of skip()

  Pair gate_ = 0;      // the gates
  Pair was_ = 0;       // the request of the last clock
  UInt<8> timer_ = 0;  // clocks of minimum on-time (on) or dead time (off); 0 and 1 are due
};

}  // namespace steplock
