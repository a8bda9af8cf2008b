// Speed control of the reference, on a first-order motor.
#include <gtest/gtest.h>

#include <cmath>

#include "model/reference/speed_control.hpp"

namespace steplock::reference {
namespace {

constexpr double kTick = 1e-3, kTau = 0.05, kTop = 1000;  // s, s, steps/s at full duty

design::SpeedParameters gains(double bandwidth) {
  const double kp = bandwidth * kTau / kTop;
  return {.slew = 1e4,
          .kp = kp,
          .ki = kp / kTau,
          .bemf = 1 / kTop,
          .minimum = 0.02,
          .maximum = 1,
          .duty_slew = 50};
}

TEST(ReferenceSpeedControl, ReachesItsTargetWithTheWantedBandwidth) {
  SpeedControl control(gains(20), kTick);
  control.follow(0.3, 0.3, 300);
  double f = 300, t = 0;
  for (; t < 0.06; t += kTick) {
    control.tick(400, f, false);
    f += (kTop * control.duty() - f) / kTau * kTick;
  }
  // 20 rad/s behind a reference that takes 10 ms: 1 - e^-1 after 50 ms plus half the ramp.
  EXPECT_NEAR(f, 400 - 100 * std::exp(-20 * (t - 0.005)), 5);
  for (int k = 0; k < 500; ++k) {
    control.tick(400, f, false);
    f += (kTop * control.duty() - f) / kTau * kTick;
  }
  EXPECT_NEAR(f, 400, 0.01);
}

TEST(ReferenceSpeedControl, BeginsWithoutAJump) {
  SpeedControl control(gains(20), kTick);
  control.follow(0.37, 0.37, 250);
  control.tick(250, 250, false);
  EXPECT_DOUBLE_EQ(control.duty(), 0.37);
}

TEST(ReferenceSpeedControl, JoinsInMidRunWithoutAJump) {
  SpeedControl control(gains(20), kTick);
  control.join(0.4, 400, 395);
  control.tick(400, 395, false);
  EXPECT_NEAR(control.duty(), 0.4, 1e-12);
  control.tick(400, 395, false);
  // From there on, only the integral moves it.
  EXPECT_NEAR(control.duty(), 0.4 + gains(20).ki * kTick * 5, 1e-12);
}

TEST(ReferenceSpeedControl, ReferenceMovesByItsSlewOnly) {
  SpeedControl control(gains(20), kTick);
  control.follow(0.3, 0.3, 300);
  control.tick(800, 300, false);
  EXPECT_DOUBLE_EQ(control.reference(), 310);
}

TEST(ReferenceSpeedControl, DoesNotWindUpAtFullDuty) {
  SpeedControl control(gains(20), kTick);
  control.follow(0.9, 0.9, 900);
  for (int k = 0; k < 2000; ++k) control.tick(1500, 950, false);  // out of reach
  EXPECT_DOUBLE_EQ(control.duty(), 1);
  for (int k = 0; k < 60; ++k) control.tick(900, 950, false);  // 60 ms: reference and duty's slew
  EXPECT_LT(control.duty(), 0.95);
}

TEST(ReferenceSpeedControl, DoesNotWindUpAgainstTheCurrentLimit) {
  SpeedControl free(gains(20), kTick), limited(gains(20), kTick);
  free.follow(0.3, 0.3, 300), limited.follow(0.3, 0.3, 300);
  for (int k = 0; k < 100; ++k) free.tick(310, 300, false), limited.tick(310, 300, true);
  EXPECT_GT(free.duty(), limited.duty() + 0.01);
}

TEST(ReferenceSpeedControl, HoldsTheDutyAtTheCurrentLimitAndLowersItWhereThatCurrentFreewheelsTooLong) {
  SpeedControl control(gains(20), kTick);
  control.follow(0.3, 0.3, 300);
  for (int k = 0; k < 10; ++k) control.tick(800, 300, true);
  EXPECT_DOUBLE_EQ(control.duty(), 0.3);
  control.tick(800, 300, true, false, true);
  EXPECT_DOUBLE_EQ(control.duty(), 0.3 - 2 * gains(20).duty_slew * kTick);
  control.follow(0.3, 0.3, 300);
  for (int k = 0; k < 2; ++k) control.tick(800, 300, false);  // it asks for more than its slew gives
  const double duty = control.duty();
  control.tick(800, 300, false, false, true);
  EXPECT_DOUBLE_EQ(control.duty(), duty - 2 * gains(20).duty_slew * kTick);
  control.follow(0.3, 0.3, 300);
  control.tick(300, 300, false);
  control.tick(300, 300, false, false, true);  // a steady rotor: long freewheeling is no reason
  EXPECT_DOUBLE_EQ(control.duty(), 0.3);
}

TEST(ReferenceSpeedControl, LowersTheDutyWhereFreewheelingIsLongAndTheIntegralIsToRise) {
  for (const double rise : {0.9, 1.1}) {  // of 2^-13 a tick
    auto slow = gains(20);
    slow.kp = 0;
    slow.slew = 1e9;
    SpeedControl control(slow, kTick);
    control.follow(0.3, 0.3, 300);
    const double error = rise / 8192 / (slow.ki * kTick);
    control.tick(300 + error, 300, false, false, true);
    EXPECT_NEAR(control.duty(), 0.3 + (rise < 1 ? rise / 8192 : -2 * slow.duty_slew * kTick), 1e-12);
  }
}

TEST(ReferenceSpeedControl, LowersTheDutyByItsSlewWhileFreewheelingHidesCrossings) {
  SpeedControl control(gains(20), kTick);
  control.follow(0.8, 0.8, 300);
  double duty = control.duty();
  for (int k = 0; k < 5; ++k) {
    control.tick(800, 300, false, true);
    EXPECT_DOUBLE_EQ(control.duty(), duty - gains(20).duty_slew * kTick);
    duty = control.duty();
  }
  control.tick(800, 300, false);
  EXPECT_DOUBLE_EQ(control.duty(), duty + gains(20).duty_slew * kTick);
}

TEST(ReferenceSpeedControl, StaysWithinItsDuties) {
  SpeedControl control(gains(20), kTick);
  control.follow(0.1, 0.1, 100);
  for (int k = 0; k < 500; ++k) control.tick(800, 100, false, true);
  EXPECT_DOUBLE_EQ(control.duty(), 0.02) << "nor does it yield beyond";
  control.follow(0.1, 0.1, 100);
  for (int k = 0; k < 500; ++k) control.tick(0, 100, false);
  EXPECT_DOUBLE_EQ(control.duty(), 0.02);
}

}  // namespace
}  // namespace steplock::reference
