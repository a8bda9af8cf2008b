// Speed control where a limit stands in its way: its own bounds, a lower target, the current limit, hidden crossings.
#include <gtest/gtest.h>

#include "tests/hls/speed_bench.hpp"

namespace steplock {
namespace {

using test::duty_of;
using test::reference_as_duty;
using test::typical;
using test::update;

// Held against a limit for a thousand ticks, the duty leaves it on the first tick after the error
// turned: nothing was wound up.
TEST(SpeedControl, DoesNotWindUpAtItsLimits) {
  for (const bool high : {true, false}) {
    SpeedControl dut;
    auto in = typical();
    in.config.kp = 0;
    in.config.minimum = 1000;
    in.config.maximum = 20000;
    in.fixed_duty = 10000;
    in.frequency = 10000 << 4;
    update(dut, in);
    in.mode = SpeedMode::kControl;
    in.target = (high ? 15000 : 5000) << 4;
    for (int i = 0; i < 1000; ++i) update(dut, in);
    const auto held = update(dut, in).duty;
    EXPECT_EQ(held, Duty(high ? 20000 : 1000));
    in.frequency = (high ? 16000 : 4000) << 4;
    const auto left = update(dut, in).duty;
    EXPECT_EQ(left < held, high);
    EXPECT_EQ(left > held, !high);
  }
}

// The proportional part alone wants more than a limit gives, or than the slew lets through: the integral stands, and
// with the error gone the duty comes back to what it was.
TEST(SpeedControl, DoesNotWindUpWhereTheProportionalPartIsLimited) {
  for (const bool up : {true, false}) {
    for (const int duty_slew : {4095, 10}) {
      SpeedControl dut;
      auto in = typical();
      in.config.kp = 8 << 12;
      in.config.duty_slew = duty_slew;
      in.config.slew = (1 << 20) - 1;
      in.fixed_duty = 16000;
      in.frequency = 10000 << 4;
      update(dut, in);
      in.mode = SpeedMode::kControl;
      in.target = (up ? 14000 : 6000) << 4;
      for (int i = 0; i < 30; ++i) update(dut, in);
      in.frequency = in.target;
      int duty = 0;
      for (int i = 0; i < 100; ++i) duty = static_cast<int>(update(dut, in).duty.raw());
      // One update at most went by before the bound was seen: a tenth of the error.
      EXPECT_NEAR(duty, 16000, 400 + 30) << up << ' ' << duty_slew;
    }
  }
}

// Caught far above its set speed a rotor coasts with the least duty, longer than the reference takes; when it has come down to
// that, control begins as it does with a rotor that was caught there: with the back-EMF's duty, and not with an integral of none.
TEST(SpeedControl, BeginsOnceMoreWhereARotorHasComeDownToALowerTarget) {
  SpeedControl dut;
  auto in = typical();
  in.mode = SpeedMode::kFeedForwardDrive;
  in.config.slew = 1000 << 4;
  in.frequency = 20000 << 4;
  update(dut, in);
  in.mode = SpeedMode::kControl;
  in.target = 8000 << 4;
  for (int speed = 20000; speed >= 8000; speed -= 100) {
    in.frequency = speed << 4;
    update(dut, in);
  }
  EXPECT_LT(duty_of(update(dut, in)), 4000);
  in.frequency = 7900 << 4;
  update(dut, in);  // sees that it is below
  EXPECT_NEAR(duty_of(update(dut, in)), 7900, 1);
  // Once: from here on it is the law's.
  in.config.ki = in.config.kp = 0;
  EXPECT_NEAR(duty_of(update(dut, in)), 7900, 1);
  in.frequency = 7000 << 4;
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(duty_of(update(dut, in)), 7900, 1);
}

// A loaded rotor has more than the back-EMF's, and keeps it; no back-EMF asks for more than there is.
TEST(SpeedControl, BeginsOnceMoreWithTheDutyThatItHasIfThatIsMore) {
  for (const bool loaded : {true, false}) {
    SpeedControl dut;
    auto in = typical();
    in.config.ki = in.config.kp = 0;
    in.config.maximum = 30000;
    in.config.bemf = loaded ? 1 << 12 : 4 << 12;
    in.fixed_duty = 15000;
    in.frequency = 9000 << 4;
    update(dut, in);
    in.mode = SpeedMode::kControl;
    in.fixed_duty = 0;
    in.config.slew = 100 << 4;
    in.target = 8500 << 4;
    for (int i = 0; i < 10; ++i) update(dut, in);
    in.frequency = 8000 << 4;
    update(dut, in);
    EXPECT_NEAR(duty_of(update(dut, in)), loaded ? 15000 : 30000, 1);
  }
}

// A rotor that only swings past a set speed that it had reached has an integral, and keeps it.
TEST(SpeedControl, KeepsItsIntegralWhereTheReferenceWasAtTheTarget) {
  SpeedControl dut;
  auto in = typical();
  in.fixed_duty = 10000;
  in.frequency = 4000 << 4;
  update(dut, in);
  in.mode = SpeedMode::kControl;
  in.target = 4000 << 4;
  in.config.ki = 0;
  in.frequency = 12000 << 4;
  for (int i = 0; i < 5; ++i) update(dut, in);
  EXPECT_EQ(update(dut, in).duty, Duty(0));
  in.frequency = 3990 << 4;
  for (int i = 0; i < 5; ++i) update(dut, in);
  EXPECT_NEAR(duty_of(update(dut, in)), 10000 + 20, 2);
}

// From a start's duty of 10000 to a set speed far above.
SpeedControl::In accelerating(SpeedControl& dut) {
  auto in = typical();
  in.config.duty_slew = 50;
  in.fixed_duty = 10000;
  update(dut, in);
  in.mode = SpeedMode::kControl;
  in.target = 5000 << 4;
  return in;
}

// The duty after 40 ticks, each of which took so many times the slew of 50 from it: one more, the one's complement.
int falls(SpeedControl& dut, const SpeedControl::In& in, int duty, int times = 2) {
  for (int i = 0; i < 40; ++i) {
    const int now = duty_of(update(dut, in));
    EXPECT_EQ(now, duty - (50 * times + 1)) << i;
    duty = now;
  }
  return duty;
}

TEST(SpeedControl, HoldsTheDutyWhileTheCurrentLimitCutsAndDoesNotWindUp) {
  SpeedControl dut;
  auto in = accelerating(dut);
  in.config.kp = 0;
  in.limited = true;
  update(dut, in);  // the first cut holds the duty from the next integral on
  const Duty held = update(dut, in).duty;
  for (int i = 0; i < 100; ++i) ASSERT_EQ(update(dut, in).duty, held) << i;
  in.limited = false;
  update(dut, in);  // the last cut still counts in this one
  update(dut, in);
  EXPECT_GT(update(dut, in).duty, held);
}

TEST(SpeedControl, TheReferenceWaitsForARotorThatTheCurrentLimitHoldsBack) {
  SpeedControl dut;
  auto in = reference_as_duty();
  update(dut, in);
  in.mode = SpeedMode::kControl;
  in.target = 1000 << 4;
  in.limited = true;
  for (int i = 0; i < 20; ++i) update(dut, in);
  in.limited = false;
  for (int i = 0; i < 3; ++i) update(dut, in);
  // One tick of the slew before the first cut counted; then those of the last two updates: the last cut counts until the first
  // of four has seen it, and the second waits for that.
  EXPECT_NEAR(double(update(dut, in).duty.raw()), 300, 1);
  in.target = 0;  // downwards it never waits
  in.limited = true;
  for (int i = 0; i < 20; ++i) update(dut, in);
  in.limited = false;
  EXPECT_EQ(update(dut, in).duty, Duty(0));
}

TEST(SpeedControl, LowersTheDutyWhereTheLimitsCurrentFreewheelsForHalfAStep) {
  SpeedControl dut;
  auto in = accelerating(dut);
  in.limited = in.freewheels = true;
  update(dut, in);
  falls(dut, in, duty_of(update(dut, in)));
}

TEST(SpeedControl, LowersTheDutyWhereFreewheelingIsLongAndMoreIsAskedFor) {
  SpeedControl dut;
  auto in = accelerating(dut);
  const int duty = duty_of(update(dut, in));
  EXPECT_EQ(duty, 10050);  // it wants more than its slew gives
  in.freewheels = true;
  falls(dut, in, duty);
}

// Well within its slew: what the integral alone asks for in a tick, 2^-13 or a tenth less.
TEST(SpeedControl, LowersTheDutyWhereFreewheelingIsLongAndItIsToRiseSlowly) {
  for (const int error : {36, 41}) {
    SpeedControl with, without;
    auto in = typical();
    in.config.kp = 0;
    in.config.duty_slew = 50;
    in.fixed_duty = 10000;
    in.frequency = in.target = 5000 << 4;
    update(with, in), update(without, in);
    in.mode = SpeedMode::kControl;
    in.target = (5000 + error) << 4;
    update(with, in);
    const int duty = duty_of(update(without, in));
    EXPECT_NEAR(duty, 10000 + error / 10, 1);
    in.freewheels = true;
    if (error == 41) {
      falls(with, in, duty);
    } else {
      const int risen = duty_of(update(with, in));
      in.freewheels = false;
      EXPECT_EQ(risen, duty_of(update(without, in)));
    }
  }
}

// A steady rotor's long freewheeling is a matter of its speed, and no reason to lower the duty.
TEST(SpeedControl, KeepsItsLawWhereFreewheelingIsLongAndNoMoreIsAskedFor) {
  SpeedControl with, without;
  auto in = typical();
  in.fixed_duty = 10000;
  in.frequency = in.target = 5000 << 4;
  update(with, in), update(without, in);
  in.mode = SpeedMode::kControl;
  for (int i = 0; i < 100; ++i) {
    in.target = Frequency((5000 << 4) + i % 7 - 3);  // the duty moves, by less than its slew
    in.freewheels = true;
    const Duty duty = update(with, in).duty;
    in.freewheels = false;
    ASSERT_EQ(duty, update(without, in).duty) << i;
  }
}

TEST(SpeedControl, LowersTheDutyByItsSlewWhileFreewheelingHidesCrossings) {
  SpeedControl dut;
  auto in = accelerating(dut);
  in.masked_lead = true;
  const int duty = falls(dut, in, 10000, 1);
  in.masked_lead = false;  // a crossing showed
  EXPECT_EQ(duty_of(update(dut, in)), duty + 50);
}

// The least duty goes before the slew: freewheeling that hides crossings takes no duty below it, and a higher one counts at once.
TEST(SpeedControl, KeepsItsLeastDutyWhereItYields) {
  for (const bool masked_lead : {true, false}) {
    SpeedControl dut;
    auto in = reference_as_duty();
    in.config.minimum = 3000;
    in.config.duty_slew = 50;
    in.fixed_duty = 3020;
    in.frequency = 4000 << 4;
    update(dut, in);
    in.mode = SpeedMode::kControl;
    in.target = 20000 << 4;
    in.masked_lead = masked_lead;
    in.freewheels = in.limited = !masked_lead;
    for (int i = 0; i < 5; ++i) EXPECT_GE(duty_of(update(dut, in)), 3000) << masked_lead << i;
    EXPECT_EQ(duty_of(update(dut, in)), 3000) << masked_lead;
    in.config.minimum = 5000;
    EXPECT_EQ(duty_of(update(dut, in)), 5000) << masked_lead;
  }
}

// A lower limit from above is approached by the slew: less duty than the back-EMF's drives a current that no shunt sees.
TEST(SpeedControl, ApproachesALowerLimitByItsSlew) {
  SpeedControl dut;
  auto in = reference_as_duty();
  in.fixed_duty = 20000;
  in.frequency = 1 << 4;
  update(dut, in);
  in.mode = SpeedMode::kControl;
  in.target = 20000 << 4;
  in.config.duty_slew = 50;
  in.config.maximum = 10000;
  EXPECT_EQ(duty_of(update(dut, in)), 20000 - 51);
  EXPECT_EQ(duty_of(update(dut, in)), 20000 - 102);
}

}  // namespace
}  // namespace steplock
