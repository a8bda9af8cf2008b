// The law; where a limit stands in its way: speed_control_limits_test.cpp.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "tests/hls/speed_bench.hpp"

namespace steplock {
namespace {

using test::duty_of;
using test::reference_as_duty;
using test::typical;
using test::update;

constexpr double kFull = 32768.0;  // duty of 100 %, and normalised full-scale speed

TEST(SpeedControl, TakesTheStartDutyAndScalesItToThePeriod) {
  SpeedControl dut;
  auto in = typical();
  in.fixed_duty = 0x4000;
  const auto out = update(dut, in);
  EXPECT_EQ(out.duty, Duty(0x4000));
  EXPECT_EQ(out.on_clocks, Clocks(800));
}

TEST(SpeedControl, FullDutyIsTheWholePeriodAndNoneIsNone) {
  SpeedControl dut;
  auto in = typical();
  for (const int period : {1, 400, 1599, 16383}) {
    in.period = period;
    in.fixed_duty = 0x8000;
    EXPECT_EQ(update(dut, in).on_clocks, Clocks(period));
    in.fixed_duty = 0;
    EXPECT_EQ(update(dut, in).on_clocks, Clocks(0));
  }
}

TEST(SpeedControl, StaysAboveTheBackEmfBeforeLock) {
  SpeedControl dut;
  auto in = typical();
  in.mode = SpeedMode::kFeedForwardDrive;
  in.frequency = 16384 << 4;
  in.config.bemf = 6144;  // 1.5
  const auto out = update(dut, in);
  EXPECT_EQ(out.duty, Duty(24576));
  in.fixed_duty = 1000;
  EXPECT_EQ(update(dut, in).duty, Duty(25576));
  in.fixed_duty = 0x8000;
  EXPECT_EQ(update(dut, in).duty, in.config.maximum);
}

// A brake: 1 + I R / V - E / V, one last bit less, since the one's complement stands for the negative.
TEST(SpeedControl, BrakesWithSoMuchLessThanTheBackEmfWants) {
  SpeedControl dut;
  auto in = typical();
  in.mode = SpeedMode::kFeedForwardBrake;
  in.config.bemf = 6144;  // 1.5
  in.fixed_duty = 40000;
  in.frequency = 16384 << 4;  // 24576 of the duty
  EXPECT_EQ(update(dut, in).duty, Duty(40000 - 24576 - 1));
  in.frequency = 0;
  EXPECT_EQ(update(dut, in).duty, in.config.maximum) << "slow: the current is less than it may be";
  in.frequency = 32768 << 4;
  EXPECT_EQ(update(dut, in).duty, Duty(0)) << "so fast that the diodes brake";
  in.mode = SpeedMode::kControl;
  in.target = in.frequency;
  EXPECT_LE(update(dut, in).duty, in.config.minimum + 1000) << "control begins with none";
}

TEST(SpeedControl, BeginsWithoutAJump) {
  SpeedControl dut;
  auto in = typical();
  in.fixed_duty = 9000;
  in.frequency = 5000 << 4;
  update(dut, in);
  in.mode = SpeedMode::kControl;
  in.target = in.frequency;
  // The error is a last bit of frequency low, and both products round down.
  EXPECT_NEAR(double(update(dut, in).duty.raw()), 9000, 2);
}

TEST(SpeedControl, ReferenceMovesByTheSlewAndThenStays) {
  SpeedControl dut;
  auto in = reference_as_duty();
  update(dut, in);
  in.mode = SpeedMode::kControl;
  in.target = 250 << 4;
  const auto duty = [&] { return double(update(dut, in).duty.raw()); };
  EXPECT_NEAR(duty(), 100, 1);
  EXPECT_NEAR(duty(), 200, 1);
  EXPECT_NEAR(duty(), 250, 1);
  EXPECT_NEAR(duty(), 250, 1);
  in.target = 0;
  EXPECT_NEAR(duty(), 150, 1);
}

TEST(SpeedControl, SlipsWhenTheDutyIsMoreThanTheBackEmfExplains) {
  SpeedControl dut;
  auto in = typical();
  in.fixed_duty = 10000;
  in.frequency = 8000 << 4;  // bemf is 1: 8000 of the duty
  in.slip = 3000;
  EXPECT_FALSE(update(dut, in).slips);
  in.mode = SpeedMode::kControl;
  in.target = in.frequency;
  EXPECT_FALSE(update(dut, in).slips);
  in.slip = 1000;
  EXPECT_TRUE(update(dut, in).slips);
  in.config.loaded = 0x1480;  // 9/32 of the speed more, for commutation: 2250
  EXPECT_FALSE(update(dut, in).slips);
  in.mode = SpeedMode::kFixed;  // only a lock can slip
  EXPECT_FALSE(update(dut, in).slips);
}

TEST(SpeedControl, DutyMovesByItsSlewOnly) {
  SpeedControl dut;
  auto in = typical();
  in.config.duty_slew = 10;
  update(dut, in);
  in.mode = SpeedMode::kControl;
  in.target = Frequency::max();
  EXPECT_EQ(update(dut, in).duty, Duty(10));
  EXPECT_EQ(update(dut, in).duty, Duty(20));
}

// The control law in doubles; what may differ is the truncation of each product: the speed error by
// one unit (times kp and ki), the proportional product by one, the integral's upper half by one.
RC_GTEST_PROP(SpeedControl, EqualsTheLawToTheLastBits, ()) {
  auto in = typical();
  in.config.kp = *rc::gen::inRange(0, 4 << 12);
  in.config.ki = *rc::gen::inRange(0, 20000);
  in.config.slew = (1 << 20) - 1;
  in.fixed_duty = *rc::gen::inRange(8000, 24000);
  in.frequency = *rc::gen::inRange(8000 << 4, 24000 << 4);
  SpeedControl dut;
  update(dut, in);
  in.mode = SpeedMode::kControl;
  in.target = in.frequency.raw() + *rc::gen::inRange(-400 * 16, 400 * 16);

  const double kp = double(in.config.kp.raw()) / 4096;
  const double ki = double(in.config.ki.raw()) / 65536;
  const double error = (double(in.target.raw()) - double(in.frequency.raw())) / 16;
  double integral = double(in.fixed_duty.raw());
  Duty duty = in.fixed_duty;
  for (int i = 1; i <= 5; ++i) {
    const double before = double(duty.raw());
    integral += ki * error;
    const double expected = integral + kp * error;
    // Beyond these a limit has a say: speed_control_limits_test.cpp.
    if (expected < 0 || expected > kFull || std::abs(expected - before) > double(in.config.duty_slew.raw())) break;
    duty = update(dut, in).duty;
    RC_ASSERT(std::abs(double(duty.raw()) - expected) <= 2 + kp + i * ki);
  }
}

}  // namespace
}  // namespace steplock
