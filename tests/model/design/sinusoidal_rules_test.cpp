#include "model/design/sinusoidal/design.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "testbench/drive_file/drive_file.hpp"

namespace steplock::design::sinusoidal {
namespace {

Settings matsui() { return load_drive_file(DRIVES "/matsui1996.toml").settings; }

TEST(SinusoidalRules, TableIIsReadAsNotesSay) {
  const Design d = design_drive(matsui());
  EXPECT_NEAR(d.parameters.motor.k_e, 0.332, 1e-4);
  EXPECT_NEAR(d.parameters.motor.inductance_q, 1.5 * 9.55e-3, 1e-9);
  // 98 kgf cm at 9.65 A power-invariant; the drive's R holds the switch's, too.
  EXPECT_NEAR(d.rated_torque, 98 * 9.80665e-2, 0.01);
  EXPECT_NEAR(std::sqrt(1.5) * 7.88, 9.65, 0.01);
  EXPECT_NEAR(d.current_step, 2.2e-2, 1e-9);
  EXPECT_GT(d.no_load_rpm, 1500);
}

TEST(SinusoidalRules, TheEmfFollowsWithItsBandwidthAndTheAngleWithItsGain) {
  const Settings s = matsui();
  const Design d = design_drive(s);
  const auto& p = d.parameters;
  const double T = p.pwm.period, L = p.motor.inductance_q;
  // One sample leaves exp(-bandwidth T) of the error.
  EXPECT_NEAR(1 - p.current_model.k_e * T / L, std::exp(-d.emf_bandwidth * T), 1e-12);
  // Per electrical radian: K_theta (T / L) K_E w per sample, 1 / (w T) samples.
  EXPECT_NEAR(p.current_model.k_theta / L * p.motor.k_e, s.sinusoidal.angle_gain, 1e-12);
  EXPECT_NEAR(p.voltage_model.k_sp * p.motor.k_e, s.sinusoidal.angle_gain, 1e-12);
}

TEST(SinusoidalRules, TheSlowestSpeedIsWhereARadianShowsAsHalfAStep) {
  const Design d = design_drive(matsui());
  const auto& p = d.parameters;
  const double emf = p.motor.k_e * speed_of(matsui(), d.slowest_rpm);
  EXPECT_NEAR(p.pwm.period / p.motor.inductance_q * emf, std::sqrt(1.5) * d.current_step / 2, 1e-9);
}

// Under a current i the estimate is off by dL i / K_E; the speed's filter sees that move, kp makes it a current.
TEST(SinusoidalRules, AFifthOfTheInductanceComesBackThroughTheSpeedLoopByHalfAtMost) {
  const auto back = [](const Settings& s) {
    const auto& p = design_drive(s).parameters;
    return p.speed.kp * 0.2 * p.motor.inductance_q / p.motor.k_e * p.speed.filter;
  };
  for (const char* name : {"matsui1996", "ipm_2k2", "m2310p_sinusoidal", "br2804_sinusoidal"}) {
    EXPECT_LE(back(load_drive_file(std::string(DRIVES "/") + name + ".toml").settings), 0.5 + 1e-9) << name;
  }
  Settings s = load_drive_file(DRIVES "/ipm_2k2.toml").settings;
  EXPECT_NEAR(back(s), 0.5, 1e-9) << "here it is what limits";
  s.sinusoidal.speed_bandwidth_rad_s = 150;
  EXPECT_GT(back(s), 3) << "as without the rule";
}

TEST(SinusoidalRules, AFifthOfTheResistanceAtTheCurrentsLimitLooksSlowerThanALock) {
  for (const char* name : {"matsui1996", "ipm_2k2", "m2310p_sinusoidal", "br2804_sinusoidal"}) {
    Settings s = load_drive_file(std::string(DRIVES "/") + name + ".toml").settings;
    const auto& p = design_drive(s).parameters;
    EXPECT_GT(p.start.lock_speed, 0.2 * p.motor.resistance * p.speed.limit / p.motor.k_e) << name;
  }
  Settings s = load_drive_file(DRIVES "/m2310p_sinusoidal.toml").settings;
  const double ruled = design_drive(s).parameters.start.lock_speed;
  s.motor.resistance_ohm /= 10;
  EXPECT_LT(design_drive(s).parameters.start.lock_speed, ruled / 2) << "here it is what limits";
}

TEST(SinusoidalRules, ALockTakesHalfAnElectricalTurnUnlessTheFileSaysElse) {
  Settings s = matsui();
  const auto& p = design_drive(s).parameters;
  const double t = p.start.lock_s;
  // rad/s^2, of a quarter of the rated torque
  const double quarter = 0.25 * p.motor.pole_pairs * design_drive(s).rated_torque / (s.motor.inertia_kgm2 + s.load.inertia_kgm2);
  EXPECT_NEAR(p.start.lock_speed * t + quarter * t * t / 2, std::numbers::pi, 1e-9);
  s.sinusoidal_start.lock_rpm = 1000;  // half a turn in 8 ms
  EXPECT_EQ(design_drive(s).parameters.start.lock_s, 0.02);
  s.sinusoidal_start.lock_s = 0.005;
  EXPECT_EQ(design_drive(s).parameters.start.lock_s, 0.005);
}

// A PI control of an inertia whose reference is a ramp to the set speed, from rest: the highest speed over that one.
double passes(const Settings& s, double slew, double inertia) {
  const Design d = design_drive(s);
  const auto& p = d.parameters.speed;
  const auto& m = d.parameters.motor;
  const double gain = s.envelope.flux[0] * m.pole_pairs * m.pole_pairs * m.k_e / (inertia * (s.motor.inertia_kgm2 + s.load.inertia_kgm2));
  double reference = 0, speed = 0, integral = 0, highest = 0;
  for (double t = 0, dt = 2e-5; t < p.target / slew + 1; t += dt) {
    reference = std::min(p.target, reference + slew * dt);
    const double error = reference - speed;
    integral += p.ki * error * dt;
    speed += gain * (p.kp * error + integral) * dt;
    highest = std::max(highest, speed);
  }
  return highest / p.target;
}

TEST(SinusoidalRules, NoRotorOfTheEnvelopePassesTheSetSpeedByMoreThanATenthAtTheEndOfTheRamp) {
  for (const char* name : {"matsui1996", "ipm_2k2", "m2310p_sinusoidal", "br2804_sinusoidal"}) {
    const Settings s = load_drive_file(std::string(DRIVES "/") + name + ".toml").settings;
    const double slew = design_drive(s).parameters.speed.slew;
    for (const double inertia : {0.5, 1.0, 2.0, s.envelope.inertia[1]}) {
      EXPECT_LT(passes(s, slew, inertia), 1.0605) << name;  // 6 %, and what steps of 20 us make of it
    }
  }
  const Settings s = load_drive_file(DRIVES "/m2310p_sinusoidal.toml").settings;
  const Design d = design_drive(s);
  const double quarter = 0.25 * d.parameters.motor.pole_pairs * d.rated_torque / s.motor.inertia_kgm2;
  EXPECT_GT(passes(s, quarter, 3), 1.1) << "what would";
}

TEST(SinusoidalRules, ASetSpeedNearTheLocksIsReachedInNoMoreTimeThanALockTakes) {
  Settings s = matsui();
  s.scenario.speed_rpm = 68;
  const auto& p = design_drive(s).parameters;
  EXPECT_LE(p.start.lock_speed / p.speed.slew, p.start.lock_s * (1 + 1e-9));
}

// J w' = -k angle - b w, b the torque that the back-EMF's current makes through the resistance: the heaviest rotor of the
// envelope, without friction, is let go a degree from the pattern's place.
TEST(SinusoidalRules, APatternLastsUntilTheHeaviestRotorsSwingHasFaded) {
  for (const char* name : {"br2804_sinusoidal", "m2310p_sinusoidal"}) {
    const Settings s = load_drive_file(std::string(DRIVES) + "/" + name + ".toml").settings;
    const Design d = design_drive(s);
    const auto& p = d.parameters;
    const double pairs = p.motor.pole_pairs, inertia = s.envelope.inertia[1] * (s.motor.inertia_kgm2 + s.load.inertia_kgm2);
    const double stiffness = pairs * d.rated_torque * p.start.pattern_current / s.motor.rated_current_a;
    const double damping = 1.5 * std::pow(pairs * s.motor.flux_vs, 2) / p.motor.resistance;
    double angle = 1, speed = 0, swing = 0;  // electrical degrees, and per s
    const double third = p.start.pattern_s / 3, period = 2 * std::numbers::pi * std::sqrt(inertia / stiffness), dt = period * 1e-4;
    for (double t = 0; t < third; t += dt) {
      speed -= (stiffness * angle + damping * speed) / inertia * dt;
      angle += speed * dt;
      if (t > third - period) swing = std::max(swing, std::abs(angle));
    }
    // What a swing is a period before the end, less what the current's rise takes of the time.
    EXPECT_LT(swing, 0.2 * std::exp(damping / (2 * inertia) * period)) << name;
  }
}

// pole_pairs K_E i is the torque of an inertia at the set speed's slew, of friction, and of the envelope's greatest load; k_p times a
// tenth of the set speed takes it away from a rotor that has no load.
TEST(SinusoidalRules, TheFirstCurrentTakesALoadedRotorAlongTheSetSpeedAndNoOtherPastIt) {
  for (const char* name : {"matsui1996", "ipm_2k2", "m2310p_sinusoidal", "br2804_sinusoidal"}) {
    Settings s = load_drive_file(std::string(DRIVES) + "/" + name + ".toml").settings;
    s.load.opposing_nm = 0.01 * s.motor.coulomb_nm;
    const auto of = [](const Settings& settings) { return design_drive(settings).parameters; };
    const Design d = design_drive(s);
    const auto& p = d.parameters;
    const double inertia = s.motor.inertia_kgm2 + s.load.inertia_kgm2, load = s.envelope.load.back() * d.rated_torque;
    const double torque = inertia * p.speed.slew / p.motor.pole_pairs + 1.01 * s.motor.coulomb_nm + load;
    const double follows = torque / (p.motor.pole_pairs * p.motor.k_e), ahead = 0.1 * p.speed.target * p.speed.kp;
    EXPECT_NEAR(p.speed.start_current, std::min(follows, ahead), 1e-9) << name;
    EXPECT_LT(p.speed.start_current, p.speed.limit) << name;

    Settings fan = s;
    fan.envelope.load.clear();
    const double unloaded = follows - load / (p.motor.pole_pairs * p.motor.k_e);
    EXPECT_NEAR(of(fan).speed.start_current, std::min(unloaded, ahead), 1e-9) << name << ": a fan's envelope names no load";

    s.sinusoidal.slew_rpm_s = 1e8;
    EXPECT_NEAR(of(s).speed.start_current, std::min(p.speed.limit, ahead), 1e-9) << name << ": no more than the regulator may ask for";
    s.sinusoidal_start.start_current_a = 0.25;
    EXPECT_NEAR(of(s).speed.start_current, std::sqrt(1.5) * 0.25, 1e-12) << name;
  }
}

TEST(SinusoidalRules, ABelievedConstantMovesTheDriveAndNotTheMotor) {
  Settings s = matsui();
  s.sinusoidal.k_em = 1.25;
  const Design wrong = design_drive(s), right = design_drive(matsui());
  EXPECT_NEAR(wrong.parameters.motor.k_e, 1.25 * right.parameters.motor.k_e, 1e-12);
  EXPECT_EQ(wrong.rated_torque, right.rated_torque);
  EXPECT_EQ(wrong.no_load_rpm, right.no_load_rpm);
}

TEST(SinusoidalRules, WhatMakesNoSenseIsNamedByItsKey) {
  const auto only = [](auto change) {
    Settings s = matsui();
    change(s);
    const auto lines = problems(s);
    return lines.size() == 1 ? lines[0] : "not one problem";
  };
  EXPECT_EQ(problems(matsui()).size(), 0u);
  EXPECT_EQ(only([](Settings& s) { s.motor.shape = Shape::kTrapezoidal; }).find("motor.shape"), 0u);
  EXPECT_EQ(only([](Settings& s) { s.scenario.speed_rpm = 3000; }).find("scenario.speed_rpm"), 0u);
  EXPECT_EQ(only([](Settings& s) { s.scenario.speed_rpm = 20; }).find("scenario.speed_rpm"), 0u);
  EXPECT_EQ(only([](Settings& s) { s.inverter.dead_time_s = 40e-6; }).find("inverter.dead_time_s"), 0u);
  EXPECT_EQ(only([](Settings& s) { s.sensors.limit_a = 8; }).find("sensors.limit_a"), 0u);
  EXPECT_EQ(only([](Settings& s) { s.adc.current_a = 12; }).find("adc.current_a"), 0u);
  EXPECT_EQ(only([](Settings& s) { s.sinusoidal_start.start_current_a = 12; }),
            "sinusoidal_start.start_current_a is 12 A; must be at most 11.82 A, what the speed regulator may ask for "
            "(sinusoidal.current_limit_a)");
  Settings round = matsui();
  round.sinusoidal_start.by = StartBy::kPilot;
  EXPECT_EQ(problems(round).size(), 2u);  // no saliency, no saturation
}

// Worked by hand: 1.2 x 6.1 A take 0.858 ms through 42.2 mH at 360 V and make 9.98 N m at 34 degrees;
// 9.6e-3 N m s turn 0.015 kg m^2 by 0.64 rad/s for 2.23 ms, 3 pole pairs.
TEST(SinusoidalRules, APilotPulseThatTurnsTheRotorTooFarIsRefused) {
  Settings s = load_drive_file(DRIVES "/ipm_2k2.toml").settings;
  EXPECT_NEAR(design_drive(s).parameters.pilot.turned * 180 / 3.14159, 0.247, 0.005);
  EXPECT_EQ(problems(s).size(), 0u);
  s.motor.inertia_kgm2 /= 10;
  const auto lines = problems(s);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_NE(lines.front().find("turns the rotor by up to 2.4"), std::string::npos) << lines.front();
}

}  // namespace
}  // namespace steplock::design::sinusoidal
