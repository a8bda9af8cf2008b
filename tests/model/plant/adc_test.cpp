#include "model/plant/adc.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

#include "model/plant/sensors.hpp"

namespace steplock::plant {
namespace {

State at(double iu, double bus) {
  State s;
  s.current = {iu, -iu / 2, -iu / 2};
  s.bus_voltage = bus;
  return s;
}

TEST(Adc, TheCodeIsTheNearestStepAndClipsAtTheRange) {
  const Adc adc({.bits = 12, .current_range = 45.056, .voltage_range = 561.152});
  EXPECT_DOUBLE_EQ(adc.current_lsb(), 0.022);
  EXPECT_DOUBLE_EQ(adc.voltage_lsb(), 0.137);
  for (double i = -50; i < 50; i += 0.0137) {
    const int code = adc.sample(at(i, 280), 0).current[0];
    if (std::abs(i) < 45) {
      EXPECT_LE(std::abs(code * 0.022 - i), 0.0110001);  // half a step
    } else if (std::abs(i) > 45.1) {
      EXPECT_EQ(code, i > 0 ? 2047 : -2048);
    }
  }
  EXPECT_EQ(adc.sample(at(0, 700), 0).bus, 4095);
  EXPECT_EQ(adc.sample(at(0, -5), 0).bus, 0);
}

TEST(Adc, OffsetsAreThePhasesOwn) {
  const Adc adc({.current_range = 10, .current_offset = {0.1, 0, -0.2}, .voltage_offset = 1});
  const AdcCodes codes = adc.sample(at(0, 30), 7);
  EXPECT_NEAR(codes.current[0] * adc.current_lsb(), 0.1, adc.current_lsb() / 2);
  EXPECT_EQ(codes.current[1], 0);
  EXPECT_NEAR(codes.current[2] * adc.current_lsb(), -0.2, adc.current_lsb() / 2);
  EXPECT_NEAR(codes.bus * adc.voltage_lsb(), 31, adc.voltage_lsb() / 2);
}

TEST(Adc, NoiseHasItsDeviationAndIsAFunctionOfSeedAndNumber) {
  const AdcParameters p{.bits = 16, .current_range = 10, .current_noise = 0.05};
  const Adc adc(p), same(p);
  double sum = 0, squares = 0;
  constexpr int kSamples = 4000;
  int alike = 0;
  for (int n = 0; n < kSamples; ++n) {
    const AdcCodes codes = adc.sample(at(1, 30), n);
    EXPECT_EQ(codes, same.sample(at(1, 30), n));
    alike += codes.current[1] == codes.current[2];
    const double x = codes.current[0] * adc.current_lsb() - 1;
    sum += x, squares += x * x;
  }
  EXPECT_LT(alike, kSamples / 20);
  // Four standard errors of mean and deviation.
  EXPECT_NEAR(sum / kSamples, 0, 4 * 0.05 / std::sqrt(kSamples));
  EXPECT_NEAR(std::sqrt(squares / kSamples), 0.05, 4 * 0.05 / std::sqrt(2.0 * kSamples));
}

// Neither a deviation of one ampere nor a seed of all ones is special; the comparators' noise of a seed is another.
TEST(Adc, NoiseIsNotThatOfTheComparators) {
  const AdcParameters p{.bits = 16, .current_range = 10, .current_noise = 1, .seed = ~std::uint64_t{0}};
  const Adc adc(p);
  int noisy = 0, alike = 0;
  constexpr int kSamples = 100;
  for (int n = 0; n < kSamples; ++n) {
    const double noise = adc.sample(at(0, 30), n).current[0] * adc.current_lsb();
    noisy += noise != 0;
    alike += std::abs(noise - Sensors::gaussian(p.seed, 0, n)) < adc.current_lsb();
  }
  EXPECT_GT(noisy, kSamples / 2);
  EXPECT_LT(alike, kSamples / 2);
}

}  // namespace
}  // namespace steplock::plant
