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

  // Quiet clocks (docs/theory.md): until this block does more than count, and that many at once.
  std::uint64_t quiet(const In& in) const {
    if (!in.enable || in.frequency == 0) return ~std::uint64_t{0};
    return UInt<32>(~phase_).raw() / std::uint64_t{in.frequency.raw()};
  }
  void skip(const In& in, std::uint64_t clocks) {
    if (in.enable) phase_ = UInt<32>::of(phase_.raw() + clocks * in.frequency.raw());
  }
  // The phase that the last of `clocks` skipped ones showed.
  Phase shown(const In& in, std::uint64_t clocks) const {
    const std::uint64_t moved = in.enable ? (clocks - 1) * in.frequency.raw() : 0;
    return UInt<32>::of(phase_.raw() + moved).slice<31, 16>();
  }
  bool operator==(const VcoCounter&) const = default;

 private:
  UInt<32> phase_ = 0;  // u0.32, VCO turns
  bool pulse_ = false;  // the last addition passed a whole turn
};

}  // namespace steplock
