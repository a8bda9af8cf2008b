// The sinusoidal drive's words: near to what was wanted, in their range, and refused where they are not.
#include "model/design/sinusoidal/config.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "testbench/drive_file/drive_file.hpp"

namespace steplock::design::sinusoidal {
namespace {

Settings drive(const std::string& name) {
  return load_drive_file(DRIVES "/" + name + ".toml").settings;
}

// Gains and times hold 7 bits or more.  "Too slow" is a threshold of a few places of the speed.
TEST(SinusoidalConfig, EveryDriveHasWordsNearToWhatItWants) {
  for (const char* name : {"m2310p_sinusoidal", "matsui1996", "br2804_sinusoidal", "ipm_2k2"}) {
    const Quantised q = quantise(drive(name));
    EXPECT_TRUE(q.problems.empty()) << name << ": " << q.problems.front();
    for (const WordRow& row : q.rows) {
      const double part = row.name == "speed.slow" ? 0.1 : 0.005;
      EXPECT_LE(std::abs(row.error()), part * std::abs(row.wanted)) << name << ' ' << row.name;
    }
  }
}

// Worked by hand: R T / L, T U / (L I), T U / (2 pi flux), and the target over 1/16 turn per sample.
TEST(SinusoidalConfig, TheWordsOfTheServoMotorAreThoseOfItsData) {
  const Config w = quantise(drive("m2310p_sinusoidal")).config;
  EXPECT_EQ(w["bridge.period"], 1200u);
  EXPECT_EQ(w["bridge.reciprocal"], 9321u);                                  // 2^25 / 3600
  EXPECT_EQ(w["estimator.decay"], std::lround((0.38 + 0.01) * 0.25 * 32768));
  EXPECT_EQ(w["estimator.gain"], std::lround(0.25 * 36 / 20 * 8192));
  EXPECT_NEAR(w["estimator.k_speed"], 50e-6 * 36 / (2 * 3.14159265 * 6.37e-3) * 131072, 1);
  EXPECT_EQ(w["speed.target"], std::lround(200.0 / 20e3 * 16 * 33554432));  // 200 Hz at 20 kHz
}

// 0.3 of 6.1 A through 42.2 mH at 360 V take 214 us: three periods of 100 us, 0.71 of each on.
TEST(SinusoidalConfig, ThePilotPulsesOfTheSalientMotorAreThoseOfItsData) {
  const Config w = quantise(drive("ipm_2k2")).config;
  const double mean = 2 / (1 / 36e-3 + 1 / 51e-3), length = 0.3 * 6.1 * mean / 360;
  EXPECT_TRUE(w["sequence.pilot"]);
  EXPECT_EQ(w["pilot.short_periods"], 3u);
  EXPECT_EQ(w["pilot.long_periods"], 12u) << "four times the current";
  EXPECT_EQ(w["sequence.hold_voltage"], std::lround((length / 300e-6 + 0.02) * 540 / 800 * 32768));
  EXPECT_EQ(w["pilot.saliency"], std::lround(0.03 * 12 * 0.3 * 6.1 / 20 * 32768));
  EXPECT_FALSE(quantise(drive("matsui1996")).config["sequence.pilot"]);
}

TEST(SinusoidalConfig, PilotPulsesThatTheBlocksCannotGiveAreRefused) {
  const auto refusal = [](auto&& change) {
    Settings s = drive("ipm_2k2");
    change(s.sinusoidal_start);
    const Quantised q = quantise(s);
    return q.problems.empty() ? "accepted" : q.problems.front();
  };
  EXPECT_EQ(refusal([](auto&) {}), "accepted");
  EXPECT_EQ(refusal([](auto& t) { t.pilot_repeats = 3; }),
            "sinusoidal_start.pilot_repeats is 3; must be even for this engine");
  EXPECT_EQ(refusal([](auto& t) { t.pilot_repeats = 30; }),
            "sinusoidal_start.pilot_repeats is 30; must be at most 14 for this engine, whose sum has the ADC's range");
  EXPECT_EQ(refusal([](auto& t) { t.pilot_short_s = 3e-6; }),
            "sinusoidal_start.pilot_short_s is 3e-06 s; must be at least 4e-06 s, twice the dead time and the shortest pulse");
}

TEST(SinusoidalConfig, DeadTimeIsNeverBelowTheGuardsFloorAndPulsesNeverShorter) {
  Settings s = drive("m2310p_sinusoidal");  // 200 ns, 5 clocks
  Config w = quantise(s).config;
  EXPECT_EQ(w["bridge.dead_time"], 12u);
  EXPECT_GE(w["bridge.minimum"], w["bridge.dead_time"]);
  EXPECT_GE(w["bridge.dead_time_loss"], 12u * 16) << "what is lost is the dead time that is really there";
  s.inverter.dead_time_s = 1e-6;
  EXPECT_EQ(quantise(s).config["bridge.dead_time"], 24u);
}

TEST(SinusoidalConfig, WhatDoesNotFitIsNamedWithItsWord) {
  Settings s = drive("m2310p_sinusoidal");
  s.motor.inductance_h *= 20;
  const Quantised q = quantise(s);
  ASSERT_FALSE(q.problems.empty());
  EXPECT_EQ(q.problems.front(), "estimator.k_theta needs the word 65497; at most 32767");
}

TEST(SinusoidalConfig, APwmPeriodTakesASampleAtLeast) {
  Settings s = drive("m2310p_sinusoidal");
  s.control.pwm_hz = 50e3;
  EXPECT_TRUE(quantise(s).problems.empty());
  s.control.clock_hz = 23.8e6;
  EXPECT_EQ(quantise(s).problems,
            std::vector<std::string>{"control.pwm_hz is 50000 Hz; must be at most 49895.2 Hz for "
                                     "this engine, which takes 477 clocks a sample"});
}

}  // namespace
}  // namespace steplock::design::sinusoidal
