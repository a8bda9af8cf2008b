// What the design believes of a motor that is another one.
#include "model/design/believed.hpp"

#include <gtest/gtest.h>

#include "model/design/design.hpp"
#include "model/design/sinusoidal/config.hpp"
#include "model/design/config.hpp"
#include "testbench/drive_file/drive_file.hpp"

namespace steplock::design {
namespace {

Settings drive(const std::string& name) { return load_drive_file(DRIVES "/" + name + ".toml").settings; }

// Of either drive, as text.
std::string config_of(const Settings& s) {
  std::string text;
  const auto rows = s.drive.kind == DriveKind::kSinusoidal ? sinusoidal::quantise(s).rows
                                                           : quantise(design_drive(s).parameters, s.control.clock_hz).rows;
  for (const WordRow& row : rows) text += row.name + ' ' + std::to_string(row.word) + '\n';
  return text;
}

// The words are those of a file whose motor has these values; each of them counts.
TEST(Believed, TheWordsAreThoseOfTheMotorThatIsBelieved) {
  for (const char* name : {"m2310p_servo", "br2804_sinusoidal"}) {
    const Settings own = drive(name);
    Settings all = own, another = own;
    const auto same = [&](std::optional<double> BelievedSection::*believed, double MotorSection::*real, double factor) {
      Settings one = own;
      one.believed.*believed = all.believed.*believed = another.motor.*real = factor * own.motor.*real;
      EXPECT_NE(config_of(one), config_of(own)) << name << factor;
    };
    same(&BelievedSection::resistance_ohm, &MotorSection::resistance_ohm, 1.3);
    same(&BelievedSection::inductance_h, &MotorSection::inductance_h, 0.7);
    same(&BelievedSection::flux_vs, &MotorSection::flux_vs, 1.1);
    same(&BelievedSection::inertia_kgm2, &MotorSection::inertia_kgm2, 2);
    EXPECT_EQ(config_of(all), config_of(another)) << name;
    EXPECT_EQ(config_of(as_believed(all)), config_of(another)) << name;
  }
}

TEST(Believed, ASalientRotorsInductancesCount) {
  const Settings own = drive("ipm_2k2");
  for (const auto believed : {&BelievedSection::inductance_d_h, &BelievedSection::inductance_q_h}) {
    Settings s = own;
    s.believed.*believed = 1.2 * (believed == &BelievedSection::inductance_d_h ? *own.motor.inductance_d_h : *own.motor.inductance_q_h);
    EXPECT_NE(config_of(s), config_of(own));
  }
}

// The plant, and what the scenario asks of it, are the motor's own; every report names the belief.
TEST(Believed, TheMotorStaysWhatItIs) {
  Settings s = drive("m2310p_servo");
  const double k_e = motor_constants(s).k_e, step = load_step_torque(s);
  EXPECT_EQ(beliefs(s), "");
  s.believed.flux_vs = 1.25 * s.motor.flux_vs;
  s.believed.resistance_ohm = 0.5 * s.motor.resistance_ohm;
  EXPECT_EQ(motor_constants(s).k_e, k_e);
  EXPECT_EQ(load_step_torque(s), step);
  EXPECT_EQ(beliefs(s), "believed: resistance_ohm 0.5 times the motor's, flux_vs 1.25 times the motor's");
}

TEST(Believed, AFileThatBelievesSaysSoInItsName) {
  const DriveFile file = parse_drive_file(
      "[drive]\nname = \"Test\"\nsource = \"nowhere\"\n[motor]\nresistance_ohm = 0.4\ninductance_h = 0.2e-3\nflux_vs = 6e-3\n"
      "pole_pairs = 4\ninertia_kgm2 = 7e-6\nrated_current_a = 5\n[believed]\nresistance_ohm = 0.8\n[inverter]\nbus_v = 24\n"
      "[sensors]\nlimit_a = 10\n[scenario]\nspeed_rpm = 3000\nduration_s = 1\n",
      "x.toml");
  EXPECT_EQ(file.settings.drive.name, "Test, believed: resistance_ohm 2 times the motor's");
  EXPECT_EQ(file.settings.motor.resistance_ohm, 0.4);
}

}  // namespace
}  // namespace steplock::design
