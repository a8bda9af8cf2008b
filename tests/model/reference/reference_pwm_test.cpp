// PWM edges and the fixed-off-time limit of the reference, at exact instants.
#include <gtest/gtest.h>

#include <vector>

#include "model/reference/pwm.hpp"

namespace steplock::reference {
namespace {

constexpr double kPeriod = 1.0 / 30e3, kRounding = 1e-15;

struct Pulse {
  double rise = 0, fall = 0;
};

// All pulses of `periods` periods at this duty.
std::vector<Pulse> pulses(design::PwmParameters p, double duty, int periods) {
  p.period = kPeriod;
  Pwm pwm(p);
  pwm.set_duty(duty);
  std::vector<Pulse> found;
  double t = 0;
  bool on = false;
  while (t < (periods - 0.5) * kPeriod) {
    pwm.update(t);
    if (pwm.on() && !on) found.push_back({t, kNever});
    if (!pwm.on() && on) found.back().fall = t;
    on = pwm.on();
    t = pwm.next(t);
  }
  return found;
}

TEST(ReferencePwm, PulseHasExactlyItsWidth) {
  for (const auto& pulse : pulses({}, 0.37, 5)) {
    if (pulse.fall == kNever) continue;  // the run ended in it
    EXPECT_NEAR(pulse.fall - pulse.rise, 0.37 * kPeriod, kRounding);
  }
}

TEST(ReferencePwm, CentredPulseStandsInTheMiddle) {
  const auto all = pulses({.centred = true}, 0.4, 3);
  ASSERT_EQ(all.size(), 3u);
  EXPECT_NEAR((all[1].rise + all[1].fall) / 2, 1.5 * kPeriod, kRounding);
}

TEST(ReferencePwm, FullAndZeroDutyHaveNoEdges) {
  const auto full = pulses({}, 1.0, 5);
  ASSERT_EQ(full.size(), 1u);
  EXPECT_EQ(full[0].fall, kNever);
  EXPECT_TRUE(pulses({}, 0.0, 5).empty());
}

TEST(ReferencePwm, TooShortPulsesBecomeNoneAndTooShortGapsFull) {
  EXPECT_TRUE(pulses({.minimum = 2e-6}, 1e-6 / kPeriod, 3).empty());
  EXPECT_EQ(pulses({.minimum = 2e-6}, 1 - 1e-6 / kPeriod, 3).at(0).fall, kNever);
}

TEST(ReferencePwm, TakesItsDutyAtThePeriodsStartOnly) {
  Pwm pwm({.period = kPeriod});
  pwm.set_duty(0.5);
  pwm.update(0);
  pwm.set_duty(0.9);
  const double fall = pwm.next(0);
  EXPECT_NEAR(fall, 0.5 * kPeriod, kRounding);
  EXPECT_EQ(pwm.duty(), 0.5);
}

TEST(ReferencePwm, TicksOncePerTickPeriods) {
  Pwm pwm({.period = kPeriod, .tick_periods = 30});
  int ticks = 0;
  double t = 0;
  while (t < 299.5 * kPeriod) {
    pwm.update(t);
    ticks += pwm.tick();
    t = pwm.next(t);
  }
  EXPECT_EQ(ticks, 10);
}

TEST(ReferenceCurrentLimit, CutsForItsFixedOffTimeWhateverTheComparatorDoes) {
  CurrentLimit limit({.blanking = 2e-6, .off_time = 20e-6});
  limit.update(0, true, true);  // blanked
  EXPECT_TRUE(limit.on());
  limit.update(limit.next(0), true, true);
  EXPECT_TRUE(limit.hit());
  EXPECT_FALSE(limit.on());
  limit.update(5e-6, true, false);
  EXPECT_FALSE(limit.on());
  limit.update(limit.next(5e-6), true, false);
  EXPECT_TRUE(limit.on());
  EXPECT_NEAR(limit.next(22e-6), 24e-6, kRounding);  // blanked anew
}

TEST(ReferenceCurrentLimit, CutsForAQuarterWhereTheBusTakesTheCurrentDown) {
  CurrentLimit limit({.blanking = 2e-6, .off_time = 20e-6});
  limit.update(0, true, true, true);
  limit.update(limit.next(0), true, true, true);
  ASSERT_TRUE(limit.hit());
  EXPECT_NEAR(limit.next(2e-6), 7e-6, kRounding);
  limit.update(limit.next(2e-6), true, false, true);
  EXPECT_TRUE(limit.on());
}

TEST(ReferenceCurrentLimit, CountsHitsThatNeverRelease) {
  CurrentLimit limit({.blanking = 1e-6, .off_time = 10e-6});
  double t = 0;
  for (int k = 0; k < 3; ++k) {
    limit.update(t, true, true);
    t = limit.next(t);
    limit.update(t, true, true);  // the hit
    t = limit.next(t);            // the end of the off-time
  }
  limit.update(t, true, true);
  EXPECT_EQ(limit.stuck(), 3);
  limit.update(t += 1e-6, true, true);  // a hit that releases
  limit.update(t += 1e-6, true, false);
  limit.update(t += 9e-6, true, false);
  EXPECT_EQ(limit.stuck(), 0);
}

TEST(ReferenceCurrentLimit, WithoutOffTimeNeverCuts) {
  CurrentLimit limit({.blanking = 0, .off_time = 0});
  limit.update(0, true, true);
  limit.update(1, true, true);
  EXPECT_TRUE(limit.on());
}

}  // namespace
}  // namespace steplock::reference
