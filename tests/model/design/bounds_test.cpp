// The bounds of a start, against the physics that they come from.
#include "model/design/bounds.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "testbench/drive_file/drive_file.hpp"

namespace steplock::design {
namespace {

constexpr double kPi = std::numbers::pi;

Settings settings_of(const std::string& name) {
  return load_drive_file(std::string(DRIVES) + "/" + name + ".toml").settings;
}

// i' = (w psi sin(w t + a) - R i) / L, from i = 0: the largest current of all instants at which it may begin.
double largest_after_a_short(double flux, double w, double r, double l) {
  double most = 0;
  for (int begin = 0; begin < 36; ++begin) {
    const double dt = 1e-4 / w;
    double i = 0;
    for (int k = 0; k * dt * w < 4 * kPi; ++k) {
      i += dt * (w * flux * std::sin(w * k * dt + begin * kPi / 18) - r * i) / l;
      most = std::max(most, std::abs(i));
    }
  }
  return most;
}

TEST(StartBounds, ShortedWindingsNeverCarryMoreAndHardlyLess) {
  Settings s = settings_of("hoverboard_hub");
  s.motor.shape = Shape::kSinusoidal;
  for (const double rpm : {20.0, 100.0, 200.0}) {
    const double most =
        largest_after_a_short(s.motor.flux_vs, rpm * kPi / 30 * s.motor.pole_pairs,
                              s.motor.resistance_ohm + s.inverter.on_resistance_ohm, s.motor.inductance_h - s.motor.mutual_h);
    EXPECT_LE(most, shorted_current(s, rpm)) << rpm;
    EXPECT_GE(most, shorted_current(s, rpm) * 0.95) << rpm;
  }
  EXPECT_EQ(shorted_current(s, 0), 0);
}

// The mean of 2 e(x) sin x over a turn, e with straight flanks.
TEST(StartBounds, ATrapezoidShortsItsFundamental) {
  Settings s = settings_of("hoverboard_hub");
  s.motor.shape = Shape::kSinusoidal;
  const double sinus = shorted_current(s, 100);
  s.motor.shape = Shape::kTrapezoidal;
  for (const double flat : {60.0, 120.0, 170.0}) {
    s.motor.flat_top_deg = flat;
    const double flank = (180 - flat) / 2 * kPi / 180;
    double sum = 0;
    for (int k = 0; k < 9000; ++k) {
      const double x = (k + 0.5) * kPi / 18000;
      sum += 2 * std::min(1.0, x / flank) * std::sin(x) / 9000;
    }
    EXPECT_NEAR(shorted_current(s, 100) / sinus, sum, 1e-6) << flat;
  }
}

TEST(StartBounds, FromRestTheCurrentIsTheLimitAndWhatRisesUntilItIsSeen) {
  Settings s = settings_of("m2310p_servo");
  const double rise = 2 * s.inverter.bus_v / (2 * (s.motor.inductance_h - s.motor.mutual_h));
  s.control.limit_blanking_s = 0;
  const double without = start_bounds(s).current_a;
  s.control.limit_blanking_s = 5e-6;
  EXPECT_NEAR(start_bounds(s).current_a - without, rise * 5e-6 * changing_over(s, design_drive(s).hand_over_rpm), 1e-9);
  EXPECT_GT(without, s.sensors.limit_a);
}

// Three windings without resistance, each with its back-EMF at its top: the outgoing one freewheels on the rail of the winding
// that goes on, the incoming one rises to the limit.
TEST(StartBounds, CurrentsThatChangeOverAddUpInTheThirdWinding) {
  const Settings s = settings_of("m2310p_servo");
  const double v = s.inverter.bus_v, no_load = v / motor_constants(s).k_e * 30 / kPi;
  for (const double share : {0.0, 0.1, 0.3, 0.49, 0.6, 1.0}) {
    const double e = share * v / 2, dt = 1e-5;  // L / V and the limit: 1
    double in = 0, out = 1, most = 1;
    while (in < 1 && out > 0) {
      const double neutral = (v - e) / 3;
      in += (v - e - neutral) / v * dt;
      out += (-e - neutral) / v * dt;
      most = std::max(most, in + out);
    }
    EXPECT_NEAR(most, changing_over(s, share * no_load), 1e-4) << share;
  }
}

TEST(StartBounds, ByRampARotorThatLeadsDrivesCurrentPastTheShunt) {
  Settings s = settings_of("hoverboard_hub");
  const double following = start_bounds(s).current_a;
  s.start.method = Method::kRamp;
  EXPECT_NEAR(start_bounds(s).current_a, following + shorted_current(s, s.scenario.speed_rpm), 1e-9);
}

TEST(StartBounds, OnlyARotorThatTurnsBackwardsIsBraked) {
  Settings s = settings_of("hoverboard_hub");
  const double rest = start_bounds(s).current_a;
  s.scenario.start_speed_rpm = s.scenario.speed_rpm;
  EXPECT_EQ(start_bounds(s).current_a, rest);
  s.scenario.start_speed_rpm = -s.scenario.speed_rpm;
  EXPECT_EQ(start_bounds(s).current_a, std::max(rest, shorted_current(s, s.scenario.speed_rpm)));
  s.scenario.reverse = true;  // which is the wanted way then
  EXPECT_EQ(start_bounds(s).current_a, rest);
}

TEST(StartBounds, ARunThatEndsInABrakeMayCarryItsCurrent) {
  Settings s = settings_of("hoverboard_hub");
  s.scenario.stop_s = s.scenario.reverse_s = std::nullopt;
  const double rest = current_bound(s);
  s.scenario.stop_s = 1;
  s.scenario.brake_to_stop = false;
  EXPECT_EQ(current_bound(s), rest);
  s.scenario.brake_to_stop = true;
  EXPECT_EQ(current_bound(s), std::max(rest, shorted_current(s, kBrakedFrom * design_drive(s).hand_over_rpm)));
}

// The loop step by step, with ramps of many lengths: f' = ((duty bus - back-EMF) / R - load's current) K_t / J.
double highest_of_many_ramps(const Settings& file, const Settings& motor) {
  const SpeedParameters p = design_drive(file).parameters.speed;
  const MotorConstants m = motor_constants(motor);
  const double steps = 6 * file.motor.pole_pairs / (2 * kPi), bus = file.inverter.bus_v;
  const double a = std::min(p.slew, file.sensors.limit_a * m.k_e / m.inertia * steps);
  const double period = 2 * kPi / std::sqrt(p.ki * bus * m.k_e / m.r_loop / m.inertia * steps), dt = 1e-4 * period;
  const double against = (motor.load.opposing_nm + motor.motor.coulomb_nm) / m.inertia;
  double highest = 1.1;
  for (double rise = 0.1 * period; rise < 1.5 * period; rise *= 1.01) {
    double speed = 0, integral = 0;  // rad/s
    for (double t = 0; t < rise + period; t += dt) {
      const double error = a * std::min(t, rise) - speed * steps;
      integral += p.ki * error * dt;
      speed += (((integral + p.kp * error) * bus - m.k_e * speed) / m.r_loop * m.k_e / m.inertia - against) * dt;
      if (t > rise) highest = std::max(highest, 1 + (speed * steps - a * rise) / p.target);
    }
  }
  return highest;
}

TEST(StartBounds, AHeavyRotorMayPassTheSetSpeedByMore) {
  Settings file = settings_of("m2310p_servo");
  file.start.method = Method::kRamp;
  file.motor.coulomb_nm = 0;
  EXPECT_EQ(start_bounds(file).speed, 1.1);
  int loads_matter = 0;
  for (const double heavier : {100.0, 1000.0, 1e4}) {
    Settings motor = file;
    motor.motor.inertia_kgm2 *= heavier;
    motor.load.inertia_kgm2 *= heavier;
    const double highest = highest_of_many_ramps(file, motor);
    EXPECT_NEAR(start_bounds(file, motor).speed, highest, 1e-3 * highest) << heavier;
    motor.load.opposing_nm = 0.02;
    const double loaded = highest_of_many_ramps(file, motor);
    EXPECT_LE(loaded, start_bounds(file, motor).speed * (1 + 1e-3)) << heavier;
    loads_matter += loaded > highest;
  }
  EXPECT_EQ(loads_matter, 2) << "the limit hardly moves the heaviest";
}

// Three steps under the limit's torque, nothing against it.
TEST(StartBounds, ALightRotorMayBeFastBeforeItsDirectionIsKnown) {
  const Settings file = settings_of("m2310p_servo");
  Settings motor = file;
  motor.motor.inertia_kgm2 /= 2;
  const MotorConstants m = motor_constants(motor);
  const double torque = m.k_e * file.sensors.limit_a, dt = 1e-7;
  double angle = 0, speed = 0;  // rad, rad/s
  while (angle * file.motor.pole_pairs < kPi) {
    speed += torque / m.inertia * dt;
    angle += speed * dt;
  }
  EXPECT_NEAR(start_bounds(file, motor).speed, speed * 30 / kPi / file.scenario.speed_rpm, 1e-3);
  motor.motor.inertia_kgm2 = file.motor.inertia_kgm2 * 1e-3;  // as fast as its bus turns it
  EXPECT_NEAR(start_bounds(file, motor).speed, m.no_load * 30 / kPi / file.scenario.speed_rpm, 1e-3);
}

TEST(StartBounds, ALockTakesAsLongAsTheTorqueNeeds) {
  const Settings file = settings_of("m2310p_servo");
  Settings motor = file;
  EXPECT_EQ(start_bounds(file).lock_s, 5);
  motor.motor.inertia_kgm2 = 1;
  const double heavy = start_bounds(file, motor).lock_s;
  motor.scenario.start_speed_rpm = -motor.scenario.speed_rpm;
  EXPECT_GT(start_bounds(file, motor).lock_s, heavy);
  motor.load.opposing_nm = 100;
  EXPECT_TRUE(std::isinf(start_bounds(file, motor).lock_s));
}

TEST(StartBounds, WhatTheFileDeclaresRules) {
  for (const char* name : {"m2310p_servo", "m2310p_sinusoidal"}) {
    Settings s = settings_of(name);
    s.bounds = {.current_a = 11, .kick_deg = 12, .speed = 1.3, .lock_s = 0.14};
    const StartBounds b = start_bounds(s);
    EXPECT_EQ(b.current_a, 11);
    EXPECT_EQ(b.kick_deg, 12);
    EXPECT_EQ(b.speed, 1.3);
    EXPECT_EQ(b.lock_s, 0.14);
    EXPECT_EQ(current_bound(s), 11);
  }
}

}  // namespace
}  // namespace steplock::design
