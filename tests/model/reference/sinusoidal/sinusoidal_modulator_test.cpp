#include "model/reference/sinusoidal/modulator.hpp"

#include <gtest/gtest.h>

namespace steplock::reference::sinusoidal {
namespace {

using design::Modulation;

TEST(SinusoidalModulator, TheDutiesMakeTheVectorUpToTheLinearRange) {
  for (const Modulation m : {Modulation::kSpaceVector, Modulation::kSine}) {
    const double most = longest_vector(m, 270);
    for (double angle = 0; angle < 6.3; angle += 0.05) {
      const Vector wanted = from_frame(angle, {0.999 * most, 0});
      const Phases d = duties(m, wanted, 270);
      const Vector made = clarke({270 * d[0], 270 * d[1], 270 * d[2]});
      EXPECT_NEAR(made.x, wanted.x, 1e-9 * most);
      EXPECT_NEAR(made.y, wanted.y, 1e-9 * most);
    }
  }
}

TEST(SinusoidalModulator, SpaceVectorsReachTwoOverRootThreeTimesAsFar) {
  EXPECT_NEAR(longest_vector(Modulation::kSpaceVector, 100) / longest_vector(Modulation::kSine, 100),
              2 / std::sqrt(3), 1e-12);
  // Just beyond, somewhere on the turn a duty is clipped.
  for (const Modulation m : {Modulation::kSpaceVector, Modulation::kSine}) {
    double worst = 0;
    for (double angle = 0; angle < 6.3; angle += 0.01) {
      const Vector wanted = from_frame(angle, {1.02 * longest_vector(m, 100), 0});
      const Phases d = duties(m, wanted, 100);
      worst = std::max(worst, (clarke({100 * d[0], 100 * d[1], 100 * d[2]}) - wanted).length());
    }
    EXPECT_GT(worst, 0.5);
  }
}

TEST(SinusoidalModulator, PulsesAreCentredAndAllLowSidesConductAtTheSample) {
  CentredPwm pwm({.period = 100e-6, .minimum = 2e-6});
  pwm.set({0.2, 0.5, 0.8});
  double high[3] = {}, centre[3] = {};
  double t = 0;
  while (t < 100e-6 - 1e-12) {
    pwm.update(t);
    if (t == 0) {
      EXPECT_TRUE(pwm.started());
      for (std::size_t k = 0; k < 3; ++k) EXPECT_FALSE(pwm.high(k, t));
    }
    const double next = pwm.next(t);
    ASSERT_GT(next, t);
    for (std::size_t k = 0; k < 3; ++k) {
      if (!pwm.high(k, t)) continue;
      high[k] += next - t;
      centre[k] += (next - t) * (next + t) / 2;
    }
    t = next;
  }
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(high[k], (0.2 + 0.3 * k) * 100e-6, 1e-12);
    EXPECT_NEAR(centre[k] / high[k], 50e-6, 1e-12);
  }
}

TEST(SinusoidalModulator, PulsesShorterThanTheMinimumAreNone) {
  CentredPwm pwm({.period = 100e-6, .minimum = 2e-6});
  pwm.set({0.015, 0.985, 0.03});
  pwm.update(0);
  EXPECT_EQ(pwm.duty()[0], 0);
  EXPECT_EQ(pwm.duty()[1], 1);
  EXPECT_EQ(pwm.duty()[2], 0.03);
}

}  // namespace
}  // namespace steplock::reference::sinusoidal
