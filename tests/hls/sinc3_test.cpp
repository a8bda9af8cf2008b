// The filter is the convolution of three boxcars, exactly; and what it leaves of a modulator's noise is what
// theory says.

#include "hls/sinusoidal/sinc3.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <functional>
#include <random>
#include <vector>

#include "tests/hls/modulator.hpp"

namespace steplock {
namespace {

// One window; bits come with pauses of 0 to 3 clocks.
template <int Log2>
std::int64_t filtered(Sinc3<Log2>& dut, const std::function<bool(int)>& bit, std::mt19937* pauses = nullptr) {
  dut.tick({.start = true, .valid = true, .bit = true});  // not of the window
  for (int k = 0; k < 3 << Log2; ++k) {
    for (int i = pauses ? int((*pauses)() % 4) : 0; i > 0; --i) dut.tick({.bit = !bit(k)});
    EXPECT_FALSE(dut.tick({.valid = true, .bit = bit(k)}).done);
  }
  const auto out = dut.tick({.valid = true, .bit = true});
  EXPECT_TRUE(out.done && !out.busy);
  return std::int64_t(out.value.raw());
}

std::vector<std::int64_t> convolved(const std::vector<std::int64_t>& a, int boxcar) {
  std::vector<std::int64_t> sum(a.size() + std::size_t(boxcar) - 1);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (int k = 0; k < boxcar; ++k) sum[i + std::size_t(k)] += a[i];
  }
  return sum;
}

template <int Log2>
std::int64_t by_weights(const std::function<bool(int)>& bit) {
  constexpr int m = 1 << Log2;
  static const auto weights = convolved(convolved(convolved({1}, m), m), m);
  std::int64_t sum = 0;
  for (int k = 0; k < int(weights.size()); ++k) sum += bit(k) ? weights[std::size_t(k)] : 0;
  const std::int64_t half = std::int64_t{1} << (3 * Log2 - 1);
  return std::min(sum - half, half - 1);
}

TEST(Sinc3, EveryStreamOfTheSmallestWindowIsWeighedByThreeBoxcars) {
  Sinc3<2> dut;
  for (int stream = 0; stream < 1 << 12; ++stream) {
    const auto bit = [&](int k) { return (stream >> k & 1) != 0; };
    ASSERT_EQ(filtered<2>(dut, bit), by_weights<2>(bit)) << stream;
  }
}

// Sums are linear: what holds for every single bit and for random streams holds for all.
template <int Log2>
void weighs() {
  Sinc3<Log2> dut;
  std::mt19937 any(1);
  for (int one = 0; one < 3 << Log2; ++one) {
    const auto bit = [&](int k) { return k == one; };
    ASSERT_EQ(filtered<Log2>(dut, bit), by_weights<Log2>(bit)) << one;
  }
  for (int n = 0; n < 100; ++n) {
    std::vector<bool> bits(3u << Log2);
    for (auto&& b : bits) b = any() % 100 < unsigned(n);
    const auto bit = [&](int k) { return bool(bits[std::size_t(k)]); };
    ASSERT_EQ(filtered<Log2>(dut, bit, &any), by_weights<Log2>(bit));
  }
}
TEST(Sinc3, LongerWindowsAreWeighedByThreeBoxcars) {
  weighs<4>();
  weighs<6>();
  weighs<8>();
}

TEST(Sinc3, HalfOfTheBitsIsZeroAndTheEndsAreFullScale) {
  Sinc3<> dut;
  EXPECT_EQ(filtered<6>(dut, [](int k) { return k % 2 == 0; }), 0);
  EXPECT_EQ(filtered<6>(dut, [](int) { return false; }), -(1 << 17));
  EXPECT_EQ(filtered<6>(dut, [](int) { return true; }), (1 << 17) - 1) << "limited, not wrapped";
}

TEST(Sinc3, AStartWithinAWindowBeginsItAnew) {
  Sinc3<4> dut;
  dut.tick({.start = true});
  for (int k = 0; k < 30; ++k) dut.tick({.valid = true, .bit = true});
  const auto bit = [](int k) { return k % 3 == 0; };
  EXPECT_EQ(filtered<4>(dut, bit), by_weights<4>(bit));
}

// A quantiser's noise, shaped by (1 - 1/z)^2, behind the filter: 6 / M^5 of it.
double theory_db(int log2, double amplitude, double noise) {
  return 10 * std::log10(amplitude * amplitude / 2 / (6 * noise) * std::pow(2, 5 * log2));
}

struct Seen {
  double snr_db, theory_db;
};

// A sine of half of full scale, of 0.011 turns per window: no other tone falls on it.
template <int Log2>
Seen sine(int order) {
  Sinc3<Log2> dut;
  Modulator modulator(order);
  constexpr double turns = 0.011;
  constexpr int bits = 3 << Log2;
  std::vector<double> samples;
  for (int n = 0; n < 2000; ++n) {
    samples.push_back(double(filtered<Log2>(dut, [&, stream = std::vector<bool>()](int k) mutable {
      while (int(stream.size()) <= k) {
        const double window = n + double(stream.size()) / bits;
        stream.push_back(modulator.bit(0.5 * std::sin(2 * M_PI * turns * window)));
      }
      return bool(stream[std::size_t(k)]);
    })));
  }
  return {snr_db(samples, turns), theory_db(Log2, 0.5, modulator.noise())};
}

// 1.5 dB: the quantiser's noise, of one bit, is not quite white.
template <int Log2>
void sees_as_well_as_theory() {
  const Seen seen = sine<Log2>(2);
  EXPECT_NEAR(seen.snr_db, seen.theory_db, 1.5) << Log2;
}
TEST(Sinc3, ASineIsSeenThroughAModulatorOfTheSecondOrderAsWellAsTheorySays) {
  sees_as_well_as_theory<4>();
  sees_as_well_as_theory<5>();
  sees_as_well_as_theory<6>();
  sees_as_well_as_theory<7>();
}

TEST(Sinc3, AModulatorOfTheFirstOrderIsNoticed) {
  const Seen seen = sine<6>(1);
  EXPECT_LT(seen.snr_db, seen.theory_db - 10);
}

}  // namespace
}  // namespace steplock
