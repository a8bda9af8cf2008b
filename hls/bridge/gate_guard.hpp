// Gate guard: alone drives the six gates; what it promises holds for every input sequence.
//
//     no shoot-through   the two gates of a leg are never on together, and after one turned off the
//                        other stays off for max(dead_time, Floor) clocks
//     off on fault       from the first clock after `fault` is up or `enable` is down all six gates
//                        are off, and no gate turns on before a full dead time has passed again
//     minimum on-time    a gate that turned on stays on for `minimum` clocks at least, but for the line
//                        above; a request shorter than the dead time never reaches its gate
//     both requested     is none requested
//
// One gate is on or none: a leg is one register for "on", one for "which", and one counter, so both on
// together cannot be said.
//
//     latency      request to gate: dead time + 1 clocks on, 1 clock off; fault to off: 1 clock
//     registers    3 x 16 bits     multipliers  none
//
// Floor is fixed at synthesis, in clocks: no register undercuts it.
//
// Doc: docs/blocks/gate_guard.md   Test: tests/hls/gate_guard_test.cpp
// Proof: tests/proofs/gate_guard.sv

#pragma once

#include "hls/numeric/bits.hpp"
#include "hls/six_step/commutation.hpp"

namespace steplock {

// One leg of the bridge.
template <int Floor>
class GuardedLeg {
 public:
  struct In {
    bool high = false;        // request for the high side
    bool low = false;         // request for the low side
    bool off = true;          // fault or not enabled
    UInt<8> dead_time = 0;    // clocks
    UInt<8> minimum = 0;      // clocks
  };

  struct Out {
    bool high = false;  // gate of the high side
    bool low = false;   // gate of the low side
  };

  Out tick(const In& in) {
    const Out out{.high = on_ && high_, .low = on_ && !high_};
    const bool wanted = in.high != in.low;
    const bool kept = wanted && in.high == high_;
    const UInt<8> dead = in.dead_time < Floor ? UInt<8>(Floor) : in.dead_time;
    if (in.off) {
      on_ = false;
      timer_ = dead;
    } else if (on_) {
      if (timer_ != 0) {
        timer_ = wrap<UInt<8>>(timer_ - 1);
      } else if (!kept) {
        on_ = false;
        timer_ = dead;
      }
    } else if (!kept) {
      // Waits from the beginning for each new wish.
      high_ = in.high;
      timer_ = dead;
    } else if (timer_ != 0) {
      timer_ = wrap<UInt<8>>(timer_ - 1);
    } else {
      on_ = true;
      timer_ = in.minimum == 0 ? UInt<8>(0) : wrap<UInt<8>>(in.minimum - 1);
    }
    return out;
  }

 private:
  bool on_ = false;          // one gate of the leg is on
  bool high_ = false;        // which, or which is waited for
  UInt<8> timer_ = Floor;    // on: clocks of minimum on-time; off: of dead time
};

template <int Floor = 12>
class GateGuard {
 public:
  struct In {
    Gates request;          // from commutation
    bool enable = false;    // false: all six off
    bool fault = false;     // true: all six off
    UInt<8> dead_time = 0;  // clocks; Floor if that is more
    UInt<8> minimum = 0;    // clocks of on-time at least
  };

  using Out = Gates;

  Out tick(const In& in) {
    const bool off = in.fault || !in.enable;
    const auto u = u_.tick({.high = in.request.uh,
                            .low = in.request.ul,
                            .off = off,
                            .dead_time = in.dead_time,
                            .minimum = in.minimum});
    const auto v = v_.tick({.high = in.request.vh,
                            .low = in.request.vl,
                            .off = off,
                            .dead_time = in.dead_time,
                            .minimum = in.minimum});
    const auto w = w_.tick({.high = in.request.wh,
                            .low = in.request.wl,
                            .off = off,
                            .dead_time = in.dead_time,
                            .minimum = in.minimum});
    return {.uh = u.high, .ul = u.low, .vh = v.high, .vl = v.low, .wh = w.high, .wl = w.low};
  }

 private:
  GuardedLeg<Floor> u_;
  GuardedLeg<Floor> v_;
  GuardedLeg<Floor> w_;
};

}  // namespace steplock
