// Start: how much current, for how long, and how fast.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/design/rules.hpp"
#include "model/design/start.hpp"

namespace steplock::design {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kLatestHandOver = 0.4;  // of the set speed
constexpr double kMostTicks = 3900;      // of a ramp, with some to spare of its 4095
constexpr double kEdgesBetweenLooks = 1.5;
constexpr double kMostDuty = 1.999;  // of a word u1.15

// The lowest frequency at which this acceleration is followed.
double frequency_to_follow(const LoopParameters& l, double acceleration) {
  if (l.form == LoopForm::kPerStep) return std::sqrt(acceleration / followed(l, 1));
  return 0;  // independent of the frequency: the ramp is what it is
}

// What a start must overcome in the worst corner of the envelope.
struct Heaviest {
  double torque = 0;   // N m, dry: friction and load
  double share = 1;    // of the nominal torque that the start's duty then gives, beside `lost`
  double lost = 0;     // A, that diodes take there of the current in mean
  double inertia = 1;  // factor
};

Heaviest heaviest(const Settings& s, const MotorConstants& m) {
  const auto& v = s.envelope;
  double load = 0;
  for (const double l : v.load) load = std::max(load, l);
  // Chopped on one side, the other part of the period puts two conducting diodes' drop on the phases;
  // with a bus that gives less, that does not become less.
  const double drop = s.control.chopping == Chopping::kComplementary ? 0 : s.inverter.diode_drop_v;
  return {.torque = s.motor.coulomb_nm + s.load.opposing_nm + load * m.k_e * s.motor.rated_current_a,
          // The duty is a voltage: the current falls with the bus, and as resistance grows.
          .share = v.bus[0] / v.resistance[1] * v.flux[0],
          .lost = (1 - v.bus[0]) * drop / (v.bus[0] * m.r_loop),
          .inertia = v.inertia[1]};
}

}  // namespace

void set_start(const Settings& s, Design& d) {
  const auto& t = s.start;
  auto& p = d.parameters.start;
  const auto& m = d.motor;
  const double steps = 6 * s.motor.pole_pairs / (2 * kPi);  // per mechanical radian
  const double friction = s.motor.coulomb_nm + s.load.opposing_nm;
  const Heaviest heavy = heaviest(s, m);
  const double set = steps_per_second(s, s.scenario.speed_rpm);
  const double highest =
      t.hand_over_rpm ? steps_per_second(s, *t.hand_over_rpm) : kLatestHandOver * set;
  const double inertia = heavy.inertia * m.inertia;
  // The largest inertia to hand-over before a ramp is over.
  const double swing = inertia * highest / steps / (kMostTicks * d.parameters.pwm.tick());
  d.start_current = t.start_current_a.value_or(
      std::max(s.motor.rated_current_a / 2,
               std::max(1.3 * heavy.torque, 1.15 * heavy.torque + swing) / heavy.share / m.k_e +
                   heavy.lost));
  d.align_current = t.align_current_a.value_or(d.start_current);
  d.kappa = t.kappa_nm > 0 ? t.kappa_nm
                           : align_stiffness(s.motor.flux_vs, s.motor.pole_pairs, d.align_current);
  d.align_time_formula = align_time(d.kappa, m.inertia, t.gamma);
  // The shorted windings damp the swing with twice tau_m: five of those leave 8 % of it.  Of a heavy rotor, what the word holds.
  p.align = t.align_s.value_or(
      std::min(std::max(d.align_time_formula, 5 * m.tau_m), kMostTicks * d.parameters.pwm.tick()));
  p.pre_align = t.pre_align_s.value_or(p.align / 2);
  // Two phases in parallel, in series with the third.
  p.align_duty = duty_for(s, d.align_current, 0.75 * m.r_loop);
  p.start_duty = duty_for(s, d.start_current, m.r_loop);

  const double spare = std::max(0.1 * m.k_e * d.start_current, m.k_e * d.start_current - friction);
  const double full = spare / m.inertia * steps;  // steps/s^2
  const auto& e = s.sensors;
  double offset = 0;
  for (const double o : e.comparator_offset_v) offset = std::max(offset, std::abs(o));
  const double doubt = offset + e.comparator_hysteresis_v / 2 + 3 * e.comparator_noise_v;
  const double seen = 10 * doubt / s.motor.flux_vs * 6 / (2 * kPi);  // steps/s
  const double derived =
      std::clamp(std::max(seen, frequency_to_follow(d.parameters.loop, full / 2)), 0.04 * set,
                 kLatestHandOver * set);
  p.hand_over = t.hand_over_rpm ? steps_per_second(s, *t.hand_over_rpm) : derived;

  // Each failed attempt takes a quarter of the ramp, the last one what the heaviest load can follow.
  const double left = heavy.share * m.k_e * (d.start_current - heavy.lost) - heavy.torque;
  const double gentlest = std::max(0.7 * left / inertia * steps,
                                   p.hand_over / (kMostTicks * d.parameters.pwm.tick()));
  p.ramp = gentlest;
  for (int k = std::min(t.retries, 3); k > 0 && 4 * p.ramp < 0.4 * full; --k) p.ramp *= 4;
  p.ramp = std::min(p.ramp, most_ramp(d.parameters.loop, d.parameters.pwm.tick(), s.control.clock_hz));
  std::optional<double> time = t.t_a_s;
  if (!time && t.xi && t.k_v) time = acceleration_time(*t.xi, m.inertia, *t.k_v, m.k_e);
  if (time) p.ramp = p.hand_over / *time;
  if (t.ramp_rpm_s) p.ramp = steps_per_second(s, *t.ramp_rpm_s);
  d.acceleration_time = p.hand_over / p.ramp;
  d.hand_over_rpm = rpm_of(s, p.hand_over);
  d.ramp_rpm_s = rpm_of(s, p.ramp);

  p.window = t.window_deg / 60;
  p.good_crossings = t.good_crossings;
  p.pull_in = t.pull_in_s.value_or(1.0);
  // Enough changes of sector at hand-over speed; what turns slower, the alignment stops.
  p.detect_spin = t.detect_spin_s.value_or(std::clamp((p.good_crossings + 8) / p.hand_over, 0.005, 0.5));
  p.slow_down = t.slow_down_s.value_or(2.0);
  p.brake = t.brake_s.value_or(std::clamp(2 * m.tau_m, 0.02, 0.6));
  // Shorting the motor brakes with e / R; chopped, only with what exceeds (1 - duty) of the bus: so the duty of a current at
  // standstill, less the back-EMF's.
  const double brake_current = t.brake_current_a.value_or(0.7 * s.sensors.limit_a);
  p.brake_duty = std::min(1 + brake_current * m.r_loop / s.inverter.bus_v, kMostDuty);
  p.retry_delay = t.retry_delay_s;
  p.retries = t.retries;
  p.method = t.method;
}

// The start that follows the rotor: nothing but looks and drives, whose times are bounds.
void set_follower(const Settings& s, Design& d) {
  const auto& t = s.start;
  const auto& e = s.envelope;
  const auto& m = d.motor;
  auto& p = d.parameters.start;
  const double bus = s.inverter.bus_v;
  // The limit's current, or what bus and winding let flow.
  const double most = std::min(s.sensors.limit_a, e.bus[1] * bus / (e.resistance[0] * m.r_loop));
  // Two diodes and the lowest bus take the commutated current down, a tenth slower than that.
  const double line = 2 * (s.motor.inductance_h - s.motor.mutual_h) * e.inductance[1];
  const double decay = 1.1 * line * s.sensors.limit_a / (e.bus[0] * bus + 2 * s.inverter.diode_drop_v);
  // The lightest rotor through 60 electrical degrees, and the heaviest with a third of the torque.
  const double torque = m.k_e * e.flux[1] * most;
  const double lightest =
      std::sqrt(2 * kPi / 3 / s.motor.pole_pairs * e.inertia[0] * m.inertia / torque);
  const double heaviest = lightest * std::sqrt(3 * e.inertia[1] / e.inertia[0]);
  p.look = t.look_s.value_or(decay);
  // Nor so long that a rotor which turns backwards, too slowly for the brake, passes three edges between two looks: then
  // their order tells no direction.
  const double told = kEdgesBetweenLooks / (kBrakedFrom * p.hand_over) - decay;
  const double word = kMostSamples * d.parameters.bemf.sample_every;
  p.probe = t.probe_s.value_or(std::min(std::max(std::min(0.35 * lightest, told), 1.5 * decay), word));
  // What cannot turn is to be told in 5 s: three steps an attempt, and a second for codes that only quiver.
  const double attempt = 4.0 / (1 + p.retries) - p.detect_spin - p.retry_delay;
  const double patience = std::min(1.5 * heaviest, std::max(1.2 * heaviest, attempt / 3));
  p.still = int(std::lround(t.still.value_or(std::clamp(patience / (p.probe + p.look), 2.0, 250.0))));
  // So much that the current limit rules.
  d.start_current = t.start_current_a.value_or(1.5 * s.sensors.limit_a);
  p.start_duty = std::min(0.95, duty_for(s, d.start_current, m.r_loop));
  p.align_duty = t.find_duty.value_or(0.95);
}

}  // namespace steplock::design
