#include "model/design/ramp_overshoot.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace steplock::design {
namespace {

// The same loop, step by step.
double integrated(const SpeedLoop& loop, double rise) {
  const double slowest = std::min(loop.pole + loop.kp * loop.gain, std::sqrt(loop.ki * loop.gain));
  const double end = rise + 20 / slowest, dt = 2e-4 * std::min(rise, 1 / slowest);
  double speed = 0, integral = 0, most = 0;
  for (double t = 0; t < end; t += dt) {
    const double error = std::min(t, rise) - speed;
    integral += loop.ki * error * dt;
    speed += (loop.gain * (integral + loop.kp * error) - loop.pole * speed) * dt;
    if (t > rise) most = std::max(most, speed - rise);
  }
  return most;
}

TEST(RampOvershoot, NoRampPassesByMoreAndOnePassesByAsMuch) {
  constexpr double kCoarse = 0.01;  // of it: so many places are looked at
  for (const double pole : {0.5, 5.0, 50.0}) {
    for (const double kp : {0.0, 0.05, 0.5}) {
      const SpeedLoop loop{.gain = 100, .pole = pole, .kp = kp, .ki = 1};
      const double bound = ramp_overshoot(loop);
      double most = 0;
      for (double rise = 0.05; rise < 3; rise *= 1.05) {
        const double passed = integrated(loop, rise);
        EXPECT_NEAR(ramp_overshoot(loop, rise), passed, kCoarse * bound + 1e-6) << pole << " " << kp << " " << rise;
        most = std::max(most, passed);
      }
      EXPECT_LE(most, bound * (1 + kCoarse) + 1e-6) << pole << " " << kp;
      EXPECT_GE(most, bound * (1 - 2 * kCoarse) - 1e-6) << pole << " " << kp;
    }
  }
}

TEST(RampOvershoot, NothingPassesWithoutAnIntegralsHaste) {
  EXPECT_NEAR(ramp_overshoot({.gain = 100, .pole = 5, .kp = 0.2, .ki = 1e-3}), 0, 1e-4);
}

// With nothing that damps, begin and end of a ramp of half a period add up.
TEST(RampOvershoot, IsTwiceTheSlopeOverTheNaturalFrequencyAtMost) {
  EXPECT_NEAR(ramp_overshoot({.gain = 100, .pole = 1e-6, .kp = 0, .ki = 1}), 0.2, 1e-4);
}

// Every ramp beyond the one that is found is too steep for one of them, or is not followed; and that one is none of these.
TEST(SteepestRamp, IsTheSteepestAtWhoseEndNoneThatFollowsPassesByMore) {
  constexpr double kRise = 10, kPasses = 0.5, kMost = 100;
  std::vector<RampedLoop> loops;
  for (const double gain : {2.0, 8.0, 32.0}) {
    for (const double pole : {0.1, 1.0}) loops.push_back({{.gain = gain, .pole = pole, .kp = 0.1, .ki = 1}, 10 * gain});
  }
  const auto passes = [&](double slew) {
    double most = 0;
    for (const auto& l : loops) {
      if (slew < l.limit) most = std::max(most, integrated(l.loop, kRise / slew) * slew);
    }
    return most;
  };
  const double slew = steepest_ramp(loops, kRise, kPasses, kMost);
  EXPECT_LE(passes(slew), 1.01 * kPasses);
  EXPECT_LT(slew, kMost);
  for (double steeper = slew / 0.97; steeper < kMost; steeper /= 0.97) EXPECT_GT(passes(steeper), 0.99 * kPasses) << steeper;
  EXPECT_EQ(steepest_ramp(loops, kRise, 100 * kPasses, kMost), kMost) << "nothing asks for less";
  EXPECT_GE(slew, steepest_ramp(loops, 1e9, kPasses, kMost)) << "a ramp without end is the worst";
}

TEST(LoadRebound, IsWhatTheLoopStepByStepPassesBy) {
  constexpr double kCoarse = 0.01;
  for (const double pole : {0.5, 5.0, 50.0}) {
    for (const double kp : {0.0, 0.05, 0.5}) {
      const SpeedLoop loop{.gain = 100, .pole = pole, .kp = kp, .ki = 1};
      const double end = 20 / std::min(loop.pole + loop.kp * loop.gain, std::sqrt(loop.ki * loop.gain)), dt = 1e-6 * end;
      double speed = 0, integral = 0, most = 0;  // both from where they hold the target without load
      for (double t = 0; t < end; t += dt) {
        integral -= loop.ki * speed * dt;
        speed += (loop.gain * (integral - loop.kp * speed) - loop.pole * speed - 1) * dt;
        most = std::max(most, speed);
      }
      EXPECT_NEAR(load_rebound(loop), most, kCoarse * most + 1e-6) << pole << " " << kp;
    }
  }
}

TEST(LoadRebound, IsTheDipWhereNothingDamps) {
  EXPECT_NEAR(load_rebound({.gain = 100, .pole = 1e-6, .kp = 0, .ki = 1}), 0.1, 1e-4);
}

}  // namespace
}  // namespace steplock::design
