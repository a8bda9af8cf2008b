// Sine and cosine of an angle, both at once.
//
//     coarse = angle to 1/1024 of a turn     a quarter wave of 256 entries gives sin, cos
//     fine   = the rest, in radians          sin + fine cos, cos - fine sin
//
// The first-order step leaves fine^2 / 2 < 4.8e-6 of an error, less than the last place of s0.15;
// with both roundings a result is within 2 last places.
//
//     multipliers  3 products (one by a constant), one table of 256 x 15 bits read twice
//
// Doc: docs/blocks/current_control.md   Test: tests/hls/current_control_test.cpp

#pragma once

#include <array>

#include "hls/numeric/bits.hpp"

namespace steplock {

struct SineCosine {
  Int<16> sine = 0;    // s0.15
  Int<16> cosine = 0;  // s0.15
};

// sin of (i + 1/2) / 1024 of a turn in u0.15, by its series.
constexpr std::array<UInt<15>, 256> quarter_wave() {
  std::array<UInt<15>, 256> table = {};
  for (int i = 0; i < 256; ++i) {
    const double x = (i + 0.5) * 6.283185307179586 / 1024;
    double term = x, sum = x;
    for (int n = 2; n < 20; n += 2) sum += term *= -x * x / (n * (n + 1));
    table[static_cast<std::size_t>(i)] = static_cast<int>(sum * 32767 + 0.5);
  }
  return table;
}
inline constexpr auto kQuarterWave = quarter_wave();

// s0.15, at the middle of the 1024 steps.
inline Int<16> coarse_sine(UInt<10> step) {
  const auto place = step.template slice<7, 0>();
  const bool falls = step.bit(8), negative = step.bit(9);
  const Int<16> height = kQuarterWave[static_cast<std::size_t>((falls ? ~place : place).raw())];
  return negative ? wrap<Int<16>>(-height) : height;
}

inline SineCosine sine_cosine(UInt<16> angle) {
  const UInt<10> step = angle.template slice<15, 6>();
  const Int<16> sine = coarse_sine(step);
  const Int<16> cosine = coarse_sine(wrap<UInt<10>>(step + 256));
  // From the middle of the step, in 2^-17 turns; 402 of them are 2 pi 2^-17 in 2^-23 rad.
  const Int<7> from_middle = wrap<Int<7>>(Int<8>(angle.template slice<5, 0>()) * 2 - 64);
  const auto fine = wrap<Int<16>>(from_middle * Int<11>(402));  // 2^-23 rad
  return {saturate<Int<16>>(sine + wrap<Int<16>>((fine * cosine + (1 << 22)) >> 23)),
          saturate<Int<16>>(cosine - wrap<Int<16>>((fine * sine + (1 << 22)) >> 23))};
}

}  // namespace steplock
