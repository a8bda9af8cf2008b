// Gate guard: alone drives the six gates; what it promises holds for every input sequence.
//
//     no shoot-through   the two gates of a leg are never on together, and after one turned off both
//                        stay off for max(dead_time, Floor) clocks
//     off on fault       in the clock after `fault` is up or `enable` is down all six gates are off,
//                        and a full dead time passes before any of them turns on again
//     minimum on-time    a gate that turned on stays on for `minimum` clocks, but for the line above
//     short requests     a request of the dead time or less never reaches its gate
//     both requested     is none requested
//
// Floor is fixed at synthesis, in clocks: no register undercuts it.  Where `dead_time` changes while a
// leg is off, the smallest value it had since then counts, and the floor in any case.
//
//     latency      request to gate: dead time + 1 clocks on, 1 clock off; fault to off: 1 clock
//     registers    36 bits; every gate is one of them     multipliers  none
//
// Doc: docs/blocks/gate_guard.md   Test: tests/hls/gate_guard_test.cpp
// Proof: tests/proofs/gate_guard.sv

#pragma once

#include "hls/bridge/bridge.hpp"
#include "hls/bridge/guarded_leg.hpp"
#include "hls/numeric/bits.hpp"

namespace steplock {

template <int Floor = 12>
class GateGuard {
  static_assert(Floor >= 1 && Floor <= 255);

 public:
  struct In {
    Gates request = {};     // from commutation
    bool enable = false;    // false: all six off
    bool fault = false;     // true: all six off
    UInt<8> dead_time = 0;  // clocks; Floor if that is more
    UInt<8> minimum = 0;    // clocks of on-time at least
  };

  using Out = Gates;

  Out tick(const In& in) {
    const bool off = in.fault || !in.enable;
    const UInt<8> dead = in.dead_time < Floor ? UInt<8>(Floor) : in.dead_time;
    const auto u = u_.tick({.high = in.request.uh,
                            .low = in.request.ul,
                            .off = off,
                            .dead_time = dead,
                            .minimum = in.minimum});
    const auto v = v_.tick({.high = in.request.vh,
                            .low = in.request.vl,
                            .off = off,
                            .dead_time = dead,
                            .minimum = in.minimum});
    const auto w = w_.tick({.high = in.request.wh,
                            .low = in.request.wl,
                            .off = off,
                            .dead_time = dead,
                            .minimum = in.minimum});
    return {.uh = u.high, .ul = u.low, .vh = v.high, .vl = v.low, .wh = w.high, .wl = w.low};
  }

  // Quiet clocks (docs/theory.md): until this block does more than count, and that many at once.
  std::uint64_t quiet() const { return least(u_.quiet(), least(v_.quiet(), w_.quiet())); }
  void skip(std::uint64_t clocks) {
    u_.skip(clocks);
    v_.skip(clocks);
    w_.skip(clocks);
  }
  bool operator==(const GateGuard&) const = default;

 private:
  static std::uint64_t least(std::uint64_t a, std::uint64_t b) { return a < b ? a : b; }

  GuardedLeg u_;
  GuardedLeg v_;
  GuardedLeg w_;
};

}  // namespace steplock
