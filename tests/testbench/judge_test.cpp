#include "testbench/drive/six_step/judge.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace steplock {
namespace {

constexpr double kRad = std::numbers::pi / 180;

// Turns rotor and drive together for some steps; each pattern begins `late` degrees late.
void turn(Judge& judge, int& pattern, double& theta, int steps, bool reverse, double late = 0) {
  for (int i = 0; i < steps; ++i) {
    const int next = (pattern + (reverse ? 5 : 1)) % 6;
    theta += reverse ? -60 : 60;
    judge.commutated((theta + (reverse ? -late : late)) * kRad, pattern, next);
    pattern = next;
  }
}

TEST(Judge, ForwardPatternsBelongWhereThePlantSaysTorqueIsBest) {
  Judge judge;
  judge.commutated((30 + 60 * 2) * kRad, 1, 2);
  EXPECT_NEAR(judge.last_deg(), 0, 1e-9);
}

TEST(Judge, ReversePatternsAreTurnedRoundByThreeSteps) {
  // Pattern 1 in reverse is ideal for theta in [270, 330), entered from above.
  Judge judge;
  judge.commutated(330 * kRad, 2, 1);
  EXPECT_NEAR(judge.last_deg(), 0, 1e-9);
}

TEST(Judge, LatenessIsPositiveInBothDirections) {
  Judge forward, reverse;
  forward.commutated((30 + 7) * kRad, 5, 0);
  reverse.commutated((330 - 7) * kRad, 2, 1);
  EXPECT_NEAR(forward.last_deg(), 7, 1e-9);
  EXPECT_NEAR(reverse.last_deg(), 7, 1e-9);
}

TEST(Judge, PhaseAdvanceMovesTheIdealInstant) {
  Judge judge(10);
  judge.commutated((30 - 10) * kRad, 5, 0);
  EXPECT_NEAR(judge.last_deg(), 0, 1e-9);
}

TEST(Judge, ManyTurnsInStepCountNothing) {
  for (const bool reverse : {false, true}) {
    Judge judge;
    int pattern = reverse ? 2 : 5;
    double theta = reverse ? 390 : -30;
    turn(judge, pattern, theta, 600, reverse, 12);
    EXPECT_EQ(judge.step_outs(), 0u);
    EXPECT_EQ(judge.commutations(), 600u);
    EXPECT_NEAR(judge.sum() / 600, 12, 1e-9);
  }
}

// The negative control: a rotor that is pushed back by one, two, ... whole steps is seen each time.
TEST(Judge, ASlippedStepCountsOnce) {
  Judge judge;
  int pattern = 5;
  double theta = -30;
  turn(judge, pattern, theta, 12, false);
  theta -= 61;
  turn(judge, pattern, theta, 12, false);
  EXPECT_EQ(judge.step_outs(), 1u);
}

TEST(Judge, AStalledRotorCountsEveryStepThatTheDriveTurnsOn) {
  Judge judge;
  int pattern = 5;
  double theta = -30;
  turn(judge, pattern, theta, 6, false);
  for (int i = 0; i < 12; ++i) {
    const int next = (pattern + 1) % 6;
    judge.commutated(theta * kRad, pattern, next);
    pattern = next;
  }
  // The first step is only in doubt, at exactly 60 degrees; the others count.
  EXPECT_GE(judge.step_outs(), 11u);
  EXPECT_LE(judge.step_outs(), 12u);
}

TEST(Judge, ALockThatBeginsAStepAwayCounts) {
  Judge judge;
  judge.commutated((30 + 95) * kRad, 5, 0);
  judge.commutated((90 + 95) * kRad, 0, 1);
  EXPECT_EQ(judge.step_outs(), 2u);
}

// Caught while its divider stood one step ahead: down to the rotor's step once, then up with the rotor.
TEST(Judge, TheStepThatACaughtRotorIsTakenOverInIsNoSlip) {
  Judge judge;
  int pattern = 0;
  judge.commutated(10 * kRad, 1, 0);
  double theta = 30;
  turn(judge, pattern, theta, 60, false);
  EXPECT_EQ(judge.step_outs(), 0u);
}

TEST(Judge, AfterReleaseTheNextLockIsJudgedAfresh) {
  Judge judge;
  judge.commutated(30 * kRad, 5, 0);
  judge.released();
  judge.commutated((90 + 360 * 7 + 3) * kRad, 0, 1);
  EXPECT_EQ(judge.step_outs(), 0u);
  EXPECT_NEAR(judge.last_deg(), 3, 1e-6);
}

}  // namespace
}  // namespace steplock
