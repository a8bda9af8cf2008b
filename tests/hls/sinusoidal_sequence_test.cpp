// The sequence: its order, its times, its retries, and what ends it.

#include "hls/sinusoidal/sinusoidal_sequence.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace steplock {
namespace {

using S = SinusoidalState;
using R = SinusoidalReason;

class Started {
 public:
  SinusoidalSequence::In in{
      .command = {.configured = true, .run = true},
      .measured = true,
      .config = {.pattern = 10, .lock = 5, .give_up = 50, .brake = 7, .retry_delay = 9, .retries = 2}};

  // A PWM period of eight clocks: its start, then a sample worked through.
  SinusoidalSequence::Out period() {
    SinusoidalSequence::Out out;
    for (int clock = 0; clock < 8; ++clock) {
      in.period = clock == 0;
      in.sampled = clock == 5;
      out = dut_.tick(in);
      if (out.entered) entered.push_back(out.state);
    }
    return out;
  }
  // Periods until `state`, at most 1000.
  int until(S state) {
    for (int n = 0; n < 1000; ++n) {
      if (period().state == state) return n;
    }
    return 1000;
  }
  std::vector<S> entered;

 private:
  SinusoidalSequence dut_;
};

// Places that follow each other in the wanted direction: 240, 300 and 0 degrees, or 120, 60 and 0.
TEST(SinusoidalSequence, ThePatternTurnsTheWantedWay) {
  for (const bool reverse : {false, true}) {
    Started s;
    s.in.command.reverse = reverse;
    EXPECT_EQ(s.until(S::kPattern), 0);
    std::vector<std::string> legs;
    std::vector<int> periods;
    auto out = s.period();
    for (; out.hold; out = s.period()) {
      const std::string now = std::string(out.hold_u ? "u" : "") + (out.hold_v ? "v" : "") + (out.hold_w ? "w" : "");
      if (legs.empty() || legs.back() != now) {
        legs.push_back(now);
        periods.push_back(0);
      }
      ++periods.back();
    }
    EXPECT_EQ(legs, reverse ? (std::vector<std::string>{"v", "uv", "u"}) : (std::vector<std::string>{"w", "uw", "u"}));
    for (const int third : periods) EXPECT_NEAR(third, 10, 1);
    EXPECT_EQ(out.state, S::kStarting);
  }
}

TEST(SinusoidalSequence, AStartGoesThroughItsStatesInTheirTimes) {
  Started s;
  s.until(S::kStarting);
  s.in.fast = s.in.plausible = true;
  EXPECT_NEAR(s.until(S::kRun), 5, 1);
  EXPECT_TRUE(s.period().locked);
  EXPECT_EQ(s.entered, (std::vector{S::kCalibrate, S::kPattern, S::kStarting, S::kRun}));
}

// Gates first in the period for which on-times were computed under the loop, the estimator one
// later: only then a whole period of them has been seen.
TEST(SinusoidalSequence, GatesAndEstimatorWaitForOnTimesOfTheLoop) {
  Started s;
  s.in.config.arbitrary = true;
  s.until(S::kStarting);
  auto out = s.period();
  int period = 0, gates = -1, estimator = -1;
  for (; period < 10; ++period, out = s.period()) {
    if (out.modulate && gates < 0) gates = period;
    if (out.estimate && estimator < 0) estimator = period;
    EXPECT_TRUE(out.regulate);
  }
  EXPECT_GE(gates, 0);
  EXPECT_EQ(estimator, gates + 1);
}

TEST(SinusoidalSequence, PilotPulsesTakeThePatternsPlaceUntilTheyFound) {
  Started s;
  s.in.config.pilot = true;
  s.until(S::kPilot);
  for (int n = 0; n < 5; ++n) {
    const auto out = s.period();
    ASSERT_TRUE(out.pilot && out.hold && out.hold_u && !out.hold_v && !out.hold_w && !out.modulate && !out.regulate);
  }
  s.in.found = true;
  EXPECT_TRUE(s.period().regulate);
  EXPECT_EQ(s.entered, (std::vector{S::kCalibrate, S::kPilot, S::kStarting}));
}

TEST(SinusoidalSequence, PilotPulsesThatFindNothingAreAFailedTry) {
  for (const R reason : {R::kNoSaliency, R::kNoPolarity, R::kNoDecay}) {
    Started s;
    s.in.config.pilot = true;
    s.until(S::kPilot);
    if (reason != R::kNoDecay) s.in.failed = reason;
    s.until(S::kRetryDelay);
    EXPECT_EQ(s.period().reason, reason);
    EXPECT_LT(s.until(S::kFault), 1000);
    EXPECT_EQ(s.period().reason, reason);
  }
}

TEST(SinusoidalSequence, OneDoubtfulSampleBeginsTheWaitForLockAnew) {
  Started s;
  s.in.config.arbitrary = true;
  s.until(S::kStarting);
  for (int n = 0; n < 10; ++n) {
    s.in.fast = s.in.plausible = true;
    for (int m = 0; m < 3; ++m) ASSERT_EQ(s.period().state, S::kStarting);
    s.in.plausible = false;
    ASSERT_EQ(s.period().state, S::kStarting);
  }
}

TEST(SinusoidalSequence, WithoutLockItTriesAgainAndThenGivesUp) {
  Started s;
  EXPECT_LT(s.until(S::kFault), 1000);
  EXPECT_EQ(s.period().reason, R::kNoLock);
  int tries = 0, rests = 0;
  for (const S state : s.entered) tries += state == S::kStarting, rests += state == S::kRetryDelay;
  EXPECT_EQ(tries, 3);
  EXPECT_EQ(rests, 2);
  EXPECT_EQ(s.period().state, S::kFault) << "latched";
  s.in.command.clear_fault = true;
  EXPECT_EQ(s.period().state, S::kFault) << "while run is set";
  s.in.command.run = false;
  EXPECT_EQ(s.period().state, S::kIdle);
}

TEST(SinusoidalSequence, AFaultEndsItFromEveryState) {
  for (const bool pin : {true, false}) {
    for (int periods = 0; periods < 60; ++periods) {
      Started s;
      s.in.fast = s.in.plausible = true;
      for (int n = 0; n < periods; ++n) s.period();
      (pin ? s.in.fault_pin : s.in.measured) = true;
      if (!pin) s.in.fatal = R::kOverCurrent;
      const auto out = s.period();
      ASSERT_EQ(out.state, S::kFault);
      ASSERT_EQ(out.reason, pin ? R::kFaultPin : R::kOverCurrent);
      ASSERT_FALSE(out.modulate || out.brake || out.regulate);
    }
  }
}

TEST(SinusoidalSequence, AStopSlowsDownBrakesAndRests) {
  Started s;
  s.in.fast = s.in.plausible = true;
  s.until(S::kRun);
  s.in.command.run = false;
  s.in.command.brake_to_stop = true;
  EXPECT_TRUE(s.period().slow_down);
  s.in.stopping = true;
  EXPECT_TRUE(s.period().brake);
  EXPECT_NEAR(s.until(S::kIdle), 6, 1);
}

TEST(SinusoidalSequence, ASetSpeedOfZeroStopsByBrakingAndAnotherOneStartsAgain) {
  Started s;
  s.in.fast = s.in.plausible = true;
  s.until(S::kRun);
  s.in.still = true;
  EXPECT_TRUE(s.period().slow_down);
  s.in.stopping = true;
  EXPECT_TRUE(s.period().brake);
  EXPECT_NEAR(s.until(S::kIdle), 6, 1);
  for (int n = 0; n < 20; ++n) EXPECT_EQ(s.period().state, S::kIdle);
  s.in.still = s.in.stopping = false;
  EXPECT_LT(s.until(S::kRun), 100);
}

TEST(SinusoidalSequence, AReversalBrakesAndStartsTheOtherWay) {
  Started s;
  s.in.fast = s.in.plausible = true;
  s.until(S::kRun);
  s.in.command.reverse = true;
  EXPECT_EQ(s.period().state, S::kSlowDown);
  EXPECT_FALSE(s.period().reverse) << "still turning forward";
  s.in.stopping = true;
  s.until(S::kStarting);
  EXPECT_TRUE(s.period().reverse);
}

// The guard turns the bridge off at once; what went on would have it turn again when it is configured again.
TEST(SinusoidalSequence, WhatIsNoLongerConfiguredIsIdle) {
  for (const S state : {S::kCalibrate, S::kPattern, S::kStarting, S::kRun, S::kSlowDown, S::kBrake, S::kRetryDelay}) {
    Started s;
    s.in.fast = s.in.plausible = state == S::kRun || state == S::kSlowDown || state == S::kBrake;
    if (state == S::kCalibrate) s.in.measured = false;
    if (state == S::kRetryDelay) s.until(S::kStarting), s.in.failed = R::kEmf;
    if (state == S::kSlowDown || state == S::kBrake) {
      s.until(S::kRun);
      s.in.command = {.configured = true, .brake_to_stop = true};
      s.in.stopping = state == S::kBrake;
    }
    ASSERT_LT(s.until(state), 1000) << int(state);
    s.in.command.configured = false;
    s.in.failed = R::kNone;
    s.period();
    s.in.command.configured = true;
    s.in.command.run = false;
    EXPECT_EQ(s.period().state, S::kIdle) << int(state);
  }
  Started s;
  s.in.fault_pin = true;
  s.until(S::kFault);
  s.in.command.configured = false;
  EXPECT_EQ(s.period().state, S::kFault) << "a latched fault stays";
}

TEST(SinusoidalSequence, WordsThatBecomeValidUnderARunThatIsUpStartNothing) {
  Started s;
  s.in.command = {.run = true};
  s.period();
  s.in.command.configured = true;
  for (int i = 0; i < 10; ++i) ASSERT_EQ(s.period().state, SinusoidalState::kIdle);
  s.in.command.run = false;
  s.period();
  s.in.command.run = true;
  s.period();
  EXPECT_NE(s.period().state, SinusoidalState::kIdle);
}

TEST(SinusoidalSequence, UnconfiguredItNeverStarts) {
  Started s;
  s.in.command.configured = false;
  EXPECT_EQ(s.until(S::kCalibrate), 1000);
}

}  // namespace
}  // namespace steplock
