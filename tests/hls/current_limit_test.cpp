#include "hls/bridge/current_limit.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <random>

namespace steplock {
namespace {

using In = CurrentLimit::In;

In limit(bool on, bool comparator, int blanking, int off_time) {
  return {.on = on, .comparator = comparator, .config = {.blanking = blanking, .off_time = off_time}};
}

TEST(CurrentLimit, APulseBelowTheLimitPassesUntouchedAndWithoutDelay) {
  CurrentLimit dut;
  for (int i = 0; i < 100; ++i) {
    const bool on = i % 7 < 4;
    ASSERT_EQ(dut.tick(limit(on, false, 3, 20)).on, on);
  }
}

TEST(CurrentLimit, TheComparatorIsHeardAfterTheBlankingAndNotBefore) {
  for (const int blanking : {0, 1, 2, 255}) {
    CurrentLimit dut;
    dut.tick(limit(false, true, blanking, 20));
    int on = 0;
    while (dut.tick(limit(true, true, blanking, 20)).on) ++on;
    // The clock in which it is heard is the last one of the pulse.
    EXPECT_EQ(on, blanking + 1);
  }
}

TEST(CurrentLimit, ACutLastsExactlyTheOffTimeWhateverThePwmDoes) {
  for (const int off_time : {1, 2, 3, 100, 4095}) {
    CurrentLimit dut;
    dut.tick(limit(false, false, 0, off_time));
    dut.tick(limit(true, true, 0, off_time));
    for (int i = 0; i < off_time; ++i) {
      // Even a PWM that goes off and on again does not shorten it.
      const bool pwm = i % 3 != 0 || i == off_time - 1;
      ASSERT_FALSE(dut.tick(limit(pwm, false, 0, off_time)).on) << i;
    }
    EXPECT_TRUE(dut.tick(limit(true, false, 0, off_time)).on);
  }
}

TEST(CurrentLimit, ACutWithAllGatesOffLastsAQuarterOfIt) {
  for (const int off_time : {1, 3, 4, 7, 8, 100, 4095}) {
    CurrentLimit dut;
    In in = limit(true, true, 0, off_time);
    in.fast = true;
    dut.tick(in);
    in.comparator = false;
    int off = 0;
    while (!dut.tick(in).on) ++off;
    EXPECT_EQ(off, std::max(1, off_time / 4)) << off_time;
  }
}

// A current that rises by one in each clock on and falls by one in each clock off, down to nothing; what it reaches at most.
int highest(int blanking, int off_time) {
  CurrentLimit dut;
  In in = limit(true, false, blanking, off_time);
  in.fast = true;
  int current = 0, most = 0;
  for (int i = 0; i < 10000; ++i) {
    in.comparator = current > 500;
    current = std::max(0, current + (dut.tick(in).on ? 1 : -1));
    most = std::max(most, current);
  }
  return most;
}

// From below the limit it rises for the blanking, and for the clock that hears; the cut begins one later.
TEST(CurrentLimit, AFastCutUndoesWhatTheBlankingDid) {
  for (const int blanking : {0, 1, 10, 100}) {
    const int enough = 4 * (blanking + 2);
    EXPECT_LE(highest(blanking, enough), 500 + blanking + 2) << blanking;
  }
  EXPECT_GT(highest(100, 4 * 90), 1000) << "the control: a quarter that is shorter lets it climb";
}

TEST(CurrentLimit, TheHitIsTheFirstClockOfTheOffTime) {
  CurrentLimit dut;
  EXPECT_FALSE(dut.tick(limit(true, true, 0, 5)).hit);
  const auto out = dut.tick(limit(true, true, 0, 5));
  EXPECT_TRUE(out.hit);
  EXPECT_FALSE(out.on);
  EXPECT_FALSE(dut.tick(limit(true, true, 0, 5)).hit);
}

// Off is what the PWM does; cut what the limit does, from its hit on.
TEST(CurrentLimit, ACutIsToldInEachOfItsClocksAndInNoOther) {
  CurrentLimit dut;
  std::mt19937 random(3);
  int left = 0;
  for (int i = 0; i < 10000; ++i) {
    const auto out = dut.tick(limit(random() % 2, random() % 3 == 0, 3, 7));
    if (out.hit) left = 7;
    ASSERT_EQ(out.cut, left > 0) << i;
    ASSERT_FALSE(out.cut && out.on) << i;
    if (left > 0) --left;
  }
}

TEST(CurrentLimit, AfterACutTheSwitchOnIsBlankedAnew) {
  CurrentLimit dut;
  dut.tick(limit(false, false, 10, 5));
  for (int i = 0; i < 11; ++i) ASSERT_TRUE(dut.tick(limit(true, true, 10, 5)).on);
  for (int i = 0; i < 5; ++i) ASSERT_FALSE(dut.tick(limit(true, true, 10, 5)).on);
  for (int i = 0; i < 11; ++i) ASSERT_TRUE(dut.tick(limit(true, true, 10, 5)).on) << i;
  EXPECT_FALSE(dut.tick(limit(true, true, 10, 5)).on);
}

// Quiet are all clocks but the last one of a blanking and of a cut, whatever the PWM does in it; and a pulse below the limit without end.
TEST(CurrentLimit, AllClocksButTheLastOfACountAreQuiet) {
  constexpr std::uint64_t kForEver = ~std::uint64_t{0};
  constexpr int kBlanking = 30, kOffTime = 40;
  CurrentLimit dut;
  dut.tick(limit(false, false, kBlanking, kOffTime));
  EXPECT_EQ(dut.quiet(false), kForEver);
  for (int left = kBlanking; left > 0; --left) {
    ASSERT_EQ(dut.quiet(true), static_cast<std::uint64_t>(left < 2 ? 0 : left - 1)) << left;
    dut.tick(limit(true, false, kBlanking, kOffTime));
  }
  EXPECT_EQ(dut.quiet(true), kForEver);
  dut.tick(limit(true, true, kBlanking, kOffTime));
  for (int left = kOffTime; left > 0; --left) {
    for (const bool on : {true, false}) ASSERT_EQ(dut.quiet(on), static_cast<std::uint64_t>(left < 2 ? 0 : left - 1)) << left;
    dut.tick(limit(left % 3 == 0, false, kBlanking, kOffTime));
  }
  EXPECT_EQ(dut.quiet(false), kForEver);
}

// Where a clock does nothing but count, so many clocks at once are the same as one by one: in a pulse, between two and in a cut.
TEST(CurrentLimit, SkippingItsQuietClocksEqualsTickingThem) {
  int skipped = 0, without_end = 0;
  std::mt19937 random(5);
  CurrentLimit ticked;
  for (int k = 0; k < 4000; ++k) {
    const In in = limit(random() % 4 != 0, false, 30, 40);
    ticked.tick(limit(true, random() % 3 == 0, 30, 40));
    for (unsigned i = random() % 40; i > 0; --i) ticked.tick(in);
    CurrentLimit one = ticked, counted = ticked;
    one.tick(in), counted.skip(in.on, 1);
    const std::uint64_t quiet = ticked.quiet(in.on);
    if (quiet == 0 || one != counted) continue;
    without_end += quiet == ~std::uint64_t{0};
    const std::uint64_t clocks = std::min<std::uint64_t>(quiet, 25);
    CurrentLimit jumped = ticked;
    jumped.skip(in.on, clocks);
    for (std::uint64_t i = 0; i < clocks; ++i) ticked.tick(in);
    ASSERT_EQ(jumped, ticked) << k;
    skipped += int(clocks);
  }
  EXPECT_GT(skipped, 10000);
  EXPECT_GT(without_end, 100) << "a pulse of which the blanking is over, and no pulse";
  EXPECT_LT(without_end, 3000) << "blanking and cuts end";
}

TEST(CurrentLimit, OffTimeZeroDisablesIt) {
  CurrentLimit dut;
  for (int i = 0; i < 100; ++i) {
    const auto out = dut.tick(limit(true, true, 2, 0));
    ASSERT_TRUE(out.on);
    ASSERT_FALSE(out.hit);
  }
}

TEST(CurrentLimit, ACurrentThatNeverFallsIsCountedAndStopsAtFifteen) {
  CurrentLimit dut;
  dut.tick(limit(false, true, 4, 10));
  UInt<4> most = 0;
  for (int i = 0; i < 1000; ++i) {
    const auto out = dut.tick(limit(true, true, 4, 10));
    ASSERT_GE(out.stuck, most);
    most = out.stuck;
    // A cut is complete after 5 clocks on and 10 off.
    ASSERT_EQ(out.stuck, UInt<4>(std::min(i / 15, 15))) << i;
  }
}

// A release counts in its own off-time alone: a motor that ran well before is protected all the same.
TEST(CurrentLimit, WhatFellBeforeTheFirstCutEndsNoCount) {
  CurrentLimit dut;
  for (int i = 0; i < 100; ++i) dut.tick(limit(i % 20 < 10, false, 4, 10));
  UInt<4> stuck = 0;
  for (int i = 0; i < 300; ++i) stuck = dut.tick(limit(true, true, 4, 10)).stuck;
  EXPECT_EQ(stuck, UInt<4>(15));
}

TEST(CurrentLimit, AReleaseInTheOffTimeEndsTheCount) {
  CurrentLimit dut;
  dut.tick(limit(false, true, 4, 10));
  for (int i = 0; i < 50; ++i) dut.tick(limit(true, true, 4, 10));
  ASSERT_EQ(dut.tick(limit(true, true, 4, 10)).stuck, UInt<4>(3));
  UInt<4> stuck = 3;
  for (int i = 51; i < 500; ++i) {
    // Low for one clock in each off-time.
    stuck = dut.tick(limit(true, i % 15 != 12, 4, 10)).stuck;
  }
  EXPECT_EQ(stuck, UInt<4>(0));
}

TEST(CurrentLimit, AQuietComparatorInAPulseEndsTheCount) {
  CurrentLimit dut;
  dut.tick(limit(false, true, 4, 10));
  for (int i = 0; i < 50; ++i) dut.tick(limit(true, true, 4, 10));
  for (int i = 0; i < 20; ++i) dut.tick(limit(true, false, 4, 10));
  EXPECT_EQ(dut.tick(limit(true, false, 4, 10)).stuck, UInt<4>(0));
}

// With the comparator always high a pulse is never longer than the blanking and the clock that hears.
RC_GTEST_PROP(CurrentLimit, NoPulseOutlivesAHighComparator, (std::uint32_t seed)) {
  std::mt19937 random(seed);
  const int blanking = int(random() % 40);
  const int off_time = 1 + int(random() % 60);
  CurrentLimit dut;
  int on = 0;
  int left = 0;
  bool pwm = false;
  for (int clock = 0; clock < 5000; ++clock) {
    if (left-- == 0) {
      pwm = !pwm;
      left = int(random() % 100);
    }
    const auto out = dut.tick(limit(pwm, true, blanking, off_time));
    RC_ASSERT(!out.on || pwm);
    on = out.on ? on + 1 : 0;
    RC_ASSERT(on <= blanking + 1);
  }
}

}  // namespace
}  // namespace steplock
