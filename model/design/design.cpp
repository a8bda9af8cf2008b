// See design.hpp for the rules; problems() is in problems.cpp.
#include "model/design/design.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "model/design/ramp_overshoot.hpp"
#include "model/design/start.hpp"

namespace steplock::design {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kLatestHandOver = 0.4;  // of the set speed
constexpr double kMostTicks = 3900;      // of a ramp, with some to spare of its 4095
constexpr double kFollow = 10.0 / 60;  // turns of a step: error that an acceleration may cause
constexpr double kEdgesBetweenLooks = 1.5;
constexpr double kCorner = 1.5;        // of the default envelope: 1.2 / 0.8, of what is more to what is less than the file says

// Back-EMF shape of phase u at an electrical angle, peak 1.
double shape_at(const MotorSection& m, double degrees) {
  const double a = degrees - 360 * std::floor(degrees / 360);
  switch (m.shape) {
    case Shape::kSinusoidal:
      return std::sin(a * kPi / 180);
    case Shape::kTable: {
      if (m.table.empty()) return 0;
      const double place = a / 360 * double(m.table.size());
      const auto k = std::size_t(place);
      const double next = m.table[(k + 1) % m.table.size()];
      return m.table[k % m.table.size()] +
             (place - double(k)) * (next - m.table[k % m.table.size()]);
    }
    default: {
      const double flank = (180 - m.flat_top_deg) / 2;  // from zero to the top
      const double half = a < 180 ? a : a - 180, from_zero = std::min(half, 180 - half);
      return (a < 180 ? 1 : -1) * std::min(1.0, from_zero / flank);
    }
  }
}

// Mean of shape_u - shape_v over step 0, where U and V conduct.
double mean_line_shape(const MotorSection& m) {
  double sum = 0;
  for (int k = 0; k < 60; ++k) sum += shape_at(m, 30.5 + k) - shape_at(m, 30.5 + k - 120);
  return sum / 60;
}

double duty_for(const Settings& s, double current, double resistance) {
  const auto& i = s.inverter;
  const double dead = i.dead_time_s * s.control.pwm_hz;  // each pulse begins that much later
  const double duty = s.control.chopping == Chopping::kComplementary
                          ? current * resistance / i.bus_v
                          : (current * resistance + i.diode_drop_v) / (i.bus_v + i.diode_drop_v);
  return std::clamp(duty + dead, 0.0, s.speed.maximum_duty);
}

// s.  At a standstill the bus drives the current up while the comparator is not believed, and resistance alone takes it down
// in the off-time: one that is shorter than this lets it climb from pulse to pulse.
double off_time(const Settings& s) {
  constexpr double kShortest = 20e-6, kLongest = 4095;  // s; clocks, the word
  const double off = kCorner * unbelieved(s) * s.inverter.bus_v / (s.sensors.limit_a * motor_constants(s).r_loop);
  return std::clamp(off, kShortest, kLongest / s.control.clock_hz);
}

void set_bridge(const Settings& s, Parameters& p) {
  const auto& c = s.control;
  p.source = c.source;
  p.pwm = {.period = 1 / c.pwm_hz,
           .minimum = c.minimum_pulse_s,
           .dead_time = s.inverter.dead_time_s,
           .centred = c.centred,
           .complementary = c.chopping == Chopping::kComplementary,
           .tick_periods = std::max(1, int(std::lround(c.tick_s.value_or(1e-3) * c.pwm_hz)))};
  p.limit = {.blanking = c.limit_blanking_s, .off_time = c.limit_off_time_s.value_or(off_time(s))};
  p.bemf = {.sampling = c.sampling,
            .blanking = c.blanking_s,
            .sample_every = c.sample_every_s,
            .samples = c.samples};
}

int steps_per_update(const LoopParameters& l) { return l.detector == Detector::kEveryStep ? 1 : 6; }

void set_loop(const Settings& s, Design& d) {
  const auto& l = s.loop;
  auto& p = d.parameters.loop;
  p = {.detector = l.detector,
       .form = l.form,
       .divide = l.divide,
       .expected = 0.5 + l.advance_deg / 60,
       .lead_error = l.lead_error_deg.value_or(l.detector == Detector::kEveryStep ? 15 : 29) / 60,
       .delay = l.delay_s.value_or(s.sensors.comparator_delay_s)};
  p.maximum = steps_per_second(s, l.maximum_rpm.value_or(1.3 * d.motor.no_load * 30 / kPi));
  // Once per turn the loop must be slower, and push harder where the rotor only seems to follow.
  d.bandwidth = l.bandwidth.value_or(l.detector == Detector::kEveryStep ? 0.4 : 0.1);
  if (l.form == LoopForm::kPerStep) {
    const PerStep f =
        per_step(d.bandwidth, l.damping, l.pole_ratio.value_or(0), steps_per_update(p));
    p.integral = f.integral, p.proportional = f.proportional, p.pole = f.pole;
    d.continuous = d.sampled = margins(open_loop(f), 1e-3, kPi * 0.999);
    return;
  }
  d.specification = {.rho = l.rho,
                     .zeta = l.zeta,
                     .lambda = l.lambda,
                     .n_c = l.n_c,
                     .f_m = l.f_m_hz.value_or(s.scenario.speed_rpm / 60 * s.motor.pole_pairs),
                     .k_l = l.k_l.value_or(0.0189)};
  d.components = components(d.specification);
  if (l.r_ohm) d.components.r = *l.r_ohm;
  if (l.c1_f) d.components.c1 = *l.c1_f;
  if (l.c2_f) d.components.c2 = *l.c2_f;
  d.k_l = l.k_l.value_or(loop_gain_for(d.components));
  const PerSecond f = per_second(d.components, d.k_l);
  p.integral = f.integral, p.proportional = f.proportional, p.pole = f.omega_p;
  d.continuous = margins(open_loop(f), f.omega_p * 1e-3, f.omega_p * 1e3);
}

// The acceleration, in steps/s^2, that the loop follows with kFollow of a step at this frequency.
double followed(const LoopParameters& l, double frequency) {
  const bool per_step = l.form == LoopForm::kPerStep;
  return kFollow * l.integral * (per_step ? frequency * frequency / steps_per_update(l) : 1);
}

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
  d.reset_current = t.reset_current_a.value_or(d.start_current);
  d.kappa = t.kappa_nm > 0 ? t.kappa_nm
                           : reset_stiffness(s.motor.flux_vs, s.motor.pole_pairs, d.reset_current);
  d.reset_time_formula = reset_time(d.kappa, m.inertia, t.gamma);
  // The shorted windings damp the swing with twice tau_m: five of those leave 8 % of it.
  p.reset = t.reset_s.value_or(std::max(d.reset_time_formula, 5 * m.tau_m));
  p.settle = t.settle_s.value_or(p.reset / 2);
  // Two phases in parallel, in series with the third.
  p.reset_duty = duty_for(s, d.reset_current, 0.75 * m.r_loop);
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

  // Each failed try takes a quarter of the ramp, the last one what the heaviest load can follow.
  const double left = heavy.share * m.k_e * (d.start_current - heavy.lost) - heavy.torque;
  const double gentlest = std::max(0.7 * left / inertia * steps,
                                   p.hand_over / (kMostTicks * d.parameters.pwm.tick()));
  p.ramp = gentlest;
  for (int k = std::min(t.retries, 3); k > 0 && 4 * p.ramp < 0.4 * full; --k) p.ramp *= 4;
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
  // Enough changes of sector at hand-over speed; what turns slower, the reset stops.
  p.observe = t.observe_s.value_or(std::clamp((p.good_crossings + 8) / p.hand_over, 0.005, 0.5));
  p.slow_down = t.slow_down_s.value_or(2.0);
  p.brake = t.brake_s.value_or(std::clamp(2 * m.tau_m, 0.02, 0.6));
  // Shorting the motor brakes with e / R; chopped, only with what exceeds (1 - duty) of the bus.
  const double brake_current = t.brake_current_a.value_or(2 * s.motor.rated_current_a);
  const double e_brake = m.k_e * kBrakedFrom * p.hand_over / steps;
  p.brake_duty = std::clamp(1 - (e_brake - brake_current * m.r_loop) / s.inverter.bus_v, 0.0, 1.0);
  p.rest = t.rest_s;
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
  p.probe = t.probe_s.value_or(std::max(std::min(0.35 * lightest, told), 1.5 * decay));
  p.still = int(std::lround(t.still.value_or(std::clamp(1.5 * heaviest / (p.probe + p.look), 2.0, 250.0))));
  // So much that the current limit rules.
  d.start_current = t.start_current_a.value_or(1.5 * s.sensors.limit_a);
  p.start_duty = std::min(0.95, duty_for(s, d.start_current, m.r_loop));
  p.reset_duty = t.find_duty.value_or(0.95);
}

// The steepest ramp up to `most`, steps/s^2, at whose end no rotor of the envelope passes the set speed by more than 8 %,
// of the tenth that a start may: ticks and the duty's slew take the rest.  With the most bus and the least flux, which damps
// least; a rotor that is too heavy for the ramp follows the limit's current.
double settles(const Settings& s, const Design& d, double most) {
  constexpr double kPasses = 0.08, kFiner = 1.05;
  constexpr int kInertias = 16;
  const auto& p = d.parameters.speed;
  const auto& e = s.envelope;
  const auto& m = d.motor;
  const double steps = 6 * s.motor.pole_pairs / (2 * kPi), flux = e.flux[0];
  const double rise = p.target - d.parameters.start.hand_over;
  double steepest = most;
  for (int k = 0; k <= kInertias; ++k) {
    const double inertia = e.inertia[0] * std::pow(e.inertia[1] / e.inertia[0], double(k) / kInertias);
    const double limit = flux * m.k_e * s.sensors.limit_a / (m.inertia * inertia) * steps;
    const SpeedLoop loop{.gain = e.bus[1] * flux / (p.bemf * m.tau_m * inertia),
                         .pole = flux * flux / (m.tau_m * inertia),
                         .kp = p.kp,
                         .ki = p.ki};
    // From a ramp that is right whatever its length.
    double slew = kPasses * p.target / ramp_overshoot(loop);
    while (slew < std::min(steepest, limit) &&
           kFiner * slew * ramp_overshoot(loop, rise / (kFiner * slew)) <= kPasses * p.target) {
      slew *= kFiner;
    }
    if (slew < limit) steepest = std::min(steepest, slew);
  }
  return steepest;
}

void set_speed(const Settings& s, Design& d) {
  const auto& v = s.speed;
  auto& p = d.parameters.speed;
  const auto& m = d.motor;
  const auto& loop = d.parameters.loop;
  const double steps = 6 * s.motor.pole_pairs / (2 * kPi), bus = s.inverter.bus_v;
  const double f_a = d.parameters.start.hand_over;
  const double loop_bandwidth =
      loop.form == LoopForm::kPerStep ? d.bandwidth * f_a : d.components.omega_g();
  const double bandwidth =
      v.bandwidth_rad_s.value_or(std::min(loop_bandwidth / 4, 0.1 / d.parameters.pwm.tick()));
  const double per_rpm = 1 / steps_per_second(s, 1.0);
  p.target = steps_per_second(s, s.scenario.speed_rpm);
  p.kp = bandwidth * m.tau_m * m.k_e / bus / steps;
  // The motor is a pole at 1 / tau_m.  A fast one is cancelled; else the loop's poles coincide.
  const double pole = 1 / m.tau_m, sum = pole + bandwidth;
  p.ki = p.kp * (pole > bandwidth ? pole : sum * sum / (4 * bandwidth));
  if (v.kp_duty_per_rpm) p.kp = *v.kp_duty_per_rpm * per_rpm;
  if (v.ki_duty_per_rpm_s) p.ki = *v.ki_duty_per_rpm_s * per_rpm;
  p.bemf = m.k_e / bus / steps;
  // Each step builds up the current of two phases in series anew, which takes volt-seconds.
  const double commutation = 2 * (s.motor.inductance_h - s.motor.mutual_h) * s.sensors.limit_a;
  p.loaded = kCorner * (p.bemf + commutation / bus);

  const double friction = s.motor.coulomb_nm + s.load.opposing_nm;
  const double torque = m.k_e * s.motor.rated_current_a;
  const double able = 0.4 * std::max(0.1 * torque, torque - friction) / m.inertia * steps;
  p.slew = v.slew_rpm_s ? steps_per_second(s, *v.slew_rpm_s)
                        : settles(s, d, std::min(able, followed(loop, f_a)));
  p.duty_slew = v.duty_slew_per_s.value_or(
      std::max(3 * p.slew * p.bemf, s.motor.rated_current_a * m.r_loop / bus / 0.02));
  p.minimum = v.minimum_duty;
  p.maximum = v.maximum_duty;
}

void set_protection(const Settings& s, Design& d) {
  const auto& q = s.protection;
  auto& p = d.parameters.protection;
  p.misses = q.misses;
  // With Hall sensors a start is no start but speed control from standstill: of the speed that its slew has reached after the
  // six steps that a stall takes, half.
  const double least = 0.4 * d.parameters.start.hand_over;
  const double derived = s.control.source == Source::kHall ? std::min(least, std::sqrt(3 * d.parameters.speed.slew)) : least;
  p.stall = q.stall_rpm ? steps_per_second(s, *q.stall_rpm) : derived;
  p.slip =
      q.slip_duty.value_or(std::min(2.0, kCorner * duty_for(s, s.sensors.limit_a, d.motor.r_loop)));
  p.freewheel = q.freewheel_deg / 60;
  p.wrong_lock = q.wrong_lock_s;
  p.over_current = q.over_current;
}

}  // namespace

double steps_per_second(const Settings& s, double rpm) { return rpm * s.motor.pole_pairs / 10; }
double rpm_of(const Settings& s, double f) { return f * 10 / s.motor.pole_pairs; }

double unbelieved(const Settings& s) {
  constexpr double kClocks = 4;  // synchroniser, decision, gate
  return s.control.limit_blanking_s + s.sensors.limit_delay_s + kClocks / s.control.clock_hz;
}

MotorConstants motor_constants(const Settings& s) {
  MotorConstants m;
  m.k_e = mean_line_shape(s.motor) * s.motor.flux_vs * s.motor.pole_pairs;
  m.r_loop = 2 * (s.motor.resistance_ohm + s.inverter.on_resistance_ohm);
  m.inertia = s.motor.inertia_kgm2 + s.load.inertia_kgm2;
  m.tau_m = m.inertia * m.r_loop / (m.k_e * m.k_e);
  m.tau_e = 2 * (s.motor.inductance_h - s.motor.mutual_h) / m.r_loop;
  m.no_load = s.inverter.bus_v / m.k_e;
  return m;
}

double load_step_torque(const Settings& s) {
  return s.scenario.load_step_nm.value_or(0.5 * motor_constants(s).k_e * s.motor.rated_current_a);
}

Design design_drive(const Settings& s) {
  Design d;
  d.motor = motor_constants(s);
  d.rated_torque = d.motor.k_e * s.motor.rated_current_a;
  set_bridge(s, d.parameters);
  set_loop(s, d);
  set_start(s, d);
  if (s.start.method == Method::kFollow) set_follower(s, d);
  const auto& start = d.parameters.start;
  auto& loop = d.parameters.loop;
  loop.minimum =
      s.loop.minimum_rpm ? steps_per_second(s, *s.loop.minimum_rpm) : start.hand_over / 4;
  if (loop.form == LoopForm::kPerSecond) {
    const double interval = steps_per_update(loop) / start.hand_over;
    d.sampled = margins(
        open_loop_sampled(per_second(d.components, d.k_l), d.parameters.pwm.tick(), interval),
        loop.pole * 1e-3, kPi / d.parameters.pwm.tick() * 0.999);
  }
  set_speed(s, d);
  set_protection(s, d);
  return d;
}

}  // namespace steplock::design
