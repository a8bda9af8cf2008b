// Speed control: gains from the motor's pole, and a ramp of the set speed that loop, torque and settling allow.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "model/design/rules.hpp"
#include "model/design/config.hpp"

namespace steplock::design {
namespace {

constexpr double kPi = std::numbers::pi;

double steps_per_radian(int pole_pairs) { return 6 * pole_pairs / (2 * kPi); }

// The steepest ramp up to `most`, steps/s^2, at whose end no rotor of the envelope passes the set speed by more than 5 %,
// of the tenth that a start may: the dip in which it meets its load, ticks and the duty's slew take the rest.  With the least
// flux, which damps least, on either bus: which one swings further depends on how long the ramp is.  A rotor that is too heavy
// for the ramp follows the limit's current.
double settles(const Settings& s, const Design& d, double most) {
  constexpr double kPasses = 0.05;
  constexpr int kInertias = 16;
  const auto& p = d.parameters.speed;
  const auto& e = s.envelope;
  std::array<RampedLoop, 2 * (kInertias + 1)> loops;
  auto* next = loops.begin();
  for (int k = 0; k <= kInertias; ++k) {
    MotorConstants m = d.motor;
    m.k_e *= e.flux[0];
    m.inertia *= e.inertia[0] * std::pow(e.inertia[1] / e.inertia[0], double(k) / kInertias);
    for (const double bus : e.bus) {
      *next++ = {.loop = speed_loop(p, m, bus * s.inverter.bus_v, s.motor.pole_pairs),
                 .limit = acceleration(m, s.sensors.limit_a, s.motor.pole_pairs)};
    }
  }
  return steepest_ramp(loops, p.target - d.parameters.start.hand_over, kPasses * p.target, most);
}

}  // namespace

SpeedLoop speed_loop(const SpeedParameters& p, const MotorConstants& m, double bus_v, int pole_pairs) {
  const double slowness = m.r_loop * m.inertia;
  return {.gain = bus_v * m.k_e / slowness * steps_per_radian(pole_pairs),
          .pole = m.k_e * m.k_e / slowness,
          .kp = p.kp,
          .ki = p.ki};
}

double acceleration(const MotorConstants& m, double current, int pole_pairs) {
  return m.k_e * current / m.inertia * steps_per_radian(pole_pairs);
}

void set_speed(const Settings& s, Design& d) {
  const auto& v = s.speed;
  auto& p = d.parameters.speed;
  const auto& m = d.motor;
  const auto& loop = d.parameters.loop;
  const double steps = steps_per_radian(s.motor.pole_pairs), bus = s.inverter.bus_v;
  const double f_a = d.parameters.start.hand_over;
  const double loop_bandwidth =
      loop.form == LoopForm::kPerStep ? d.bandwidth * f_a : d.components.omega_g();
  // Of a heavy rotor, what the word of kp holds.
  const double per_kp = m.tau_m * m.k_e / bus / steps;
  const double bandwidth = v.bandwidth_rad_s.value_or(std::min(
      {loop_bandwidth / 4, 0.1 / d.parameters.pwm.tick(), most_duty_per_speed(loop, s.control.clock_hz) / per_kp}));
  const double per_rpm = 1 / steps_per_second(s, 1.0);
  p.target = steps_per_second(s, s.scenario.speed_rpm);
  p.kp = bandwidth * per_kp;
  // The motor is a pole at 1 / tau_m.  A fast one is cancelled; else the loop's poles coincide.
  const double pole = 1 / m.tau_m, sum = pole + bandwidth;
  p.ki = p.kp * (pole > bandwidth ? pole : sum * sum / (4 * bandwidth));
  if (v.kp_duty_per_rpm) p.kp = *v.kp_duty_per_rpm * per_rpm;
  if (v.ki_duty_per_rpm_s) p.ki = *v.ki_duty_per_rpm_s * per_rpm;
  p.bemf = m.k_e / bus / steps;
  // Each step builds up the current of two phases in series anew, which takes volt-seconds.
  const double commutation = 2 * (s.motor.inductance_h - s.motor.mutual_h) * s.sensors.limit_a;
  // Above its word, which stands for the whole duty at a sixteenth of the highest speed, nothing slips but at a crawl.
  p.loaded = std::min(kCorner * (p.bemf + commutation / bus), most_duty_per_speed(loop, s.control.clock_hz));

  const double friction = s.motor.coulomb_nm + s.load.opposing_nm;
  const double torque = m.k_e * s.motor.rated_current_a;
  const double able = 0.4 * std::max(0.1 * torque, torque - friction) / m.inertia * steps;
  const double steepest = v.slew_rpm_s ? steps_per_second(s, *v.slew_rpm_s) : std::min(able, followed(loop, f_a));
  p.slew = v.slew_rpm_s ? steepest : settles(s, d, steepest);
  // The duty has to turn a heavy rotor's acceleration off sooner than a ramp turns it on.
  p.duty_slew = v.duty_slew_per_s.value_or(
      std::max(3 * steepest * p.bemf, s.motor.rated_current_a * m.r_loop / bus / 0.02));
  p.minimum = v.minimum_duty;
  p.maximum = v.maximum_duty;
}

}  // namespace steplock::design
