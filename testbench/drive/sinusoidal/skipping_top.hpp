// The whole sinusoidal drive, for simulation: the clocks in which it does nothing but count, many at once.
//
//     docs/theory.md, "Quiet clocks", says why this is exact.  Between a sample worked through and the
//     next period the PWM counts, and a dead time; all else waits for a strobe.
//
// Test: tests/testbench/sinusoidal_skipping_test.cpp
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

#include "hls/sinusoidal/sinusoidal_top.hpp"

namespace steplock {

class SkippingSinusoidalTop : public SinusoidalTop {
 public:
  // From 1 to `most` ticks, as many as are quiet, and `out`, which was that of the last one, becomes that of
  // the last of them: the same as tick() so often.
  std::uint64_t advance(const In& in, Out& out, std::uint64_t most) {
    const std::uint64_t clocks = std::min(to_event(in), most);
    if (clocks < kWorthwhile || busy_ > 0) {
      busy_ -= busy_ > 0;
      out = tick(in);
      return 1;
    }
    // A tick.  If it changes counters alone, as skip() says, so does each one up to the next event.
    Copy counted(*this);
    counted.top().skip(1);
    const Out last = out;
    out = tick(in);
    if (!(out == last) || !counted.is(*this)) {
      busy_ = kBusy;
      return 1;
    }
    skip(clocks - 1);
    return clocks;
  }

 private:
  static constexpr std::uint64_t kWorthwhile = 6;  // clocks; below, looking costs more than ticking
  static constexpr int kBusy = 1;  // clocks until the next look: who is at work now, is a little longer

  // Byte by byte, so that no register can be forgotten.  What fills the gaps between registers may
  // differ where they do not: then it is ticked for nothing, and the test tells.
  class Copy {
   public:
    explicit Copy(const SkippingSinusoidalTop& of) {
      static_assert(std::is_trivially_copyable_v<SkippingSinusoidalTop> && sizeof of <= sizeof bytes_);
      std::memcpy(bytes_.data(), &of, sizeof of);
    }
    SkippingSinusoidalTop& top() { return *reinterpret_cast<SkippingSinusoidalTop*>(bytes_.data()); }
    bool is(const SkippingSinusoidalTop& other) const {
      return std::memcmp(bytes_.data(), &other, sizeof other) == 0;
    }

   private:
    alignas(SinusoidalTop) std::array<std::byte, sizeof(SinusoidalTop) + alignof(SinusoidalTop)> bytes_;
  };

  // Clocks until the first counter reaches its event; 0 where more than counters is at work.
  std::uint64_t to_event(const In& in) const {
    if (in.codes.valid) return 0;
    const auto pwm = std::min({pwm_u_.quiet(), pwm_v_.quiet(), pwm_w_.quiet()});
    return std::min({pwm, guard_.quiet(), control_.quiet()});
  }
  void skip(std::uint64_t clocks) {
    for (PwmGenerator* pwm : {&pwm_u_, &pwm_v_, &pwm_w_}) pwm->skip(clocks);
    guard_.skip(clocks);
    control_.skip(clocks);
  }

  int busy_ = 0;
};

}  // namespace steplock
