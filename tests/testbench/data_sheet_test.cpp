// A drive file from a data sheet: the same motor in whatever terms it is printed, and no file of what cannot be.
#include "testbench/data_sheet/data_sheet.hpp"

#include <gmock/gmock.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "model/design/design.hpp"
#include "model/design/settings_keys.hpp"
#include "model/design/config.hpp"
#include "testbench/run/check.hpp"

namespace steplock {
namespace {

using testing::HasSubstr;

DataSheet outrunner() {
  return {.name = "outrunner", .bus_v = 24, .poles = 14, .kv_rpm_per_v = 270, .resistance_line_ohm = 0.11, .inductance_line_h = 60e-6,
          .rated_current_a = 12};
}

design::Settings settings_of(const DataSheet& sheet) {
  DriveFile file = parse_drive_file(drive_file_of(sheet), "sheet.toml");
  check_drive_file(file);
  return file.settings;
}

std::string refusal(const DataSheet& sheet) {
  try {
    drive_file_of(sheet);
  } catch (const BadInput& e) {
    return e.what();
  }
  return "taken";
}

TEST(DataSheet, PhaseValuesAreHalfOfThoseBetweenTwoTerminals) {
  const auto s = settings_of(outrunner());
  EXPECT_DOUBLE_EQ(s.motor.resistance_ohm, 0.055);
  EXPECT_DOUBLE_EQ(s.motor.inductance_h, 30e-6);
  EXPECT_EQ(s.motor.pole_pairs, 7);
}

// 270 r/min per volt between two terminals, whose peak is sqrt 3 of a phase's.
TEST(DataSheet, TheFluxTurnsTheMotorAtItsKv) {
  const auto s = settings_of(outrunner());
  const double omega = 270 * M_PI / 30 * 7;  // electrical, at one volt
  EXPECT_NEAR(std::sqrt(3) * s.motor.flux_vs * omega, 1, 1e-3) << "four digits";
  DataSheet flat = outrunner();
  flat.trapezoidal = true;
  EXPECT_NEAR(2 * settings_of(flat).motor.flux_vs * omega, 1, 1e-3);
}

TEST(DataSheet, TheSameMotorInOtherTermsIsTheSameFile) {
  const auto a = settings_of(outrunner());
  DataSheet other = outrunner();
  other.poles.reset(), other.pole_pairs = 7;
  other.kv_rpm_per_v.reset(), other.torque_constant_nm_a = 30 / M_PI / 270;
  other.resistance_line_ohm.reset(), other.resistance_phase_ohm = 0.055;
  other.inductance_line_h.reset(), other.inductance_phase_h = 30e-6;
  other.rated_current_a.reset(), other.rated_torque_nm = 12 * 30 / M_PI / 270;
  const auto b = settings_of(other);
  EXPECT_NEAR(b.motor.flux_vs, a.motor.flux_vs, 1e-3 * a.motor.flux_vs);
  EXPECT_NEAR(b.motor.rated_current_a, 12, 0.01);
  EXPECT_EQ(b.motor.resistance_ohm, a.motor.resistance_ohm);
  EXPECT_EQ(b.motor.inductance_h, a.motor.inductance_h);
  EXPECT_EQ(b.motor.pole_pairs, 7);
}

// 24 V less 0.42 A of 0.307 ohm, at 4,300 r/min.
TEST(DataSheet, TheSpeedWithoutLoadIsThatOfTheBusLessItsDrop) {
  DataSheet sheet = outrunner();
  sheet.kv_rpm_per_v.reset(), sheet.no_load_speed_rpm = 4300, sheet.no_load_current_a = 0.42, sheet.resistance_line_ohm = 0.307;
  const auto s = settings_of(sheet);
  const double k_e = (24 - 0.42 * 0.307) / (4300 * M_PI / 30);
  EXPECT_NEAR(std::sqrt(3) * 7 * s.motor.flux_vs, k_e, 1e-3 * k_e);
  EXPECT_NEAR(s.motor.coulomb_nm, 0.42 * k_e, 1e-3 * 0.42 * k_e);
}

TEST(DataSheet, WhatSaysTheSameThingTwiceHasToAgree) {
  DataSheet sheet = outrunner();
  sheet.torque_constant_nm_a = 1.09 * 30 / M_PI / 270;
  EXPECT_EQ(refusal(sheet), "taken");
  sheet.torque_constant_nm_a = 1.2 * 30 / M_PI / 270;
  EXPECT_THAT(refusal(sheet), HasSubstr("0.04244 by --torque-constant and 0.03537 by --kv"));
  sheet = outrunner();
  sheet.pole_pairs = 14;  // poles, not pairs
  EXPECT_THAT(refusal(sheet), HasSubstr("7 by --poles and 14 by --pole-pairs"));
}

void expect_same(const design::Settings& a, const design::Settings& b) {
  for_each_key(a, [&](const design::Key& key, const auto& x) {
    for_each_key(b, [&](const design::Key& other, const auto& y) {
      if constexpr (std::is_same_v<decltype(x), decltype(y)>) {
        EXPECT_TRUE(key.section != other.section || key.name != other.name || x == y) << key.section << "." << key.name;
      }
    });
  });
}

// Each key stands there, once; the defaults that it names are those, so that the file with all of them makes the same drive.
TEST(DataSheet, ATemplateHasEveryKeyWithItsDefault) {
  const std::string made = drive_file_of(outrunner()), all = with_every_key(made, "new.toml");
  std::string uncommented = all;
  int keys = 0, worked_out = 0;
  const design::Settings defaults;
  for_each_key(defaults, [&](const design::Key& key, const auto&) {
    constexpr auto kKind = design::DriveKind::kSixStep;
    if (!design::belongs(key.section, kKind) || !design::belongs(key.section, key.name, kKind)) return;
    ++keys;
    const std::size_t section = all.find(fmt::format("\n[{}]\n", key.section));
    ASSERT_NE(section, all.npos) << key.section;
    const std::string here = all.substr(section, all.find("\n[", section + 2) - section);
    const std::string given = fmt::format("\n{} = ", key.name), comment = fmt::format("\n# {} = ", key.name);
    EXPECT_NE(here.find(given) == here.npos, here.find(comment) == here.npos) << key.section << "." << key.name;
    const std::size_t at = uncommented.find(comment, uncommented.find(fmt::format("\n[{}]\n", key.section)));
    if (here.find(comment) == here.npos) return;
    if (uncommented[at + comment.size()] == ' ') {
      ++worked_out;
    } else {
      uncommented.erase(at + 1, 2);
    }
  });
  EXPECT_GT(keys, 100);
  EXPECT_GT(worked_out, 10);
  const auto of = [](const std::string& text) { return parse_drive_file(text, "new.toml").settings; };
  expect_same(of(all), of(made));
  expect_same(of(uncommented), of(made));
}

TEST(DataSheet, NamesAllThatIsMissingAtOnce) {
  const std::string said = refusal({.name = "nothing"});
  for (const char* what : {"--bus", "--poles", "--kv", "--resistance-line", "--inductance-line", "--rated-current"}) {
    EXPECT_THAT(said, HasSubstr(what));
  }
}

TEST(DataSheet, WhatCannotBeIsRefusedWithTheBoundThatWorks) {
  DataSheet sheet = outrunner();
  sheet.limit_a = 210;  // 24 V over 0.11 ohm are 218 A
  EXPECT_THAT(refusal(sheet), HasSubstr("--limit 196.4"));
  sheet.limit_a = 196.3;
  EXPECT_EQ(refusal(sheet), "taken");
  sheet.limit_a = 5;
  EXPECT_THAT(refusal(sheet), HasSubstr("less than the rated current of 12 A"));
  sheet = outrunner();
  sheet.speed_rpm = 6000;
  EXPECT_THAT(refusal(sheet), HasSubstr("--speed 5832"));
  sheet.speed_rpm = 5832;
  EXPECT_EQ(refusal(sheet), "taken");
  sheet = outrunner();
  sheet.poles = 7;
  EXPECT_THAT(refusal(sheet), HasSubstr("3.5 pole pairs"));
}

TEST(DataSheet, WhatItEstimatesIsNamedInTheFile) {
  const auto few = settings_of(outrunner()).drive.assumed;
  DataSheet sheet = outrunner();
  sheet.inertia_gcm2 = 100, sheet.limit_a = 40, sheet.speed_rpm = 3000;
  const auto s = settings_of(sheet);
  EXPECT_EQ(s.drive.assumed.size() + 3, few.size());
  EXPECT_DOUBLE_EQ(s.motor.inertia_kgm2, 1e-5);
  EXPECT_DOUBLE_EQ(s.sensors.limit_a, 40);
  EXPECT_DOUBLE_EQ(s.scenario.speed_rpm, 3000);
}

// Over decades: a file is one that the loader, the plant and the design library take, with words that fit; or the motor's own
// resistance or inductance lies beyond what a drive file may have.
TEST(DataSheet, DrawnSheetsGiveADriveUnlessTheMotorIsBeyondADriveFile) {
  std::mt19937_64 random(36);
  const auto by_ratio = [&](double a, double b) { return a * std::pow(b / a, double(random() % 10000) / 10000); };
  int refused = 0;
  for (int k = 0; k < 300; ++k) {
    const double bus = by_ratio(3.7, 400), power = by_ratio(2, 5000);
    DataSheet sheet{.name = "drawn", .bus_v = bus, .pole_pairs = double(1 + random() % 20)};
    sheet.no_load_speed_rpm = by_ratio(300, 60000) / *sheet.pole_pairs * 2;
    sheet.rated_current_a = power / (0.5 * bus);
    sheet.resistance_line_ohm = by_ratio(0.03, 0.2) * power / std::pow(*sheet.rated_current_a, 2);
    sheet.inductance_line_h = *sheet.resistance_line_ohm * by_ratio(0.1e-3, 2e-3);
    const double r = *sheet.resistance_line_ohm / 2, l = *sheet.inductance_line_h / 2;
    const bool beyond = r < 1e-4 || r > 1e3 || l < 1e-7 || l > 1;  // docs/drive_file.md
    try {
      const auto s = settings_of(sheet);
      const auto q = design::quantise(design::design_drive(s).parameters, s.control.clock_hz);
      EXPECT_TRUE(q.problems.empty()) << k << ": " << q.problems.front();
      EXPECT_FALSE(beyond) << k;
    } catch (const BadInput& e) {
      EXPECT_THAT(e.what(), testing::ContainsRegex("^sheet.toml:[0-9]+: motor[.](resistance_ohm|inductance_h) is .* must lie in")) << k;
      EXPECT_TRUE(beyond) << k << ": " << e.what();
      ++refused;
    }
  }
  EXPECT_GT(refused, 0);
}

}  // namespace
}  // namespace steplock
