// Design rules, against the motor's own physics.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "model/design/bounds.hpp"
#include "model/design/design.hpp"
#include "model/design/config.hpp"
#include "model/plant/plant.hpp"
#include "testbench/drive_file/drive_file.hpp"

namespace steplock::design {
namespace {

constexpr double kPi = std::numbers::pi;

Settings settings_of(const std::string& name) {
  return load_drive_file(std::string(DRIVES) + "/" + name + ".toml").settings;
}

TEST(DesignRules, TrapezoidConductsItsFullTopSinusItsMeanOverAStep) {
  auto s = settings_of("amano2003");
  EXPECT_NEAR(motor_constants(s).k_e, 0.0383, 1e-6);  // Table 1, line to line
  s.motor.shape = Shape::kSinusoidal;
  // Mean of sqrt(3) cos over +-30 degrees; 60 midpoints leave 1e-4.
  EXPECT_NEAR(motor_constants(s).k_e, 3 * std::sqrt(3) / kPi * s.motor.flux_vs * 2, 1e-5);
}

TEST(DesignRules, ATableOfASinusEqualsTheSinus) {
  auto s = settings_of("m2310p_servo");
  const double sinus = motor_constants(s).k_e;
  s.motor.shape = Shape::kTable;
  for (int k = 0; k < 720; ++k) s.motor.table.push_back(std::sin(k * kPi / 360));
  EXPECT_NEAR(motor_constants(s).k_e, sinus, 1e-4 * sinus);
}

// Six steps from standstill under constant acceleration, of which the last shall be above the stall.
TEST(DesignRules, AStartWithHallSensorsIsFasterThanAStallAfterSixSteps) {
  auto s = settings_of("bly172s");
  const double usual = design_drive(s).parameters.protection.stall;
  s.control.source = Source::kHall;
  const Parameters p = design_drive(s).parameters;
  EXPECT_LE(p.protection.stall, usual);
  EXPECT_NEAR(p.protection.stall, std::sqrt(2 * p.speed.slew * 6) / 2, 1e-9);
  s.speed.slew_rpm_s = 1e6;
  EXPECT_EQ(design_drive(s).parameters.protection.stall, usual);
}

// The linear loop at each of many inertias and on either bus, driven by the ramp that the design chose.
TEST(DesignRules, NoInertiaOfTheEnvelopePassesTheSetSpeedByMoreThanSixHundredths) {
  for (const char* name : {"bly172s", "hoverboard_hub", "m2310p_servo", "maxon_ec45_flat", "tekin_spindle"}) {
    const auto s = settings_of(name);
    const Design d = design_drive(s);
    const auto& p = d.parameters.speed;
    const double rise = p.target - d.parameters.start.hand_over, flux = s.envelope.flux[0];
    const double steps = 6 * s.motor.pole_pairs / (2 * kPi);
    double most = 0;
    for (const double bus : s.envelope.bus) {
      for (double j = s.envelope.inertia[0]; j <= s.envelope.inertia[1]; j *= 1.02) {
        const double slew = std::min(p.slew, flux * d.motor.k_e * s.sensors.limit_a / (j * d.motor.inertia) * steps);
        const double gain = bus * flux / (p.bemf * d.motor.tau_m * j), pole = flux * flux / (d.motor.tau_m * j);
        double speed = 0, integral = 0;
        const double dt = 1e-4;
        for (double t = 0; t < 4; t += dt) {
          const double error = std::min(slew * t, rise) - speed;
          integral += p.ki * error * dt;
          speed += (gain * (integral + p.kp * error) - pole * speed) * dt;
          most = std::max(most, (speed - rise) / p.target);
        }
      }
    }
    // The rule looks at seventeen inertias, which lie a quarter apart, and at ramps a thirtieth apart.
    EXPECT_LE(most, 1.1 * 0.06) << name;
    EXPECT_GE(most, 0.8 * 0.06) << name;
  }
}

TEST(DesignRules, StepsAndRpmAreInverse) {
  const auto s = settings_of("hoverboard_hub");
  EXPECT_DOUBLE_EQ(steps_per_second(s, 200), 200.0 / 60 * 15 * 6);
  EXPECT_DOUBLE_EQ(rpm_of(s, steps_per_second(s, 123)), 123);
}

TEST(DesignRules, TakesWhatTheFileNames) {
  const auto d = design_drive(settings_of("amano2003"));
  EXPECT_DOUBLE_EQ(d.components.c1, 1.291e-6);
  EXPECT_DOUBLE_EQ(d.parameters.start.align, 0.622);  // printed, although Eq. (22) says less
  EXPECT_LT(d.align_time_formula, 0.4);
  EXPECT_NEAR(d.continuous.phase_deg, 54.9, 0.05);
  EXPECT_NEAR(d.parameters.loop.proportional, 68, 0.1);
}

// At stand-still the duty must drive the wanted current through the two phases, whichever way the
// current freewheels.
TEST(DesignRules, StartDutyDrivesTheStartCurrent) {
  auto s = settings_of("hoverboard_hub");
  for (const auto chopping : {Chopping::kComplementary, Chopping::kHighSide}) {
    s.control.chopping = chopping;
    const auto d = design_drive(s);
    const double lost = s.inverter.dead_time_s * s.control.pwm_hz;  // the on-time the guard takes
    const double on = d.parameters.start.start_duty - lost, v = s.inverter.bus_v;
    const double mean = chopping == Chopping::kComplementary
                            ? on * v
                            : on * v - (1 - on) * s.inverter.diode_drop_v;
    EXPECT_NEAR(mean, d.start_current * d.motor.r_loop, 1e-9);
  }
}

TEST(DesignRules, RampIsSlowerThanTheStartCurrentCanAccelerate) {
  for (const char* name : {"amano2003", "ceiling_fan", "br2804_drone", "tekin_spindle"}) {
    const auto s = settings_of(name);
    const auto d = design_drive(s);
    const double able = (d.motor.k_e * d.start_current - s.motor.coulomb_nm) / d.motor.inertia;
    EXPECT_LE(d.ramp_rpm_s * kPi / 30, 0.41 * able) << name;
    EXPECT_GT(d.acceleration_time, 0) << name;
  }
}

TEST(DesignRules, SpeedPiPlacesItsBandwidthOnTheMotorsPole) {
  auto s = settings_of("hoverboard_hub");  // a fast motor: the pole is cancelled
  s.speed.bandwidth_rad_s = 5;
  const auto d = design_drive(s);
  const auto& p = d.parameters.speed;
  const double steps = 6 * s.motor.pole_pairs / (2 * kPi);
  const auto open = [&](double omega) {
    const std::complex<double> j(0, omega);
    const auto motor = s.inverter.bus_v / d.motor.k_e * steps / (1.0 + j * d.motor.tau_m);
    return (p.kp + p.ki / j) * motor;
  };
  EXPECT_NEAR(std::abs(open(5)), 1, 1e-9);
  EXPECT_NEAR(std::arg(open(5)), -kPi / 2, 1e-9);
}

// A rotor so heavy that its gain would not fit the word is controlled more slowly, not refused; a gain that the file names is.
TEST(DesignRules, AVeryHeavyRotorIsControlledAsFastAsTheGainsWordAllows) {
  auto s = settings_of("maxon_ec45_flat");
  const double clock = s.control.clock_hz;
  const double most = most_duty_per_speed(design_drive(s).parameters.loop, clock);
  const double heavier = 3 * most / design_drive(s).parameters.speed.kp;
  s.load.inertia_kgm2 = heavier * (s.motor.inertia_kgm2 + s.load.inertia_kgm2);
  const auto d = design_drive(s);
  const auto q = quantise(d.parameters, clock);
  EXPECT_TRUE(q.problems.empty()) << (q.problems.empty() ? "" : q.problems[0]);
  EXPECT_EQ(q.config["speed.kp"], 65535u);
  // A slow pole, and so both of the closed loop coincide.
  const double gain = s.inverter.bus_v / d.motor.k_e * 6 * s.motor.pole_pairs / (2 * kPi) / d.motor.tau_m;
  const double half = (1 / d.motor.tau_m + d.parameters.speed.kp * gain) / 2;
  EXPECT_NEAR(half * half, d.parameters.speed.ki * gain, 1e-9 * half * half);
  s.speed.kp_duty_per_rpm = 1.001 * most * steps_per_second(s, 1.0);
  EXPECT_EQ(quantise(design_drive(s).parameters, clock).problems.size(), 1u);
}

// A mains fan: 0.77 H between two terminals, and a rotor that swings for a second.
TEST(DesignRules, WhatIsWorkedOutEndsAtItsWord) {
  auto s = settings_of("data_sheets/hawkins_fan");
  const auto q = quantise(design_drive(s).parameters, s.control.clock_hz);
  EXPECT_TRUE(q.problems.empty()) << (q.problems.empty() ? "" : q.problems[0]);
  EXPECT_GT(q.config["start.align"], 3800u);
  EXPECT_LT(q.config["start.align"], 4096u);
  EXPECT_NEAR(q.config["start.pre_align"], q.config["start.align"] / 2.0, 1);
  EXPECT_EQ(q.config["speed.loaded"], 65535u);
}

// What the file names itself is refused with the value that its word holds; that value then has words.
TEST(DesignRules, AGainOfTheFileThatItsWordDoesNotHoldIsRefusedWithTheNearestThatItDoes) {
  const auto refused = [](Settings s, const std::string& begins) {
    const auto found = problems(s);
    EXPECT_EQ(found.size(), 1u);
    if (found.empty()) return 0.0;
    EXPECT_TRUE(found[0].starts_with(begins)) << found[0];
    EXPECT_TRUE(found[0].ends_with(" at a clock of 20 MHz, where the word of the gain ends")) << found[0];
    return std::stod(found[0].substr(begins.size()));
  };
  auto s = settings_of("amano2003");
  EXPECT_TRUE(problems(s).empty());  // at 50 MHz the same gain fits
  s.control.clock_hz = 20e6;
  const double most = refused(s, "speed.bandwidth_rad_s is 16; at most ");
  s.speed.bandwidth_rad_s = most;
  EXPECT_TRUE(problems(s).empty());
  EXPECT_GT(quantise(design_drive(s).parameters, 20e6).config["speed.kp"], 65535 * 0.99 - 1);  // three digits
  s.speed.kp_duty_per_rpm = 1;
  s.speed.kp_duty_per_rpm = refused(s, "speed.kp_duty_per_rpm is 1; at most ");
  EXPECT_TRUE(problems(s).empty());
}

// At the corner of the default envelope: 1.2 times flux and resistance at 0.8 times the bus, with the limit's current.
TEST(DesignRules, NoRightLockOfTheEnvelopeSlips) {
  int once_slipped = 0;
  for (const char* name : {"amano2003", "bly172s", "br2804_drone", "ceiling_fan", "hoverboard_hub", "m2310p_servo",
                           "maxon_ec45_flat", "tekin_spindle"}) {
    const auto s = settings_of(name);
    const auto d = design_drive(s);
    const auto corner = [&](double rpm) {
      const double v = 0.8 * s.inverter.bus_v, f = steps_per_second(s, rpm);
      const double commutation = 2 * (s.motor.inductance_h - s.motor.mutual_h) * s.sensors.limit_a * f;
      return (1.2 * d.motor.k_e * rpm * kPi / 30 + 1.2 * d.motor.r_loop * s.sensors.limit_a + commutation) / v;
    };
    const auto allowed = [&](double rpm) {
      return d.parameters.protection.slip + d.parameters.speed.loaded * steps_per_second(s, rpm);
    };
    for (const double part : {0.1, 0.5, 1.0}) {
      EXPECT_LE(corner(part * s.scenario.speed_rpm), allowed(part * s.scenario.speed_rpm)) << name << ' ' << part;
    }
    // The control: with the file's own back-EMF in place of the greatest, as it once was.
    const double set = s.scenario.speed_rpm;
    once_slipped += corner(set) > allowed(set) - 0.5 * d.parameters.speed.bemf * steps_per_second(s, set);
  }
  EXPECT_GT(once_slipped, 0);
}

struct Current {
  double peak = 0, mean = 0;  // A, the mean over time
};

// In the plant, of 400 pulses that the limit cuts for `off` seconds each, with these gates on in the cut; the rotor is blocked.
Current when_cut(const Settings& s, double off, const plant::Gates& in_the_cut) {
  constexpr int kSamples = 100;  // of a cut
  plant::Parameters p = plant_parameters(s);
  p.motor.static_friction = p.motor.coulomb_friction = 1e3;
  plant::Plant plant(p);
  Current of;
  const auto advance = [&](double dt) {
    plant.advance_to(plant.time() + dt);
    of.mean += std::abs(plant.state().current[0]) * dt;
  };
  for (int pulse = 0; pulse < 400; ++pulse) {
    plant.set_gates({.uh = true, .vl = true});
    const double believed = plant.time() + unbelieved(s);
    while (plant.time() < believed || (!plant.pins().limit && plant.time() < 0.1)) advance(1 / s.control.clock_hz);
    of.peak = std::max(of.peak, std::abs(plant.state().current[0]));
    plant.set_gates(in_the_cut);
    for (int i = 0; i < kSamples; ++i) advance(off / kSamples);
  }
  of.mean /= plant.time();
  return of;
}
constexpr plant::Gates kFreewheeling = {.ul = true, .vl = true}, kAllOff = {};

// At the end of the envelope where the current climbs most.
Settings most_of(Settings s) {
  s.inverter.bus_v *= 1.2;
  s.motor.resistance_ohm *= 0.8;
  s.inverter.bus_resistance_ohm = 0;
  return s;
}

// At a standstill the bus drives the current up while nobody believes the comparator; resistance alone takes it down.
TEST(DesignRules, InTheOffTimeTheLimitsCurrentFallsFurtherThanItRose) {
  auto s = settings_of("bly172s");
  EXPECT_DOUBLE_EQ(design_drive(s).parameters.limit.off_time, 20e-6);
  s.motor.resistance_ohm = 0.02;
  Settings most = s;
  most.inverter.bus_v *= 1.2;
  const double off = design_drive(s).parameters.limit.off_time;
  EXPECT_GT(off, 20e-6);
  EXPECT_LT(when_cut(most_of(s), off, kFreewheeling).peak, limited_current(most));
  EXPECT_GT(when_cut(most_of(s), 20e-6, kFreewheeling).peak, limited_current(most));  // the control: as it once was
  s.control.limit_off_time_s = 7e-6;
  EXPECT_DOUBLE_EQ(design_drive(s).parameters.limit.off_time, 7e-6);
}

// With all gates off the current falls as it rose, in a quarter of the off-time.
TEST(DesignRules, AQuarterOfTheOffTimeUndoesWhatNobodyBelieved) {
  auto s = settings_of("bly172s");
  s.motor.resistance_ohm *= 2;
  s.control.limit_blanking_s = 8e-6;
  const double default_off = design_drive(s).parameters.limit.off_time;
  EXPECT_DOUBLE_EQ(default_off, 4 * unbelieved(s));
  EXPECT_GT(default_off, 32e-6);
  EXPECT_EQ(problems(s), std::vector<std::string>());
  s.control.limit_off_time_s = 0.9 * default_off;
  const auto found = problems(s);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NE(found[0].find("control.limit_off_time_s"), std::string::npos) << found[0];
  s.start.method = Method::kRamp;
  EXPECT_EQ(problems(s), found) << "a drive that runs turns all gates off in a cut, however it was started";
}

// Of a small inductance the bus takes all current down in less than a whole off-time: then a quarter of the limit is left.
TEST(DesignRules, AQuarterOfTheOffTimeLeavesMoreOfTheLimit) {
  const auto s = load_drive_file(DRIVES "/../tests/testbench/low_inductance.toml").settings;
  const double off = design_drive(s).parameters.limit.off_time;
  EXPECT_LT(when_cut(s, off, kAllOff).mean, 0.25 * s.sensors.limit_a);
  EXPECT_GT(when_cut(s, off / 4, kAllOff).mean, 0.5 * s.sensors.limit_a);
  // Of the least off-time that a drive may have a quarter is enough, and half of that is not.
  Settings most = s;
  most.inverter.bus_v *= 1.2;
  EXPECT_LT(when_cut(most_of(s), least_off_time(s) / 4, kAllOff).peak, limited_current(most));
  EXPECT_GT(when_cut(most_of(s), least_off_time(s) / 8, kAllOff).peak, limited_current(most));
}

TEST(DesignRules, HandOverShowsTheBackEmfAboveTheComparatorsDoubt) {
  auto s = settings_of("m2310p_servo");
  s.start.hand_over_rpm.reset();
  s.sensors.comparator_noise_v = 0.05;
  const auto d = design_drive(s);
  const double emf = s.motor.flux_vs * d.hand_over_rpm * kPi / 30 * s.motor.pole_pairs;
  const bool at_the_cap = d.hand_over_rpm > 0.399 * s.scenario.speed_rpm;
  EXPECT_TRUE(emf >= 9.9 * (0.02 + 0.005 + 0.15) || at_the_cap);
}

// Each attempt of a rotor that is held fast looks at three steps; the rest of the time is for codes that only quiver.
TEST(DesignRules, WhatCannotTurnIsToldInFiveSeconds) {
  for (const char* name : {"amano2003", "bly172s", "br2804_drone", "ceiling_fan", "hoverboard_hub", "m2310p_servo", "maxon_ec45_flat",
                           "tekin_spindle"}) {
    Settings s = settings_of(name);
    const auto p = design_drive(s).parameters.start;
    const double look = p.look + p.probe, attempts = 1 + p.retries;
    EXPECT_LE(attempts * (p.detect_spin + p.retry_delay + 3 * p.still * look), 4.5) << name;
    s.start.retries = 0;
    EXPECT_GE(design_drive(s).parameters.start.still, p.still) << name << ": patience is what the attempts leave";
  }
}

}  // namespace
}  // namespace steplock::design
