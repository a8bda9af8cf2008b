// Patterns against the motor's own torque, and the gate guard.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "model/reference/commutation.hpp"

namespace steplock::reference {
namespace {

constexpr double kThird = 2 * std::numbers::pi / 3;

// Torque per ampere and flux, with sinusoidal back-EMF: current in at the high, out at the low
// phase.
double torque(int step, double theta) {
  return std::sin(theta - kHigh[step] * kThird) - std::sin(theta - kLow[step] * kThird);
}

TEST(ReferenceCommutation, EachStepGivesMostTorqueInItsOwnSector) {
  for (int step = 0; step < 6; ++step) {
    const double middle = (60 + 60 * step) * std::numbers::pi / 180;
    for (int other = 0; other < 6; ++other) {
      if (other == step) continue;
      EXPECT_GT(torque(step, middle), torque(other, middle) + 0.1);
    }
  }
}

TEST(ReferenceCommutation, InReverseThePatternThreeStepsOnGivesMostNegativeTorque) {
  for (int k = 0; k < 6; ++k) {
    const double middle = (60 + 60 * k) * std::numbers::pi / 180;
    EXPECT_NEAR(torque((k + 3) % 6, middle), -torque(k, middle), 1e-12);
  }
}

TEST(ReferenceCommutation, TheFloatingPhasesBackEmfCrossesInTheMiddleOfTheStep) {
  for (int step = 0; step < 6; ++step) {
    const double middle = (60 + 60 * step) * std::numbers::pi / 180;
    const double slope = std::cos(middle - kFloating[step] * kThird);
    EXPECT_NEAR(std::sin(middle - kFloating[step] * kThird), 0, 1e-12);
    EXPECT_EQ(slope > 0, step % 2 == 1) << step;
  }
}

TEST(ReferenceCommutation, BothSwitchesOfALegAreNeverWanted) {
  for (const Mode mode : {Mode::kOff, Mode::kDrive, Mode::kPreAlign, Mode::kAlign, Mode::kBrake}) {
    for (int step = 0; step < 6; ++step) {
      for (const bool chop : {false, true}) {
        for (const bool complementary : {false, true}) {
          const auto g = gates_wanted(mode, step, chop, complementary);
          for (int leg = 0; leg < 3; ++leg) EXPECT_FALSE(g[2 * leg] && g[2 * leg + 1]);
        }
      }
    }
  }
}

TEST(ReferenceCommutation, ResetPullsToUAndVAgainstW) {
  const auto g = gates_wanted(Mode::kAlign, 0, true, false);
  EXPECT_EQ(g, (Gates{true, false, true, false, false, true}));
}

TEST(ReferenceGateGuard, KeepsDeadTimeAndNeverShorts) {
  GateGuard guard({.period = 1, .minimum = 0, .dead_time = 1e-6});
  std::mt19937 random(1);
  std::array<double, 6> went_off;
  went_off.fill(-1);
  Gates before = {};
  for (double t = 0; t < 2e-3; t += 0.3e-6) {
    Gates wanted;
    for (auto& g : wanted) g = random() % 2;
    guard.update(t, wanted, random() % 16 != 0);
    const auto& now = guard.gates();
    for (int gate = 0; gate < 6; ++gate) {
      if (before[gate] && !now[gate]) went_off[gate] = t;
      ASSERT_FALSE(now[gate] && now[gate ^ 1]);
      if (now[gate] && !before[gate]) {
        ASSERT_GE(t - went_off[gate ^ 1], 1e-6 * (1 - 1e-9));
      }
    }
    before = now;
  }
}

// As hls/bridge/guarded_leg.hpp, which does not know how long a gate has been off.
TEST(ReferenceGateGuard, ARequestWaitsForItsDeadTimeAfterALongPause) {
  GateGuard guard({.period = 1, .minimum = 0, .dead_time = 1e-6});
  guard.update(1, {true}, true);
  EXPECT_FALSE(guard.gates()[0]);
  EXPECT_NEAR(guard.next(), 1 + 1e-6, 1e-12);
  guard.update(1 + 1.1e-6, {true}, true);
  EXPECT_TRUE(guard.gates()[0]);
}

TEST(ReferenceGateGuard, OpensAllGatesAtOnceWhenDisabled) {
  GateGuard guard({.period = 1, .minimum = 1e-3, .dead_time = 1e-6});
  guard.update(1, {true, false, false, true, false, false}, true);
  guard.update(1 + 2e-6, {true, false, false, true, false, false}, true);
  EXPECT_TRUE(guard.gates()[0]);
  guard.update(1 + 3e-6, {true, false, false, true, false, false}, false);
  EXPECT_EQ(guard.gates(), Gates{});
}

TEST(ReferenceGateGuard, HoldsAGateForItsMinimumTime) {
  GateGuard guard({.period = 1, .minimum = 2e-6, .dead_time = 1e-6});
  guard.update(1, {true}, true);
  guard.update(guard.next(), {true}, true);
  guard.update(1 + 1.5e-6, {}, true);
  EXPECT_TRUE(guard.gates()[0]);
  EXPECT_NEAR(guard.next(), 1 + 3e-6, 1e-12);
  guard.update(guard.next(), {}, true);
  EXPECT_FALSE(guard.gates()[0]);
}

}  // namespace
}  // namespace steplock::reference
