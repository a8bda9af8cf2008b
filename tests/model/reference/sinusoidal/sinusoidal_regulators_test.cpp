#include "model/reference/sinusoidal/regulators.hpp"

#include <gtest/gtest.h>

namespace steplock::reference::sinusoidal {
namespace {

constexpr double kPeriod = 200e-6;
const design::sinusoidal::Motor kMotor{.resistance = 2, .inductance_d = 10e-3, .inductance_q = 15e-3,
                                       .k_e = 0.33, .pole_pairs = 3};
const design::sinusoidal::CurrentRegulator kGains{.kp_gamma = 6, .kp_delta = 9, .ki_gamma = 1200,
                                                  .ki_delta = 1800};

// The motor on the gamma-delta model, Euler in a hundredth of a period.
struct Winding {
  Vector i;
  double w;
  void apply(Vector v) {
    for (int n = 0; n < 100; ++n) {
      const double h = kPeriod / 100;
      const double x = (v.x - kMotor.resistance * i.x + w * kMotor.inductance_q * i.y) / kMotor.inductance_d;
      const double y = (v.y - kMotor.resistance * i.y - w * (kMotor.inductance_d * i.x + kMotor.k_e)) /
                       kMotor.inductance_q;
      i = i + h * Vector{x, y};
    }
  }
};

TEST(SinusoidalRegulators, BothCurrentsReachTheirSetPointsAndGammaStaysAtZero) {
  for (const double w : {0.0, 300.0, -300.0}) {
    CurrentRegulator regulator(kMotor, kGains, kPeriod);
    Winding winding{{}, w};
    double gamma = 0;
    for (int n = 0; n < 500; ++n) {
      winding.apply(regulator.update({0, 5}, winding.i, w, 500));
      gamma = std::max(gamma, std::abs(winding.i.x));
    }
    EXPECT_NEAR(winding.i.y, 5, 1e-3) << w;
    EXPECT_NEAR(winding.i.x, 0, 1e-3);
    EXPECT_LT(gamma, 0.5);  // decoupled: a tenth of the step at most
    EXPECT_FALSE(regulator.saturated());
  }
}

TEST(SinusoidalRegulators, TheVoltageStaysInItsLimitAndTheIntegralDoesNotWindUp) {
  CurrentRegulator regulator(kMotor, kGains, kPeriod);
  Winding winding{{}, 100};
  for (int n = 0; n < 5000; ++n) {
    const Vector v = regulator.update({0, 50}, winding.i, 100, 60);
    ASSERT_LE(v.length(), 60 + 1e-9);
    winding.apply(v);
  }
  EXPECT_TRUE(regulator.saturated());
  int samples = 0;
  while (std::abs(winding.i.y - 2) > 0.1 && ++samples < 1000) {
    winding.apply(regulator.update({0, 2}, winding.i, 100, 60));
  }
  EXPECT_LT(samples, 100);  // 20 ms, a few time constants; a second of winding up would take longer
}

TEST(SinusoidalRegulators, SpeedIsHeldUnderLoadWithinTheLimitAndTheSlew) {
  SpeedRegulator regulator({.slew = 1000, .filter = 600, .kp = 0.1, .ki = 3, .limit = 10}, kPeriod);
  regulator.start(0);
  double speed = 0, last = 0, fastest = 0;
  for (int n = 0; n < 20000; ++n) {
    const double i = regulator.update(300, speed);
    ASSERT_LE(std::abs(i), 10);
    speed += kPeriod * (1500 * i - (n > 10000 ? 6000 : 0));  // a load of 4 A
    fastest = std::max(fastest, std::abs(regulator.reference() - last));
    last = regulator.reference();
  }
  EXPECT_NEAR(speed, 300, 0.03);
  EXPECT_NEAR(fastest, 1000 * kPeriod, 1e-9);
}

TEST(SinusoidalRegulators, TheFirstCurrentIsTheStartsAndNoneBrakesBeforeTheLock) {
  for (const int way : {1, -1}) {
    SpeedRegulator regulator({.slew = 1000, .filter = 600, .kp = 0.1, .ki = 3, .limit = 10, .start_current = 2}, kPeriod);
    regulator.start(0, way);
    EXPECT_NEAR(way * regulator.update(0, 0, false), 2, 1e-12);
    for (int n = 0; n < 2000; ++n) ASSERT_GE(way * regulator.update(way * 300, way * 500, false), 0) << n;
    EXPECT_EQ(regulator.update(way * 300, way * 500, false), 0);
    EXPECT_FALSE(regulator.saturated());
    EXPECT_LT(way * regulator.update(way * 300, way * 500, true), 0);
  }
}

TEST(SinusoidalRegulators, ALimitThatHoldsIsReportedAndLeftWithoutDelay) {
  SpeedRegulator regulator({.slew = 1e9, .filter = 1e5, .kp = 0.1, .ki = 3, .limit = 10}, kPeriod);
  regulator.start(0);
  for (int n = 0; n < 10000; ++n) regulator.update(300, 0);
  EXPECT_TRUE(regulator.saturated());
  double i = 10;
  int samples = 0;
  while (i >= 0 && ++samples < 1000) i = regulator.update(300, 500);
  EXPECT_LT(samples, 5);
}

}  // namespace
}  // namespace steplock::reference::sinusoidal
