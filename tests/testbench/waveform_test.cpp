#include "testbench/paper/waveform.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace steplock {
namespace {

// Pulses of `height` and either sign, each a trapezoid with these flanks, 4 ms long, every 6 ms.
std::vector<Sample> pulses(double height, double rise_s, double fall_s) {
  std::vector<Sample> all;
  constexpr double kStep = 1e-6, kPeriod = 6e-3, kLength = 4e-3;
  for (int i = 0; i < 24000; ++i) {
    const double t = i * kStep, in = std::fmod(t, kPeriod);
    const double sign = static_cast<int>(t / kPeriod) % 2 == 0 ? 1 : -1;
    const double up = in / rise_s, down = (kLength - in) / fall_s;
    Sample s;
    s.time = t;
    s.plant.current[1] = sign * height * std::max(0.0, std::min({1.0, up, down}));
    s.plant.torque = 2 + 0.5 * std::sin(2000 * t);
    all.push_back(s);
  }
  return all;
}

TEST(Waveform, ReadsAmplitudeAndEdgesOfAPulse) {
  const Waveform w = waveform(pulses(5, 8e-4, 2e-4), 1e-5, 1);
  EXPECT_NEAR(w.amplitude, 5, 1e-9);
  // The mean height is (4 - 0.5) / 4 of the peak: so 0.8 * 0.875 of each flank.  Averaging over 10 us
  // and samples of 1 us blur each of the four levels by at most one sample.
  EXPECT_NEAR(w.rise_s, 0.8 * 0.875 * 8e-4, 4e-6);
  EXPECT_NEAR(w.fall_s, 0.8 * 0.875 * 2e-4, 4e-6);
}

TEST(Waveform, TorqueRippleIsPeakToPeakOverTheMean) {
  // 24 ms are not whole periods of the ripple; its mean is within 0.5 / (2000 * 0.024) of zero.
  EXPECT_NEAR(waveform(pulses(5, 1e-4, 1e-4), 1e-5, 1).torque_ripple, 0.5, 0.01);
}

TEST(Waveform, OneEmptyPhaseHasNoPulse) {
  const Waveform w = waveform(pulses(5, 1e-4, 1e-4), 1e-5, 0);
  EXPECT_EQ(w.amplitude, 0);
  EXPECT_EQ(w.rise_s, 0);
}

TEST(Averaged, TakesAwayWhatIsAsShortAsTheWindow) {
  std::vector<Point> chopped;
  for (int i = 0; i < 1000; ++i) chopped.push_back({i * 1e-6, 3.0 + (i % 10 < 5 ? 1 : -1)});
  for (const Point& p : averaged(chopped, 10e-6)) EXPECT_NEAR(p.y, 3, 1e-9);
}

TEST(Averaged, KeepsAStraightLine) {
  for (const Point& p : averaged({{0, 0}, {1, 2}, {3, 6}, {4, 8}}, 0.5)) {
    EXPECT_NEAR(p.y, 2 * p.x, 1e-12);
  }
}

}  // namespace
}  // namespace steplock
