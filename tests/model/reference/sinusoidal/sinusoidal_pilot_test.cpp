#include "model/reference/sinusoidal/pilot.hpp"

#include <gtest/gtest.h>

namespace steplock::reference::sinusoidal {
namespace {

// Peaks by Eq. (22).
Phases peaks(double theta, double mean = 2, double swing = 0.3) {
  Phases p;
  for (int k = 0; k < 3; ++k) p[k] = mean + swing * std::cos(2 * theta - 4 * kPi / 3 * k);
  return p;
}

TEST(SinusoidalPilot, TheArctangentInvertsEquation22Exactly) {
  for (double theta = -1.57; theta < 1.57; theta += 0.01) {
    const Axis axis = pilot_axis(peaks(theta));
    EXPECT_NEAR(axis.angle, theta, 1e-12);
    EXPECT_NEAR(axis.saliency, 0.15, 1e-12);
  }
}

// Table II: the signs of the three deviations name the domain of 30 degrees that the angle lies in.
TEST(SinusoidalPilot, TheSignsAreThoseOfTableII) {
  const std::string table[6] = {"+--", "++-", "-+-", "-++", "--+", "+-+"};
  const std::string of_paper[6] = {"+--", "+-+", "--+", "-++", "-+-", "++-"};  // from -15 degrees on
  for (int row = 0; row < 6; ++row) {
    for (const double within : {-14.0, 0.0, 14.0}) {
      const double theta = (30 * row + within) * kPi / 180;
      const Phases p = peaks(theta);
      std::string signs;
      for (const double x : p) signs += x > 2 ? '+' : '-';
      EXPECT_EQ(signs, of_paper[row]) << row << ' ' << within;
      // Eq. (24) in the first row: theta = tan(2 theta) / 2, right to 1.5 degrees at the edge.
      if (row == 0) {
        const double eq24 = std::sqrt(3) * (p[2] - p[1]) / (2 * (2 * p[0] - p[1] - p[2]));
        EXPECT_NEAR(eq24, theta, 1.6 * kPi / 180);
      }
    }
  }
  EXPECT_NE(table[1], of_paper[1]);  // v before w would be the other direction of rotation
}

TEST(SinusoidalPilot, TheNearestPatternPointsWithin30Degrees) {
  for (double theta = -9; theta < 9; theta += 0.05) {
    const int p = nearest_pattern(theta);
    const double direction = p % 3 * 2 * kPi / 3 + (p < 3 ? 0 : kPi);
    EXPECT_LE(std::abs(wrapped(theta - direction)), kPi / 6 + 1e-9) << theta;
  }
}

// Currents by Eq. (22) with an odd part, as iron makes it: greater where the pulse strengthens.
PilotPulses::Result search(double theta, double swing, double odd, double& found) {
  const design::sinusoidal::Pilot p{.short_s = 1e-4, .long_s = 5e-4, .decayed = 0.01, .decay_s = 0.1,
                                    .repeats = 2, .least_saliency = 0.03, .least_polarity = 0.02};
  PilotPulses pulses(p);
  pulses.start(0);
  double t = 0;
  for (int n = 0; n < 1000 && pulses.result() == PilotPulses::Result::kNone; ++n) {
    if (pulses.pulsing()) {
      t = pulses.pulse_end();
      const int k = pulses.pattern() % 3;
      const double sign = pulses.pattern() < 3 ? 1 : -1;
      const double along = sign * std::cos(theta - 2 * kPi / 3 * k);
      Phases i = {};
      i[k] = sign * (peaks(theta, 2, swing)[k] + odd * along * along * along);
      pulses.end_pulse(t);
      pulses.peak(i);
    } else {
      pulses.wait(t += 1e-4, {});
    }
  }
  found = pulses.angle();
  return pulses.result();
}

TEST(SinusoidalPilot, PolarityIsRightAndTheOddPartCancelsAllRound) {
  for (int n = 0; n < 64; ++n) {
    const double theta = wrapped(n * kPi / 32 + 0.01);
    double found;
    ASSERT_EQ(search(theta, 0.3, 0.2, found), PilotPulses::Result::kFound);
    EXPECT_NEAR(wrapped(found - theta), 0, 1e-9) << n;
  }
}

TEST(SinusoidalPilot, WhatCannotBeToldIsSaid) {
  double found;
  EXPECT_EQ(search(0.5, 0.3, 0, found), PilotPulses::Result::kNoPolarity);
  EXPECT_EQ(search(0.5, 0.02, 0.2, found), PilotPulses::Result::kNoSaliency);
}

TEST(SinusoidalPilot, ACurrentThatDoesNotDecayEndsTheSearch) {
  PilotPulses pulses({.short_s = 1e-4, .long_s = 5e-4, .decayed = 0.01, .decay_s = 0.01, .repeats = 1});
  pulses.start(0);
  pulses.end_pulse(1e-4);
  pulses.peak({1, -0.5, -0.5});
  for (double t = 2e-4; t < 9e-3; t += 1e-4) {
    pulses.wait(t, {0.5, 0, -0.5});
    ASSERT_FALSE(pulses.pulsing());  // the next pulse waits
    ASSERT_EQ(pulses.result(), PilotPulses::Result::kNone);
  }
  pulses.wait(0.02, {0.5, 0, -0.5});
  EXPECT_EQ(pulses.result(), PilotPulses::Result::kNoDecay);
}

}  // namespace
}  // namespace steplock::reference::sinusoidal
