// Test blocks: a phase accumulator, the smallest block with everything a block has.

#pragma once

#include "hls/numeric/bits.hpp"

namespace steplock::test {

template <int W = 24, int Shift = 0>
class PhaseAccumulator {
 public:
  struct In {
    bool enable = false;  // false holds the phase
    bool load = false;
    UInt<W> angle = 0;  // u0.W, turns
    Int<W> step = 0;    // s0.W, turns per clock
    template <class F>
    void each(F f) { f(enable), f(load), f(angle), f(step); }
  };
  struct Out {
    UInt<W> phase = 0;
    bool wraps = false;
    template <class F>
    void each(F f) { f(phase), f(wraps); }
  };

  Out tick(const In& in) {
    const auto sum = phase_ + (in.step >> Shift);
    const bool wraps = in.enable && !in.load && (sum < 0 || sum > UInt<W>::max());
    if (in.load) {
      phase_ = in.angle;
    } else if (in.enable) {
      phase_ = wrap<UInt<W>>(sum);
    }
    return {phase_, wraps};
  }

 private:
  UInt<W> phase_ = 5;  // u0.W, turns
};

}  // namespace steplock::test
