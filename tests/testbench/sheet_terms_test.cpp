// A drive file in a data sheet's terms is the one in the project's own; what contradicts itself is refused at its line.
#include "testbench/drive_file/sheet_terms.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "testbench/data_sheet/data_sheet.hpp"
#include "testbench/drive_file/drive_file.hpp"

namespace steplock {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

// `motor` begins in line 5.
std::string file_with(const std::string& motor, const std::string& more = "") {
  return "[drive]\nname = \"T\"\nsource = \"a sheet\"\n[motor]\n" + motor + "\n[inverter]\nbus_v = 24\n[sensors]\nlimit_a = 30\n" + more +
         "[scenario]\nspeed_rpm = 3500\nduration_s = 1\n";
}
const std::string kOwn =
    "pole_pairs = 7\nresistance_ohm = 0.055\ninductance_h = 30e-6\nflux_vs = 2.9e-3\ninertia_kgm2 = 81e-6\nrated_current_a = 12\n";
const std::string kSheet = "poles = 14\nresistance_line_ohm = 0.11\ninductance_line_h = \"60 uH\"\ninertia_gcm2 = 810\nrated_current_a = 12\n";

design::MotorSection motor_of(const std::string& motor) { return parse_drive_file(file_with(motor), "x.toml").settings.motor; }

std::string refusal(const std::string& motor, const std::string& more = "") {
  try {
    parse_drive_file(file_with(motor, more), "x.toml");
  } catch (const BadInput& e) {
    return e.what();
  }
  return "taken";
}

TEST(SheetTerms, WhatIsBetweenTwoTerminalsIsTwoPhases) {
  const auto m = motor_of(kSheet + "kv_rpm_per_v = 270");
  EXPECT_EQ(m.pole_pairs, 7);
  EXPECT_DOUBLE_EQ(m.resistance_ohm, 0.055);
  EXPECT_DOUBLE_EQ(m.inductance_h, 30e-6);
  EXPECT_DOUBLE_EQ(m.inertia_kgm2, 81e-6);
  // Between two terminals are 2 (L - M).
  EXPECT_DOUBLE_EQ(motor_of(kSheet + "kv_rpm_per_v = 270\nmutual_h = -5e-6").inductance_h, 25e-6);
}

// One volt between two terminals, whose peak is sqrt 3 of a phase's, or twice it, at 270 r/min.
TEST(SheetTerms, TheFluxIsThatOfTheKvAndOfTheTorqueConstantAndOfTheSpeedWithoutLoad) {
  const double omega = 270 * M_PI / 30 * 7;  // electrical
  EXPECT_NEAR(motor_of(kSheet + "kv_rpm_per_v = 270\nshape = \"sinusoidal\"").flux_vs * std::sqrt(3) * omega, 1, 1e-12);
  EXPECT_NEAR(motor_of(kSheet + "kv_rpm_per_v = 270\nshape = \"trapezoidal\"").flux_vs * 2 * omega, 1, 1e-12);
  const double k_t = 30 / M_PI / 270;  // N m/A
  const std::string torque = "torque_constant_nm_a = " + std::to_string(k_t);
  EXPECT_NEAR(motor_of(kSheet + torque).flux_vs, motor_of(kSheet + "kv_rpm_per_v = 270").flux_vs, 1e-6);
  // 24 V less 2 A of 0.11 ohm.
  const auto m = motor_of(kSheet + "no_load_speed_rpm = 6420.6\nno_load_current_a = 2");
  EXPECT_NEAR(m.flux_vs, motor_of(kSheet + "kv_rpm_per_v = 270").flux_vs, 1e-6);
  EXPECT_NEAR(m.coulomb_nm, 2 * k_t, 1e-5);
}

TEST(SheetTerms, TheRatedTorqueIsThatOfTheDrivesOwnCurrent) {
  const std::string sheet = "poles = 14\nresistance_line_ohm = 0.11\ninductance_line_h = 60e-6\ninertia_gcm2 = 810\nkv_rpm_per_v = 270\n"
                            "shape = \"sinusoidal\"\nrated_torque_nm = 0.42";
  EXPECT_NEAR(motor_of(sheet).rated_current_a, 0.42 * 270 * M_PI / 30, 1e-9);
  // Peak of a phase, 1.5 p flux each: sqrt 3 / 1.5 of six-step's.
  std::string text = file_with(sheet);
  text.insert(text.find("[motor]"), "kind = \"sinusoidal\"\n");
  EXPECT_NEAR(parse_drive_file(text, "x.toml").settings.motor.rated_current_a, 0.42 * 270 * M_PI / 30 * std::sqrt(3) / 1.5, 1e-9);
}

TEST(SheetTerms, WhatSaysTheSameThingTwiceHasToAgreeWithinATenth) {
  EXPECT_EQ(refusal(kOwn + "resistance_line_ohm = 0.12"), "taken");
  EXPECT_EQ(motor_of(kOwn + "resistance_line_ohm = 0.12").resistance_ohm, 0.055) << "the project's own key is believed";
  EXPECT_EQ(refusal(kOwn + "resistance_line_ohm = 0.055"),
            "x.toml:11: motor.resistance_ohm is 0.055 by resistance_ohm and 0.0275 by resistance_line_ohm; they must agree within 10 %, leave the "
            "wrong one out");
  EXPECT_THAT(refusal(kOwn + "poles = 7"), HasSubstr("7 by pole_pairs and 3.5 by poles"));
  EXPECT_THAT(refusal(kOwn + "inductance_line_h = 30e-6"), HasSubstr("by inductance_line_h"));
  EXPECT_THAT(refusal(kOwn + "kv_rpm_per_v = 200"), HasSubstr("by kv_rpm_per_v"));
  EXPECT_THAT(refusal(kOwn + "inertia_gcm2 = 8.1"), HasSubstr("by inertia_gcm2"));
  EXPECT_THAT(refusal(kOwn + "rated_torque_nm = 4.2"), HasSubstr("by rated_torque_nm"));
  EXPECT_THAT(refusal(kOwn + "coulomb_nm = 0.01\nno_load_current_a = 2"), HasSubstr("by no_load_current_a"));
  EXPECT_THAT(refusal(kSheet + "kv_rpm_per_v = 270\ntorque_constant_nm_a = 0.05"), HasSubstr("by torque_constant_nm_a and"));
}

TEST(SheetTerms, WhatCannotBeIsRefusedAtItsOwnLine) {
  const auto one = [](const std::string& motor) { return refusal(motor); };
  EXPECT_EQ(one("poles = 13\nresistance_ohm = 0.055\ninductance_h = 30e-6\nflux_vs = 2.9e-3\ninertia_kgm2 = 81e-6\nrated_current_a = 12"),
            "x.toml:5: motor.poles gives 6.5 for motor.pole_pairs, which is a whole number; poles are even");
  EXPECT_THAT(one(kSheet + "kv_rpm_per_v = 900000"), HasSubstr("x.toml:10: motor.kv_rpm_per_v gives motor.flux_vs = "));
  EXPECT_THAT(one(kSheet + "kv_rpm_per_v = 0"), HasSubstr("x.toml:10: motor.kv_rpm_per_v is 0; it must lie in"));
  EXPECT_THAT(one(kSheet + "kv_rpm_per_v = 270\nshape = \"table\"\ntable = [1, 0, -1, 0]"),
              HasSubstr("motor.kv_rpm_per_v says nothing of a phase"));
  EXPECT_THAT(one(kOwn + "viscous_nms = 1e-5\nno_load_current_a = 2"), HasSubstr("give motor.coulomb_nm instead"));
  EXPECT_THAT(one(kSheet + "torque_constant_nm = 0.035"), HasSubstr("did you mean torque_constant_nm_a?"));
}

TEST(SheetTerms, WhatIsMissingNamesTheTermsThatWouldDo) {
  EXPECT_EQ(refusal(kSheet), "x.toml:4: motor.flux_vs is missing; add it in V s: peak phase back-EMF per electrical rad/s; or kv_rpm_per_v or "
                             "torque_constant_nm_a or no_load_speed_rpm");
  EXPECT_THAT(refusal("kv_rpm_per_v = 270\nresistance_line_ohm = 0.11\ninductance_line_h = 60e-6\nrated_current_a = 12"),
              HasSubstr("motor.pole_pairs is missing; add it: electrical per mechanical turns; or poles"));
}

// What was given, and lacks something else, is not called missing.
TEST(SheetTerms, OnlyWhatNothingTellsIsMissing) {
  EXPECT_EQ(refusal("kv_rpm_per_v = 270\nresistance_line_ohm = 0.11\ninductance_line_h = 60e-6\nrated_current_a = 12"),
            "x.toml:4: motor.pole_pairs is missing; add it: electrical per mechanical turns; or poles");
  std::string text = file_with(kSheet + "no_load_speed_rpm = 6420");
  text.erase(text.find("bus_v = 24\n"), 11);
  try {
    parse_drive_file(text, "x.toml");
    FAIL() << "no bus";
  } catch (const BadInput& e) {
    EXPECT_STREQ(e.what(), "x.toml:11: inverter.bus_v is missing; add it in V: of the source");
  }
}

TEST(SheetTerms, InertiaAndLimitAreEstimatedAndNamed) {
  const std::string text = file_with("poles = 14\nresistance_line_ohm = 0.11\ninductance_line_h = 60e-6\nkv_rpm_per_v = 270\nrated_current_a = 12");
  std::string without = text;
  without.erase(without.find("[sensors]"), std::string("[sensors]\nlimit_a = 30\n").size());
  const auto s = parse_drive_file(without, "x.toml").settings;
  EXPECT_DOUBLE_EQ(s.sensors.limit_a, 30);
  const double k_e = 30 / M_PI / 270;
  EXPECT_DOUBLE_EQ(s.motor.inertia_kgm2, 15e-3 * k_e * k_e / 0.11);
  EXPECT_THAT(s.drive.assumed, ElementsAre(HasSubstr("motor.inertia_kgm2: 0.0001706 kg m^2, estimated"),
                                           HasSubstr("sensors.limit_a: 30 A, estimated")));
  // What bus and winding cannot give is no limit.
  const std::string weak = file_with("poles = 14\nresistance_line_ohm = 4\ninductance_line_h = 60e-6\nkv_rpm_per_v = 270\nrated_current_a = 3");
  std::string limited = weak;
  limited.erase(limited.find("[sensors]"), std::string("[sensors]\nlimit_a = 30\n").size());
  EXPECT_DOUBLE_EQ(parse_drive_file(limited, "x.toml").settings.sensors.limit_a, 0.6 * 24 / 4);
  limited.replace(limited.find("rated_current_a = 3"), 19, "rated_current_a = 4");
  try {
    parse_drive_file(limited, "x.toml");
    FAIL() << "the limit would be below the rated current";
  } catch (const BadInput& e) {
    EXPECT_STREQ(e.what(), "x.toml:9: motor.rated_current_a is 4 A, and inverter.bus_v drives 6 A through two phases; at most 0.6 of it, or give "
                           "sensors.limit_a");
  }
  EXPECT_TRUE(parse_drive_file(file_with(kOwn), "x.toml").settings.drive.assumed.empty());
}

// What `steplock new` makes of the same sheet.
TEST(SheetTerms, AreThoseOfSteplockNew) {
  DataSheet sheet;
  sheet.name = "T", sheet.bus_v = 24, sheet.poles = 14, sheet.kv_rpm_per_v = 270, sheet.no_load_current_a = 0.5;
  sheet.resistance_line_ohm = 0.11, sheet.inductance_line_h = 60e-6, sheet.rated_torque_nm = 0.42;
  const auto made = parse_drive_file(drive_file_of(sheet), "new.toml").settings;
  std::string text = file_with("poles = 14\nkv_rpm_per_v = 270\nno_load_current_a = 0.5\nresistance_line_ohm = 0.11\ninductance_line_h = 60e-6\n"
                               "rated_torque_nm = 0.42\nshape = \"sinusoidal\"");
  text.erase(text.find("[sensors]"), std::string("[sensors]\nlimit_a = 30\n").size());
  const auto told = parse_drive_file(text, "x.toml").settings;
  const auto same = [](double a, double b) { EXPECT_NEAR(a, b, 1e-3 * b); };  // four digits in the file
  same(told.motor.flux_vs, made.motor.flux_vs);
  same(told.motor.resistance_ohm, made.motor.resistance_ohm);
  same(told.motor.inductance_h, made.motor.inductance_h);
  same(told.motor.inertia_kgm2, made.motor.inertia_kgm2);
  same(told.motor.coulomb_nm, made.motor.coulomb_nm);
  same(told.motor.rated_current_a, made.motor.rated_current_a);
  same(told.sensors.limit_a, made.sensors.limit_a);
}

}  // namespace
}  // namespace steplock
