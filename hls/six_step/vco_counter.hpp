// VCO counter: the digital voltage-controlled oscillator of the PLL.
//
//     phase <- phase + frequency   (mod 1 turn)      pulse: the turn is complete
//
// Phases are fractions of a turn, so the adder's own overflow is both the wrap and the pulse.  One
// turn of the VCO is one commutation step when N = 6.
//
//     frequency    f_clk * frequency / 2^32     resolution   f_clk / 2^32 (0.011 Hz at 48 MHz)
//     latency      1 clock: phase and pulse are registers
//     registers    33 bits                      multipliers  none
//
// Doc: docs/blocks/vco_counter.md   Test: tests/hls/vco_counter_test.cpp

#pragma once

#include "hls/numeric/bits.hpp"
#include "hls/six_step/words.hpp"

namespace steplock {

class VcoCounter {
 public:
  struct In {
    bool enable = false;      // false holds the phase
    bool load = false;        // takes `phase` instead of adding; wins over enable
    Phase phase = 0;          // u0.16, VCO turns
    Frequency frequency = 0;  // u0.32, VCO turns per clock
  };

  struct Out {
    Phase phase = 0;     // u0.16, VCO turns
    bool pulse = false;  // one clock, the first of a new turn
  };

  Out tick(const In& in) {
    const Out out{.phase = phase_.slice<31, 16>(), .pulse = pulse_};
    const auto sum = phase_ + UInt<32>(in.frequency);
    pulse_ = !in.load && in.enable && sum.bit(32);
    if (in.load) {
      phase_ = UInt<32>(in.phase) << 16;
    } else if (in.enable) {
      phase_ = wrap<UInt<32>>(sum);
    }
    return out;
  }

 private:
  UInt<32> phase_ = 0;  // u0.32, VCO turns
  bool pulse_ = false;  // the last addition passed a whole turn
};

}  // namespace steplock
