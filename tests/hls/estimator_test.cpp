// Both estimators in one block: each is the block of its own, bit by bit, whichever is chosen.

#include "hls/sinusoidal/estimator.hpp"

#include <gtest/gtest.h>

#include <random>

#include "tests/hls/turning_motor.hpp"

namespace steplock {
namespace {

using namespace turning;

constexpr int kTheta = 3277, kE = 541, kSpeed = 5894, kEmf = 3275, kSi = 839;

TEST(Estimator, ItIsTheChosenModelInEverySample) {
  std::mt19937 any(1);
  for (const bool voltage : {false, true}) {
    int differ = 0;
    Turning motor(1, 0.01, 0.2, 192);
    Estimator both;
    CurrentModel current;
    VoltageModel of_voltage;
    for (int n = 0; n < 5000; ++n) {
      motor.step();
      auto in = motor.in<Estimator::In>();
      in.config = {.voltage = voltage, .average = true, .decay = kDecay, .gain = kGain,
                  .k_theta = kTheta, .k_e = kE, .k_speed = kSpeed, .k_emf = kEmf, .k_si = kSi};
      auto in_current = motor.in<CurrentModel::In>();
      in_current.config = {.decay = kDecay, .gain = kGain, .k_e = kE, .k_theta = kTheta,
                          .k_speed = kSpeed};
      auto in_voltage = motor.in<VoltageModel::In>();
      in_voltage.config = {.average = true, .decay = kDecay, .gain = kGain, .k_emf = kEmf,
                          .k_theta = kTheta, .k_si = kSi};
      const bool enable = std::uniform_int_distribution<>(0, 999)(any) != 0;
      in.enable = in_current.enable = in_voltage.enable = enable;
      const auto out = both.tick(in);
      const auto a = current.tick(in_current);
      const auto b = of_voltage.tick(in_voltage);
      ASSERT_EQ(out.angle, voltage ? b.angle : a.angle) << n;
      ASSERT_EQ(out.step, voltage ? b.step : a.step) << n;
      ASSERT_EQ(out.emf_step, voltage ? b.emf_step : a.emf_step) << n;
      ASSERT_EQ(out.error, voltage ? b.error : a.error) << n;
      differ += a.step != b.step;
    }
    EXPECT_GT(differ, 2500) << "two models";
  }
}

}  // namespace
}  // namespace steplock
