// The sinusoidal drive's words: near to what was wanted, in their range, and refused where they are not.
#include "model/design/sinusoidal/words.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "testbench/drive_file/drive_file.hpp"

namespace steplock::design::sinusoidal {
namespace {

Settings drive(const std::string& name) {
  return load_drive_file(DRIVES "/" + name + ".toml").settings;
}

// Gains and times hold 7 bits or more.  "Too slow" is a threshold of a few places of the speed.
TEST(SinusoidalWords, EveryDriveThatStartsByPatternHasWordsNearToWhatItWants) {
  for (const char* name : {"m2310p_sinusoidal", "matsui1996", "br2804_sinusoidal"}) {
    const Quantised q = quantise(drive(name));
    EXPECT_TRUE(q.problems.empty()) << name << ": " << q.problems.front();
    for (const WordRow& row : q.rows) {
      const double part = row.name == "speed.slow" ? 0.1 : 0.005;
      EXPECT_LE(std::abs(row.error()), part * std::abs(row.wanted)) << name << ' ' << row.name;
    }
  }
}

// Worked by hand: R T / L, T U / (L I), T U / (2 pi flux), and the target over 1/16 turn per sample.
TEST(SinusoidalWords, TheWordsOfTheServoMotorAreThoseOfItsData) {
  const Words w = quantise(drive("m2310p_sinusoidal")).words;
  EXPECT_EQ(w.bridge.period, 1200u);
  EXPECT_EQ(w.bridge.inverse, 18641u);                                 // 2^26 / 3600
  EXPECT_EQ(w.estimator.decay, std::lround((0.38 + 0.01) * 0.25 * 32768));
  EXPECT_EQ(w.estimator.gain, std::lround(0.25 * 36 / 20 * 8192));
  EXPECT_NEAR(w.estimator.k_speed, 50e-6 * 36 / (2 * 3.14159265 * 6.37e-3) * 131072, 1);
  EXPECT_EQ(w.speed.target, std::lround(200.0 / 20e3 * 16 * 33554432));  // 200 Hz at 20 kHz
}

TEST(SinusoidalWords, DeadTimeIsNeverBelowTheGuardsFloorAndPulsesNeverShorter) {
  Settings s = drive("m2310p_sinusoidal");  // 200 ns, 5 clocks
  Words w = quantise(s).words;
  EXPECT_EQ(w.bridge.dead_time, 12u);
  EXPECT_GE(w.bridge.minimum, w.bridge.dead_time);
  EXPECT_GE(w.bridge.lost, 12u * 16) << "what is lost is the dead time that is really there";
  s.inverter.dead_time_s = 1e-6;
  EXPECT_EQ(quantise(s).words.bridge.dead_time, 24u);
}

TEST(SinusoidalWords, WhatDoesNotFitIsNamedWithItsWord) {
  Settings s = drive("m2310p_sinusoidal");
  s.control.clock_hz = 12e6;  // 600 clocks
  const Quantised q = quantise(s);
  ASSERT_EQ(q.problems.size(), 1u);
  EXPECT_EQ(q.problems.front(), "bridge.inverse needs the word 37283; at most 32767");
}

}  // namespace
}  // namespace steplock::design::sinusoidal
