// VCO counter: the digital voltage-controlled oscillator of the PLL.
//
//     phase <- phase + frequency   (mod 1 turn)      pulse: the turn is complete
//
// Phases are fractions of a turn, so the adder's own overflow is both the wrap and the pulse.  One
// turn of the VCO is one commutation step when N = 6.
//
//     frequency    f_clk * frequency / 2^32     resolution   f_clk / 2^32 (0.011 Hz at 48 MHz)
//     latency      1 clock; between registers and outputs lies a carry of one bit
//     registers    35 bits                      multipliers  none
//
// Doc: docs/blocks/vco_counter.md   Test: tests/hls/vco_counter_test.cpp

#pragma once

#include "hls/numeric/bits.hpp"
#include "hls/six_step/config.hpp"

namespace steplock {

class VcoCounter {
 public:
  struct In {
    bool enable = false;      // false holds the phase
    bool load = false;        // begins a turn instead of adding; wins over enable
    bool half = false;        // with `load`: in its middle
    Frequency frequency = 0;  // u0.32, VCO turns per clock
  };

  struct Out {
    Phase phase = 0;     // u0.16, VCO turns
    bool pulse = false;  // one clock, the first of a new turn
  };

  Out tick(const In& in) {
    // The upper bits follow in the clock after: the carry waits in a flip-flop at the end of its chain.
    const bool carries = low_.bit(26) && counted_;
    const Out out{.phase = phase().slice<31, 16>(), .pulse = carries && full_};
    full_ = !in.load && (carries ? high_ == UInt<6>(62) : full_);
    if (in.load) {
      high_ = in.half ? UInt<6>(32) : UInt<6>(0);
    } else if (carries) {
      high_ = wrap<UInt<6>>(high_ + 1);
    }
    if (in.load) {
      low_ = 0;
    } else if (in.enable) {
      low_ = wrap<UInt<27>>(low_.slice<25, 0>() + in.frequency);
    }
    counted_ = in.enable;
    return out;
  }

  // Quiet clocks (docs/theory.md): until this block does more than count, and that many at once.
  std::uint64_t quiet(const In& in) const {
    if (!in.enable || in.frequency == 0) return ~std::uint64_t{0};
    return UInt<32>(~phase()).raw() / std::uint64_t{in.frequency.raw()};
  }
  void skip(const In& in, std::uint64_t clocks) {
    if (!in.enable) return;
    const auto moved = UInt<32>::of(phase().raw() + clocks * in.frequency.raw());
    const auto low = moved.slice<25, 0>();
    const UInt<1> carry(low < in.frequency);
    low_ = UInt<27>(carry) << 26 | UInt<27>(low);
    high_ = wrap<UInt<6>>(moved.slice<31, 26>() - carry);
    full_ = high_ == UInt<6>::max();
  }
  // The phase that the last of `clocks` skipped ones showed.
  Phase shown(const In& in, std::uint64_t clocks) const {
    const std::uint64_t moved = in.enable ? (clocks - 1) * in.frequency.raw() : 0;
    return UInt<32>::of(phase().raw() + moved).slice<31, 16>();
  }
  bool operator==(const VcoCounter&) const = default;

 private:
  UInt<32> phase() const {
    const UInt<1> carry(low_.bit(26) && counted_);
    return UInt<32>(wrap<UInt<6>>(high_ + carry)) << 26 | UInt<32>(low_.slice<25, 0>());
  }

  // u0.32, VCO turns, in two parts: above the frequency's bits there is nothing to add but a carry.
  UInt<27> low_ = 0;      // its lower 26 bits, and their carry
  bool counted_ = false;  // the carry is new, and has still to be added to
  UInt<6> high_ = 0;      // the others
  bool full_ = false;     // which are all ones: the carry ends the turn
};

}  // namespace steplock
