#include "hls/six_step/protection.hpp"

#include <gtest/gtest.h>

namespace steplock {
namespace {

Protection::In running() {
  Protection::In in;
  in.running = true;
  in.config = {.misses = 12,
              .stall = 100,
              .slip = 5000,
              .freewheel = 0x8000,
              .wrong_lock = 10,
              .over_current = 4};
  return in;
}

// Before the lock.
Protection armed(const Protection::In& in = running()) {
  Protection dut;
  auto before = in;
  before.running = false;
  dut.tick(before);
  return dut;
}

// A clock with the strobes of `in`, between two without: the drive's never come in clocks that follow each other.
Protection::Out step(Protection& dut, const Protection::In& in) {
  auto quiet = in;
  quiet.tick = quiet.commutate = quiet.update = quiet.good = quiet.missed = false;
  dut.tick(quiet);
  const auto out = dut.tick(in);
  dut.tick(quiet);
  return out;
}

Protection::Out repeat(Protection& dut, const Protection::In& in, int clocks) {
  Protection::Out out;
  for (int i = 0; i < clocks; ++i) out = step(dut, in);
  return out;
}

TEST(Protection, IsSilentInAGoodLock) {
  auto dut = armed();
  auto in = running();
  in.good = in.commutate = in.tick = true;
  for (int i = 0; i < 1000; ++i) {
    const auto out = step(dut, in);
    ASSERT_FALSE(out.lost || out.fatal || out.freewheel_long);
    ASSERT_EQ(out.reason, Reason::kNone);
  }
}

TEST(Protection, ThreeMissesInARowAreAStepOut) {
  auto dut = armed();
  auto in = running();
  in.missed = in.lags = true;
  EXPECT_FALSE(repeat(dut, in, 2).lost);
  const auto out = step(dut, in);
  EXPECT_TRUE(out.lost);
  EXPECT_EQ(out.reason, Reason::kStepOut);
}

// What adds to the score waits a clock, so the verdict on clocks that follow each other comes two later, and no more.
TEST(Protection, MissesInClocksThatFollowEachOtherAreCountedAll) {
  for (const bool lags : {false, true}) {
    auto dut = armed();
    auto in = running();
    in.missed = true;
    in.lags = lags;
    const int misses = lags ? 3 : 12;
    int clocks = 0;
    while (!dut.tick(in).lost && clocks < 100) ++clocks;
    EXPECT_GE(clocks, misses - 1);
    EXPECT_LE(clocks, misses + 1);
  }
}

TEST(Protection, TwelveHiddenCrossingsInARowAreAStepOut) {
  auto dut = armed();
  auto in = running();
  in.missed = true;
  EXPECT_FALSE(repeat(dut, in, 11).lost);
  EXPECT_EQ(step(dut, in).reason, Reason::kStepOut);
}

// Long freewheeling, or a PWM hardly faster than the steps, hides them of a rotor that follows.
TEST(Protection, OneHiddenCrossingInTwoIsForgiven) {
  auto dut = armed();
  auto in = running();
  for (int i = 0; i < 300; ++i) {
    in.missed = i % 2 == 0;
    in.good = !in.missed;
    ASSERT_FALSE(step(dut, in).lost);
  }
}

// What a comparator that is stuck does to every third step: in turn it never leaves the level before,
// and never shows it.
TEST(Protection, OneMissInThreeOfEitherKindIsAStepOutInTime) {
  auto dut = armed();
  auto in = running();
  bool lost = false;
  for (int i = 0; i < 6 * 15 && !lost; ++i) {
    in.missed = i % 3 == 0;
    in.lags = i % 6 == 0;
    in.good = !in.missed;
    lost = step(dut, in).lost;
  }
  EXPECT_TRUE(lost);
}

// A rotor that stands under commutated currents shows crossings, more bad ones than good ones.
TEST(Protection, CrossingsThatAreMostlyFarAreAStepOut) {
  auto dut = armed();
  auto in = running();
  in.update = true;
  for (int i = 0; i < 5; ++i) {  // to a score of 10
    for (const bool good : {false, false, false, true}) {
      in.good = good;
      ASSERT_FALSE(step(dut, in).lost);
    }
  }
  in.good = false;
  ASSERT_FALSE(step(dut, in).lost);
  EXPECT_EQ(step(dut, in).reason, Reason::kStepOut);
}

TEST(Protection, HalfOfTheCrossingsMayBeFar) {
  auto dut = armed();
  auto in = running();
  in.update = true;
  for (int i = 0; i < 300; ++i) {
    in.good = i % 2 == 0;
    ASSERT_FALSE(step(dut, in).lost);
  }
}

TEST(Protection, WithHallsFarChangesDoNotCount) {
  auto dut = armed();
  auto in = running();
  in.update = in.hall = true;
  EXPECT_FALSE(repeat(dut, in, 300).lost);
}

TEST(Protection, MissesOutsideSpeedControlDoNotCount) {
  auto dut = armed();
  auto in = running();
  in.missed = true;
  in.running = false;
  repeat(dut, in, 100);
  in.running = true;
  EXPECT_FALSE(step(dut, in).lost);
}

TEST(Protection, SixSlowStepsAreAStallAndFiveAreNot) {
  auto dut = armed();
  auto in = running();
  in.commutate = true;
  in.slow = true;
  EXPECT_FALSE(repeat(dut, in, 5).lost);
  in.slow = false;
  step(dut, in);
  in.slow = true;
  EXPECT_FALSE(repeat(dut, in, 5).lost);
  EXPECT_EQ(step(dut, in).reason, Reason::kStall);
}

TEST(Protection, TooMuchDutyForTheSpeedIsAWrongLock) {
  auto dut = armed();
  auto in = running();
  in.tick = true;
  EXPECT_FALSE(repeat(dut, in, 100).lost);
  in.slips = true;
  EXPECT_FALSE(repeat(dut, in, 4).lost);
  EXPECT_EQ(step(dut, in).reason, Reason::kWrongLock);
}

TEST(Protection, LongFreewheelingIsAWrongLockAndIsCounted) {
  auto dut = armed();
  auto in = running();
  in.tick = in.commutate = true;
  in.freewheel = 0x8001;
  EXPECT_TRUE(step(dut, in).freewheel_long);
  EXPECT_EQ(repeat(dut, in, 4).reason, Reason::kWrongLock);
}

TEST(Protection, AThirdOfTheTicksMayLookWrongForGoodButNotHalfOfThem) {
  auto in = running();
  in.tick = true;
  auto third = armed();
  for (int i = 0; i < 300; ++i) {
    in.slips = i % 3 == 2;
    ASSERT_FALSE(step(third, in).lost);
  }
  // Two taken, one given back: the ten that there are last for 17 ticks.
  auto half = armed();
  for (int i = 0; i < 16; ++i) {
    in.slips = i % 2 == 0;
    ASSERT_FALSE(step(half, in).lost);
  }
  in.slips = true;
  EXPECT_EQ(step(half, in).reason, Reason::kWrongLock);
}

TEST(Protection, FaultPinIsFatalInTheSameClockInAnyState) {
  for (const bool run : {false, true}) {
    Protection dut;
    auto in = running();
    in.running = run;
    in.fault_pin = true;
    const auto out = step(dut, in);
    EXPECT_TRUE(out.fatal);
    EXPECT_EQ(out.reason, Reason::kFaultPin);
  }
}

TEST(Protection, ACurrentThatNeverFallsIsFatal) {
  auto dut = armed();
  auto in = running();
  in.running = false;
  in.stuck = 3;
  EXPECT_FALSE(step(dut, in).fatal);
  in.stuck = 4;
  EXPECT_EQ(step(dut, in).reason, Reason::kOverCurrent);
}

TEST(Protection, AnIllegalHallCodeForTwoTicksEndsTheTry) {
  auto dut = armed();
  auto in = running();
  in.tick = in.hall = in.hall_illegal = true;
  EXPECT_FALSE(step(dut, in).lost);
  step(dut, in);
  EXPECT_EQ(step(dut, in).reason, Reason::kHallCode);
}

TEST(Protection, HallCodesMeanNothingWithoutHalls) {
  auto dut = armed();
  auto in = running();
  in.tick = in.hall_illegal = true;
  EXPECT_FALSE(repeat(dut, in, 100).lost);
}

TEST(Protection, ZeroDisablesEachTestThatSaysSo) {
  auto in = running();
  in.config.wrong_lock = 0;
  in.config.over_current = 0;
  auto dut = armed(in);
  in.tick = true;
  in.slips = true;
  in.stuck = 15;
  const auto out = repeat(dut, in, 5000);
  EXPECT_FALSE(out.lost);
  EXPECT_FALSE(out.fatal);
}

}  // namespace
}  // namespace steplock
