// Defaults that do not fit a motor are fitted, named, and only where the file is silent.
#include "testbench/drive_file/fitted_defaults.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "model/design/design.hpp"
#include "testbench/drive_file/drive_file.hpp"

namespace steplock {
namespace {

using testing::StartsWith;

// 10 V, 5 A: 0.05 ohm takes 0.25 V of it.
design::Settings motor(double rpm) {
  design::Settings s;
  s.motor.pole_pairs = 5;
  s.scenario.speed_rpm = rpm;
  s.inverter.bus_v = 10;
  s.sensors.limit_a = 5;
  return s;
}

std::vector<std::string> fitted(design::Settings& s, Lines lines = {}) {
  fit_defaults(s, lines);
  for (const std::string& a : s.drive.assumed) EXPECT_TRUE(lines.contains(a.substr(0, a.find(':')))) << a;
  return s.drive.assumed;
}

TEST(FittedDefaults, AnOrdinaryMotorKeepsThem) {
  const design::Settings usual;
  design::Settings s = motor(10'000);  // a step of 200 us
  EXPECT_TRUE((fitted(s)).empty());
  EXPECT_EQ(s.control.pwm_hz, usual.control.pwm_hz);
  EXPECT_EQ(s.control.blanking_s, usual.control.blanking_s);
  EXPECT_EQ(s.inverter.bus_resistance_ohm, usual.inverter.bus_resistance_ohm);
}

TEST(FittedDefaults, AFastOneLooksMoreOften) {
  design::Settings s = motor(100'000);  // a step of 20 us
  s.control.clock_hz = 48e6;
  const auto named = fitted(s);
  EXPECT_EQ(named.size(), 4u);
  EXPECT_DOUBLE_EQ(s.control.limit_blanking_s, 1e-6);
  EXPECT_DOUBLE_EQ(s.control.pwm_hz, 35e3);                 // 0.7 of a period in a step
  EXPECT_NEAR(s.control.sample_every_s, 2e-6 / 6, 1e-12);   // of 12 us 2
  EXPECT_GT(s.control.blanking_s, s.inverter.dead_time_s + s.sensors.comparator_delay_s);
  EXPECT_EQ(s.inverter.dead_time_s, design::Settings().inverter.dead_time_s);  // the bridge's
  EXPECT_LT(s.control.blanking_s + s.control.samples * s.control.sample_every_s, 0.36 * 20e-6);
  design::Settings faster = motor(200'000);
  fitted(faster);
  EXPECT_DOUBLE_EQ(faster.control.pwm_hz, 50e3);
  EXPECT_DOUBLE_EQ(faster.control.sample_every_s, 0.2e-6);
}

TEST(FittedDefaults, WhatTheFileSaysStays) {
  design::Settings s = motor(100'000);
  EXPECT_TRUE((fitted(s, {{"control.samples", 3}, {"control.pwm_hz", 4}, {"control.limit_blanking_s", 5}})).empty());
  s = motor(100'000);
  s.sensors.limit_a = 100;
  const Lines all = {{"control.blanking_s", 3}, {"control.pwm_hz", 4}, {"control.limit_blanking_s", 5}, {"inverter.bus_resistance_ohm", 6}};
  EXPECT_TRUE(fitted(s, all).empty());
}

TEST(FittedDefaults, TheBusGivesTheLimitsCurrent) {
  design::Settings s = motor(10'000);
  s.sensors.limit_a = 100;  // 5 V of 10
  const auto named = fitted(s);
  ASSERT_EQ(named.size(), 1u);
  EXPECT_THAT(named[0], StartsWith("inverter.bus_resistance_ohm: 0.01 ohm, estimated: "));
  EXPECT_DOUBLE_EQ(s.inverter.bus_resistance_ohm, 0.01);
}

// Also of a file whose inertia is estimated.
TEST(FittedDefaults, AFileSaysSo) {
  const design::Settings s = load_drive_file(STEPLOCK_DRIVES "/data_sheets/traxxas_3500.toml").settings;
  EXPECT_NEAR(s.inverter.bus_resistance_ohm * s.sensors.limit_a, 0.1 * s.inverter.bus_v, 1e-9);
  EXPECT_EQ(std::ranges::count_if(s.drive.assumed, [](const std::string& a) { return a.starts_with("inverter.bus_resistance_ohm: "); }), 1);
}

TEST(FittedDefaults, HallSensorsNeedNoComparators) {
  design::Settings s = motor(100'000);
  s.control.source = design::Source::kHall;
  EXPECT_TRUE((fitted(s)).empty());
}

// What no default fits, or the file says itself, is refused with what does.
TEST(FittedDefaults, ASetSpeedThatTheComparatorsDoNotFollowIsRefusedWithTheHighestThatTheyDo) {
  design::Settings s = load_drive_file(STEPLOCK_DRIVES "/data_sheets/cubemars_ri20.toml").settings;
  EXPECT_TRUE((design::problems(s)).empty());
  const double step = 10 / (s.scenario.speed_rpm * s.motor.pole_pairs);
  s.control.sample_every_s = 0.1 * step;
  // Another rule may speak beside it.
  const auto refused = [&] {
    for (const std::string& f : design::problems(s)) {
      if (f.starts_with("scenario.speed_rpm is ") && f.find("control.blanking_s") != f.npos) return f;
    }
    return std::string();
  };
  const std::string text = refused();
  ASSERT_THAT(text, StartsWith("scenario.speed_rpm is 5700 rpm, a step of"));
  s.scenario.speed_rpm = 0.999 * std::stod(text.substr(text.rfind(' ')));
  EXPECT_EQ(refused(), "");
  s.scenario.speed_rpm *= 1.002;
  EXPECT_NE(refused(), "");
}

TEST(FittedDefaults, ASetSpeedBeyondTheClockIsRefusedWithTheClockThatServesIt) {
  design::Settings s = load_drive_file(STEPLOCK_DRIVES "/../tests/testbench/million_erpm.toml").settings;
  EXPECT_TRUE((design::problems(s)).empty());
  s.control.clock_hz = 12e6;
  const auto found = design::problems(s);
  const auto slow = std::ranges::find_if(found, [](const std::string& f) { return f.find("raise control.clock_hz to ") != f.npos; });
  ASSERT_NE(slow, found.end());
  EXPECT_NEAR(std::stod(slow->substr(slow->find("clock_hz to ") + 12)), 170 * 502000.0 * 2 / 10, 1e4);
}

}  // namespace
}  // namespace steplock
