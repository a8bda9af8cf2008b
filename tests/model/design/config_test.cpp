// Register words: nearest, within their width, and readable back.
#include <gtest/gtest.h>

#include <cmath>

#include "model/design/design.hpp"
#include "model/design/config.hpp"
#include "testbench/drive_file/drive_file.hpp"

namespace steplock::design {
namespace {

const char* const kDrives[] = {"amano2003",       "bly172s",        "br2804_drone",
                               "ceiling_fan",     "hoverboard_hub", "m2310p_servo",
                               "maxon_ec45_flat", "tekin_spindle"};

Settings settings_of(const std::string& name) {
  return load_drive_file(std::string(DRIVES) + "/" + name + ".toml").settings;
}

TEST(RegisterConfig, AreTheNearestOnes) {
  for (const char* name : kDrives) {
    const auto s = settings_of(name);
    for (const auto& row : quantise(design_drive(s).parameters, s.control.clock_hz).rows) {
      if (row.word == 0) continue;
      const double lsb = row.meant / row.word;
      EXPECT_LE(std::abs(row.error()), lsb / 2 * (1 + 1e-9)) << name << " " << row.name;
    }
  }
}

TEST(RegisterConfig, OfEveryDriveFit) {
  for (const char* name : kDrives) {
    const auto s = settings_of(name);
    EXPECT_TRUE(quantise(design_drive(s).parameters, s.control.clock_hz).problems.empty()) << name;
  }
}

// Loop and speed gains within a tenth of a percent: what the 16-bit words were chosen for.
TEST(RegisterConfig, KeepTheCoefficientsWithinATenthOfAPercent) {
  for (const char* name : kDrives) {
    const auto s = settings_of(name);
    for (const auto& row : quantise(design_drive(s).parameters, s.control.clock_hz).rows) {
      if (row.name != "loop.ki" && row.name != "loop.kp" && row.name != "loop.alpha" &&
          row.name != "speed.kp" && row.name != "speed.bemf") {
        continue;
      }
      EXPECT_LT(std::abs(row.error()), 1e-3 * row.wanted) << name << " " << row.name;
    }
  }
}

TEST(RegisterConfig, FrequencyIsTheVcosIncrement) {
  auto s = settings_of("amano2003");
  const auto d = design_drive(s);
  const auto w = quantise(d.parameters, 12e6).config;
  // 1200 rpm, 2 pole pairs: 40 turns/s, 240 steps/s; 2^32 / 12 MHz per step/s.
  EXPECT_EQ(w["speed.target"], Word(std::lround(240 * 4294967296.0 / 12e6)));
  s.loop.divide = 2;
  const auto divided = quantise(design_drive(s).parameters, 12e6).config;
  EXPECT_NEAR(divided["speed.target"], 4.0 * w["speed.target"], 4);
}

TEST(RegisterConfig, PerSecondProductsMeanTheFilterOfTheComponents) {
  const auto s = settings_of("amano2003");
  const auto d = design_drive(s);
  const auto w = quantise(d.parameters, 12e6).config;
  const double tick = d.parameters.pwm.tick(), hertz = 12e6 / 4294967296.0;
  const double scale = w["loop.scale"] * hertz;  // steps/s
  EXPECT_NEAR(w["loop.kp"] / 16384.0 * scale,
              d.k_l / (d.components.c1 + d.components.c2) / d.components.omega_z(), 0.01);
  EXPECT_NEAR(w["loop.ki"] / 16384.0 * scale / tick, d.k_l / (d.components.c1 + d.components.c2), 1.5);
}

TEST(RegisterConfig, SpeedControlsBackEmfDutyIsExactAtTheSetSpeed) {
  for (const char* name : kDrives) {
    const auto s = settings_of(name);
    const auto d = design_drive(s);
    const auto w = quantise(d.parameters, s.control.clock_hz).config;
    const double duty =
        ((std::uint64_t(w["speed.bemf"]) * (w["speed.target"] >> w["speed.shift"])) >> 12) / 32768.0;
    EXPECT_NEAR(duty, d.motor.k_e * s.scenario.speed_rpm * M_PI / 30 / s.inverter.bus_v, 1e-3)
        << name;
    EXPECT_LT(w["loop.maximum"] >> w["speed.shift"], 32768u) << name;  // fits the 15 bits it is given
  }
}

TEST(RegisterConfig, ThatDoNotFitAreNamed) {
  auto p = design_drive(settings_of("m2310p_servo")).parameters;
  p.speed.kp *= 1e4;
  const auto q = quantise(p, 24e6);
  ASSERT_EQ(q.problems.size(), 1u);
  EXPECT_NE(q.problems[0].find("speed.kp"), std::string::npos);
  EXPECT_EQ(q.config["speed.kp"], 65535u);
}

}  // namespace
}  // namespace steplock::design
