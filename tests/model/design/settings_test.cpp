// The table of keys and the checks behind it.
#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "model/design/design.hpp"
#include "model/design/settings_keys.hpp"
#include "testbench/drive_file/drive_file.hpp"

namespace steplock::design {
namespace {

Settings servo() { return load_drive_file(std::string(DRIVES) + "/m2310p_servo.toml").settings; }

// The one line that a fault in `change` must cause, or what came instead.
template <class Change>
std::string only_problem(Change change) {
  Settings s = servo();
  change(s);
  std::string all;
  for (const auto& line : problems(s)) all += line + "\n";
  return all;
}

TEST(Settings, EveryKeyStandsOnceInTheTable) {
  Settings s;
  std::set<std::string> names;
  for_each_key(s, [&](const Key& key, auto&) {
    EXPECT_TRUE(names.insert(std::string(key.section) + "." + std::string(key.name)).second)
        << key.section << "." << key.name;
    EXPECT_FALSE(key.about.empty());
  });
  EXPECT_GT(names.size(), 100u);
}

TEST(Settings, DefaultsLieWithinTheirRanges) {
  Settings s;
  for_each_key(s, [&](const Key& key, auto& value) {
    using Value = std::decay_t<decltype(value)>;
    if constexpr (std::is_same_v<Value, double> || std::is_same_v<Value, int>) {
      if (key.required) return;
      EXPECT_GE(value, key.low) << key.section << "." << key.name;
      EXPECT_LE(value, key.high) << key.section << "." << key.name;
    }
  });
}

TEST(Settings, OfEveryDriveFileMakeSense) {
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(DRIVES)) {
    if (entry.path().extension() != ".toml") continue;
    ++files;
    for (const auto& line : problems(load_drive_file(entry.path().string()).settings)) {
      ADD_FAILURE() << entry.path().filename() << ": " << line;
    }
  }
  EXPECT_GE(files, 8);
}

TEST(Settings, EveryAssumptionNamesAKeyAndAReason) {
  EXPECT_NE(only_problem([](Settings& s) {
              s.drive.assumed = {"motor.mass_kg: heavy"};
            }).find("motor.mass_kg"),
            std::string::npos);
  EXPECT_NE(only_problem([](Settings& s) { s.drive.assumed = {"motor.flux_vs"}; }).find("reason"),
            std::string::npos);
}

TEST(Settings, AbsurdValuesAreNamedByTheirKey) {
  using S = Settings&;
  const auto names = [](const std::string& line, const char* key) {
    return line.rfind(key, 0) == 0 && line.find("must") != std::string::npos;
  };
  EXPECT_TRUE(names(only_problem([](S s) { s.motor.flux_vs = 0; }), "motor.flux_vs"));
  EXPECT_TRUE(
      names(only_problem([](S s) { s.control.blanking_s = 0.5e-6; }), "control.blanking_s"));
  EXPECT_TRUE(names(only_problem([](S s) { s.control.blanking_s = 10e-6; }), "control.blanking_s"));
  EXPECT_TRUE(names(only_problem([](S s) {
                      s.control.pwm_hz = 200e3;
                      s.control.blanking_s = 1.24e-6;
                    }),
                    "control.pwm_hz"));
  EXPECT_TRUE(names(only_problem([](S s) { s.scenario.speed_rpm = 9000; }), "scenario.speed_rpm"));
  EXPECT_TRUE(
      names(only_problem([](S s) { s.start.hand_over_rpm = 2900; }), "start.hand_over_rpm"));
  EXPECT_TRUE(
      names(only_problem([](S s) {
                      s.start.start_current_a = 0.05;
                      s.start.align_current_a = 2;
                    }),
                    "start.start_current_a"));
  EXPECT_TRUE(
      names(only_problem([](S s) {
                      s.start.method = Method::kRamp;  // the follower's current is the limit's
                      s.start.start_current_a = 20;
                      s.start.align_current_a = 2;
                    }),
                    "start.start_current_a"));
  EXPECT_TRUE(names(only_problem([](S s) { s.scenario.stop_s = 7; }), "scenario.stop_s"));
  EXPECT_TRUE(names(only_problem([](S s) { s.scenario.load_off_s = 0.1; }), "scenario.load_off_s"));
  EXPECT_TRUE(names(only_problem([](S s) { s.motor.static_nm = 1e-3; }), "motor.static_nm"));
  EXPECT_TRUE(names(only_problem([](S s) { s.speed.maximum_duty = 0.01; }), "speed.minimum_duty"));
  EXPECT_TRUE(names(only_problem([](S s) { s.loop.maximum_rpm = 3001; }), "loop.maximum_rpm"));
  EXPECT_TRUE(names(only_problem([](S s) { s.scenario.inertia_step_s = 7; }), "scenario.inertia_step_s"));
  EXPECT_TRUE(names(only_problem([](S s) { s.hardship.spring_hz = {20, 10}; }), "hardship.spring_hz"));
  // A profile: as many values as times, in order and within the run, at speeds that the loop follows.
  EXPECT_TRUE(names(only_problem([](S s) { s.scenario.set_speed_s = {0.5}; }), "scenario.set_speed_s"));
  EXPECT_TRUE(names(only_problem([](S s) { s.scenario.load_nm = {0.5, 1}; }), "scenario.load_s"));
  EXPECT_TRUE(names(only_problem([](S s) { s.scenario.load_step_s.reset(), s.scenario.load_off_s.reset();
                                            s.scenario.load_s = {0.5, 0.4}, s.scenario.load_nm = {0.1, 0.2}; }), "scenario.load_s"));
  for (const double rpm : {10.0, 9000.0}) {
    EXPECT_TRUE(names(only_problem([&](S s) { s.scenario.set_speed_s = {0.5}, s.scenario.set_speed_rpm = {rpm}; }),
                      "scenario.set_speed_rpm"));
  }
  EXPECT_EQ(only_problem([](S s) { s.scenario.set_speed_s = {0.5, 0.6}, s.scenario.set_speed_rpm = {2000, 2500}; }), "");
}

TEST(Settings, WhatNeedsAnotherKeyNamesIt) {
  using S = Settings&;
  const auto names = [](const std::string& line, const char* key, const char* other) {
    return line.rfind(key, 0) == 0 && line.find(other) != std::string::npos;
  };
  EXPECT_TRUE(names(only_problem([](S s) { s.load.wind_rpm = 100; }), "load.wind_rpm", "load.fan_nms2"));
  EXPECT_TRUE(names(only_problem([](S s) { s.load.inertia_kgm2 = 0, s.load.spring_nm_rad = 1; }), "load.spring_nm_rad",
                    "load.inertia_kgm2"));
  EXPECT_TRUE(names(only_problem([](S s) { s.sensors.reference = Reference::kHalfBus; }), "sensors.reference",
                    "control.sampling = \"on_time\""));
  EXPECT_EQ(only_problem([](S s) { s.sensors.reference = Reference::kHalfBus, s.control.sampling = Sampling::kOnTime; }), "");
}

TEST(Settings, TheMechanicsOfEitherKindAreChecked) {
  auto s = load_drive_file(std::string(DRIVES) + "/matsui1996.toml").settings;
  s.load.fan_nms2 = 0;
  s.load.wind_rpm = 100;
  const auto lines = problems(s);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0].rfind("load.wind_rpm", 0), 0u) << lines[0];
}

TEST(Settings, APerSecondLoopTooSlowForItsHandOverIsRefused) {
  auto s = load_drive_file(std::string(DRIVES) + "/amano2003.toml").settings;
  s.start.hand_over_rpm = 150;  // 33 ms between crossings, against a crossover of 68 rad/s
  const auto lines = problems(s);
  ASSERT_FALSE(lines.empty());
  EXPECT_NE(lines[0].find("phase margin"), std::string::npos);
}

}  // namespace
}  // namespace steplock::design
