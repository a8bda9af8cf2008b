#include "model/design/bounds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "model/design/rules.hpp"
#include "model/design/sinusoidal/design.hpp"

namespace steplock::design {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kLeastOvershoot = 0.1, kLeastLock = 5, kLeastKick = 720;
constexpr double kStepsToTell = 3;  // of a follower, until a rotor's direction is known for sure

// Fundamental over the peak of the back-EMF; of a table, that of a square wave, since no shape has more.
double fundamental(const MotorSection& m) {
  if (m.shape == Shape::kSinusoidal) return 1;
  const double flank = m.shape == Shape::kTrapezoidal ? (180 - m.flat_top_deg) / 2 * kPi / 180 : 0;
  return 4 / kPi * (flank > 0 ? std::sin(flank) / flank : 1);
}

// rpm against the wanted direction when the run begins.
double backwards(const ScenarioSection& n) { return std::max(0.0, n.start_speed_rpm * (n.reverse ? 1 : -1)); }

// Speed and target are of one unit.
double passes_by(double speed, double target) { return 1 + std::max(kLeastOvershoot, speed / target); }

double highest_sinusoidal_speed(const Settings& file, const Settings& motor) {
  const sinusoidal::SpeedRegulator p = sinusoidal::design_drive(file).parameters.speed;
  const double pairs = motor.motor.pole_pairs;
  const double per_ampere =
      pairs * pairs * std::sqrt(1.5) * motor.motor.flux_vs / (motor.motor.inertia_kgm2 + motor.load.inertia_kgm2);
  const SpeedLoop loop{.gain = per_ampere, .pole = 0, .kp = p.kp, .ki = p.ki};
  return passes_by(std::min(p.slew, p.limit * per_ampere) * ramp_overshoot(loop), p.target);
}

double highest_speed(const Settings& file, const Settings& motor) {
  if (file.drive.kind == DriveKind::kSinusoidal) return highest_sinusoidal_speed(file, motor);
  const SpeedParameters p = design_drive(file).parameters.speed;
  const MotorConstants m = motor_constants(motor);
  const int pairs = motor.motor.pole_pairs;
  const double limit = acceleration(m, motor.sensors.limit_a, pairs);
  const SpeedLoop loop = speed_loop(p, m, motor.inverter.bus_v, pairs);
  // The duty at hand-over is the back-EMF's: it does not know the load.
  const double decelerates = (motor.load.opposing_nm + motor.motor.coulomb_nm) / m.k_e;
  const double settled = passes_by(std::min(p.slew, limit) * ramp_overshoot(loop) +
                                       acceleration(m, decelerates, pairs) * load_rebound(loop),
                                   p.target);
  if (file.start.method == Method::kRamp) return settled;
  // Driven by the limit through three edges, and no faster than the bus turns it.
  const double found = std::min(std::sqrt(2 * limit * kStepsToTell), steps_per_second(motor, m.no_load * 30 / kPi));
  return std::max(settled, found / p.target);
}

double longest_lock(const Settings& file, const Settings& motor) {
  const Design d = design_drive(file);
  const MotorConstants m = motor_constants(motor);
  const double current = std::min(motor.sensors.limit_a, motor.inverter.bus_v / m.r_loop);
  const double torque = m.k_e * current / 2 - motor.load.opposing_nm - motor.motor.coulomb_nm;
  if (torque <= 0) return std::numeric_limits<double>::infinity();
  const double turns = (backwards(motor.scenario) + d.hand_over_rpm) * kPi / 30;
  return std::max(kLeastLock, (1 + file.start.retries) * m.inertia * turns / torque);
}

}  // namespace

double shorted_current(const Settings& s, double rpm) {
  if (rpm == 0) return 0;
  const double w = std::abs(rpm) * kPi / 30 * s.motor.pole_pairs;
  const double r = s.motor.resistance_ohm + s.inverter.on_resistance_ohm;
  const double x = w * s.motor.inductance_d_h.value_or(s.motor.inductance_h - s.motor.mutual_h);
  return (1.02 + 0.98 * std::exp(-3 * r / x)) * fundamental(s.motor) * s.motor.flux_vs * w / std::hypot(r, x);
}

double limited_current(const Settings& s) {
  const double line = 2 * s.motor.inductance_d_h.value_or(s.motor.inductance_h - s.motor.mutual_h);
  return s.sensors.limit_a + s.sensors.limit_hysteresis_a / 2 + 2 * s.inverter.bus_v / line * unbelieved(s);
}

double changing_over(const Settings& s, double rpm) {
  const double v = s.inverter.bus_v, u = motor_constants(s).k_e * std::abs(rpm) * kPi / 30;
  return 1 + std::max(0.0, (v - 2 * u) / (2 * v - u));
}

namespace {

// Pulled in by the ramp the rotor leads the field, and the idle winding carries, past the shunt, what its back-EMF drives.
double past_the_shunt(const Settings& file, const Settings& motor) {
  return file.start.method == Method::kRamp ? shorted_current(motor, motor.scenario.speed_rpm) : 0;
}

}  // namespace

StartBounds start_bounds(const Settings& file, const Settings& motor) {
  const bool six_step = file.drive.kind == DriveKind::kSixStep;
  const BoundsSection& b = file.bounds;
  StartBounds bounds;
  bounds.current_a = b.current_a ? *b.current_a
                     : six_step
                         ? std::max(limited_current(motor) * changing_over(motor, design_drive(file).hand_over_rpm) +
                                        past_the_shunt(file, motor),
                                    shorted_current(motor, backwards(motor.scenario)))
                         : sinusoidal::design_drive(file).parameters.protection.over_current;
  bounds.kick_deg = b.kick_deg ? *b.kick_deg : std::max(kLeastKick, 360.0 * motor.motor.pole_pairs);
  bounds.speed = b.speed ? *b.speed : highest_speed(file, motor);
  bounds.lock_s = b.lock_s ? *b.lock_s : six_step ? longest_lock(file, motor) : kLeastLock;
  return bounds;
}

double current_bound(const Settings& s) {
  const double start = start_bounds(s).current_a;
  const ScenarioSection& n = s.scenario;
  if (s.bounds.current_a || !(n.reverse_s || (n.stop_s && n.brake_to_stop))) return start;
  const double braked = s.drive.kind == DriveKind::kSixStep
                            ? kBrakedFrom * design_drive(s).hand_over_rpm
                            : sinusoidal::rpm_of(s, sinusoidal::design_drive(s).parameters.start.stop_speed);
  return std::max(start, shorted_current(s, braked));
}

}  // namespace steplock::design
