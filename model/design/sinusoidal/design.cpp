// See design.hpp for the rules.
#include "model/design/sinusoidal/design.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <sstream>

#include "model/design/believed.hpp"
#include "model/design/ramp_overshoot.hpp"

namespace steplock::design::sinusoidal {
namespace {

constexpr double kPi = std::numbers::pi;
const double kRoot = std::sqrt(1.5);  // power-invariant length of a peak

double longest(Modulation m, double v_dc) {
  return kRoot * v_dc * (m == Modulation::kSpaceVector ? 1 / std::numbers::sqrt3 : 0.5);
}

// How far resistance and inductance may be from what the file says.
constexpr double kMistaken = 0.2;

// rad/s, of the speed's regulator, whose filter is four times as fast.  An inductance that is mistaken
// by dL turns the estimate by dL i / K_E: kp (dL / K_E) filter is to be half, or the loop swings by itself.
double calm_bandwidth(const Settings& s, const Motor& m) {
  const double inertia = s.motor.inertia_kgm2 + s.load.inertia_kgm2;
  const double torque = m.pole_pairs * m.k_e;  // N m/A
  return std::sqrt(0.5 * torque * torque / (4 * inertia * kMistaken * m.inductance_q));
}

void set_motor(const Settings& s, Design& d) {
  auto& m = d.parameters.motor;
  const double round = s.motor.inductance_h - s.motor.mutual_h;
  m = {.resistance = s.motor.resistance_ohm + s.inverter.on_resistance_ohm,
       .inductance_d = s.motor.inductance_d_h.value_or(round),
       .inductance_q = s.motor.inductance_q_h.value_or(round),
       .k_e = s.sinusoidal.k_em * kRoot * s.motor.flux_vs,
       .pole_pairs = s.motor.pole_pairs};
  d.saliency = (m.inductance_q - m.inductance_d) / (m.inductance_q + m.inductance_d);
  d.rated_torque = 1.5 * m.pole_pairs * s.motor.flux_vs * s.motor.rated_current_a;
  d.no_load_rpm =
      rpm_of(s, longest(s.sinusoidal.modulation, s.inverter.bus_v) / (kRoot * s.motor.flux_vs));
  d.current_step = std::ldexp(current_range(s), 1 - s.adc.bits);
}

void set_estimators(const Settings& s, Design& d, double period) {
  auto& p = d.parameters;
  const double gain = s.sinusoidal.angle_gain;
  p.estimator = s.sinusoidal.estimator;
  p.current_model = {
      .k_e = p.motor.inductance_q / period * -std::expm1(-d.emf_bandwidth * period),
      .k_theta = gain * p.motor.inductance_q / p.motor.k_e};
  p.voltage_model = {.k_sp = gain / p.motor.k_e,
                     .k_si = 10 * gain / p.motor.k_e,
                     .samples = s.sinusoidal.moving_average};
  d.slowest_rpm = rpm_of(
      s, 0.5 * kRoot * d.current_step * p.motor.inductance_q / period / p.motor.k_e);
}

// rad/s^2 per A, the file's inertia.
double accelerates(const Settings& s, const Motor& m) {
  return m.pole_pairs * m.pole_pairs * m.k_e / (s.motor.inertia_kgm2 + s.load.inertia_kgm2);
}

// rad/s^2, of the set speed: the steepest up to `most` at whose end no rotor of the envelope passes the set speed by more than
// 6 %, of the tenth that a start may.  The filter takes the rest; a rotor that cannot follow the ramp, at the limit's current,
// ends with that acceleration.
double settles(const Settings& s, const SpeedRegulator& speed, double per_ampere, double most) {
  constexpr double kPasses = 0.06;
  constexpr int kInertias = 16;
  const auto& e = s.envelope;
  std::array<RampedLoop, kInertias + 1> loops;
  for (int k = 0; k <= kInertias; ++k) {
    const double inertia = e.inertia[0] * std::pow(e.inertia[1] / e.inertia[0], double(k) / kInertias);
    const SpeedLoop loop{.gain = e.flux[0] * per_ampere / inertia, .pole = 0, .kp = speed.kp, .ki = speed.ki};
    loops[k] = {.loop = loop, .limit = speed.limit * loop.gain};
  }
  return steepest_ramp(loops, speed.target, kPasses * speed.target, most);
}

void set_regulators(const Settings& s, Design& d) {
  auto& p = d.parameters;
  const auto& m = p.motor;
  const double b = d.current_bandwidth;
  const auto ki = [&](double inductance) {
    return b * inductance * std::max(m.resistance / inductance, b / 6);
  };
  p.current = {.kp_gamma = b * m.inductance_d, .kp_delta = b * m.inductance_q,
               .ki_gamma = ki(m.inductance_d), .ki_delta = ki(m.inductance_q),
               .i_gamma = kRoot * s.sinusoidal.i_gamma_a};
  const double per_ampere = accelerates(s, m);
  p.speed.target = speed_of(s, s.scenario.speed_rpm);
  p.speed.filter = 4 * d.speed_bandwidth;
  p.speed.kp = d.speed_bandwidth / per_ampere;
  p.speed.ki = p.speed.kp * d.speed_bandwidth / 5;
  p.speed.limit = kRoot * current_limit(s);
}

void set_start(const Settings& s, Design& d) {
  const auto& z = s.sinusoidal_start;
  auto& p = d.parameters;
  const double rated = s.motor.rated_current_a;
  auto& t = p.start;
  t.by = z.by;
  t.pattern_current = z.pattern_current_a.value_or(rated);
  // The held rotor swings with w^2 = pole_pairs torque / J: two dozen radians of it, in three thirds.  Where
  // friction is little, nothing but the back-EMF, through the winding, ends the swing: a fifth of the heaviest rotor's is left
  // after each third.
  const double inertia = s.motor.inertia_kgm2 + s.load.inertia_kgm2;
  const double stiffness = p.motor.pole_pairs * d.rated_torque * t.pattern_current / rated;
  const double link = p.motor.pole_pairs * s.motor.flux_vs;  // V s/rad
  const double fades = 2 * s.envelope.inertia[1] * inertia * (p.motor.resistance) / (1.5 * link * link);
  t.pattern_s = z.pattern_s.value_or(
      std::clamp(std::max(24 * std::sqrt(inertia / stiffness), 3 * std::log(5.0) * fades), 0.05, 5.0) +
      10 * p.motor.inductance_q / p.motor.resistance);
  const double mistaken =
      kMistaken * p.motor.resistance * p.speed.limit / p.motor.k_e;  // rad/s, at rest
  const double lock = z.lock_rpm.value_or(
      std::max({0.02 * d.no_load_rpm, 4 * d.slowest_rpm, 1.1 * rpm_of(s, mistaken)}));
  t.lock_speed = speed_of(s, lock);
  t.stop_speed = speed_of(s, z.stop_rpm.value_or(lock));
  // Half a turn by a quarter of the rated torque: a rotor on the wrong side, which the current's limit turns back
  // faster than that, is through with what it makes the estimate do.
  const double per_ampere = accelerates(s, p.motor), quarter = 0.25 * kRoot * rated * per_ampere;
  const double half_turn = (std::sqrt(t.lock_speed * t.lock_speed + 2 * kPi * quarter) - t.lock_speed) / quarter;
  t.lock_s = z.lock_s.value_or(std::max(0.02, half_turn));
  // The set speed passes the lock's, below which the estimate is not to be believed, in no more time than the lock itself takes.
  const double soon = std::min(quarter, t.lock_speed / std::max(t.lock_s, 0.02));
  p.speed.slew = s.sinusoidal.slew_rpm_s ? speed_of(s, *s.sinusoidal.slew_rpm_s)
                                         : std::max(soon, settles(s, p.speed, per_ampere, quarter));
  // What takes the file's inertia along the set speed under the greatest load of its envelope.
  double load = 0;  // an envelope with a fan may name none
  for (const double l : s.envelope.load) load = std::max(load, l);
  const double holds = s.motor.coulomb_nm + s.load.opposing_nm + load * d.rated_torque;
  const double follows = p.speed.slew / per_ampere + holds / (p.motor.pole_pairs * p.motor.k_e);
  // A rotor without that load is ahead of the reference by i / kp before the regulator has taken the current away.
  const double ahead = 0.1 * p.speed.target * p.speed.kp;
  p.speed.start_current = z.start_current_a ? kRoot * *z.start_current_a : std::min({follows, ahead, p.speed.limit});
  t.give_up_s = z.give_up_s;
  t.brake_s = z.brake_s;
  t.retry_delay_s = z.retry_delay_s;
  t.retries = z.retries;

  const double mean = 2 / (1 / p.motor.inductance_d + 1 / p.motor.inductance_q);
  const double seconds_per_ampere = mean / (2.0 / 3 * s.inverter.bus_v);
  p.pilot = {.short_s = z.pilot_short_s.value_or(0.3 * rated * seconds_per_ampere),
             .long_s = z.pilot_long_s.value_or(1.2 * rated * seconds_per_ampere),
             .decayed = 0.005 * rated + 2 * d.current_step + 4 * s.adc.current_noise_a,
             .decay_s = 0.1,
             .repeats = z.pilot_repeats,
             .least_saliency = z.least_saliency,
             .least_polarity = z.least_polarity,
             .amperes_per_second = 1 / seconds_per_ampere};
  // A pulse rises over 1/0.8 of its length at most (config.cpp), and falls over about its length;
  // two samples without current and one on which it begins pass before the next.
  const auto turned = [&](double length, double part) {
    const double impulse = 1.5 * p.motor.pole_pairs * s.motor.flux_vs * part *
                           (length / seconds_per_ampere) * 1.125 * length;
    return p.motor.pole_pairs * impulse / inertia * (2.25 * length + 3 * p.pwm.period);
  };
  p.pilot.turned = std::max(turned(p.pilot.short_s, 1), turned(p.pilot.long_s, 0.556));
}

void set_protection(const Settings& s, Design& d) {
  const auto& g = s.sinusoidal_protection;
  d.parameters.protection = {.over_current = s.sensors.limit_a,
                             .saturated_s = g.saturated_s,
                             .slow_speed = speed_of(s, g.slow_rpm.value_or(d.slowest_rpm / 2)),
                             .slow_s = g.slow_s,
                             .emf_low = g.emf_low,
                             .emf_high = g.emf_high,
                             .emf_speed = d.parameters.start.lock_speed,
                             .emf_s = g.emf_s,
                             .lost_samples = g.lost_samples};
}

}  // namespace

double current_limit(const Settings& s) {
  return s.sinusoidal.current_limit_a.value_or(1.5 * s.motor.rated_current_a);
}

double current_range(const Settings& s) {
  return s.adc.current_a.value_or(4 * s.motor.rated_current_a);
}
double voltage_range(const Settings& s) { return s.adc.voltage_v.value_or(1.5 * s.inverter.bus_v); }

double speed_of(const Settings& s, double rpm) { return rpm * s.motor.pole_pairs * kPi / 30; }
double rpm_of(const Settings& s, double w) { return w * 30 / kPi / s.motor.pole_pairs; }

Design design_drive(const Settings& given) {
  const Settings s = as_believed(given);
  Design d;
  const double period = 1 / s.control.pwm_hz;
  set_motor(s, d);
  const auto& y = s.sinusoidal;
  d.current_bandwidth = y.current_bandwidth_rad_s.value_or(std::min(0.12 / period, 3000.0));
  d.speed_bandwidth = y.speed_bandwidth_rad_s.value_or(
      std::min({d.current_bandwidth / 4, 150.0, calm_bandwidth(s, d.parameters.motor)}));
  d.emf_bandwidth =
      y.emf_bandwidth_rad_s.value_or(std::min(4 * d.speed_bandwidth, 0.3 / period));
  d.parameters.pwm = {.period = period,
                      .dead_time = s.inverter.dead_time_s,
                      .minimum = s.control.minimum_pulse_s,
                      .modulation = y.modulation};
  d.parameters.applied = {.period = period,
                          .dead_time = s.inverter.dead_time_s,
                          .diode_drop = y.knows_drop ? s.inverter.diode_drop_v : 0,
                          .small_current = d.current_step,
                          .compensate = y.compensate};
  set_estimators(s, d, period);
  set_regulators(s, d);
  set_start(s, d);
  set_protection(s, d);
  return d;
}

std::vector<std::string> problems(const Settings& s) {
  std::vector<std::string> lines;
  const auto add = [&](const auto&... parts) {
    std::ostringstream line;
    (line << ... << parts);
    lines.push_back(line.str());
  };
  const Design d = design_drive(s);
  if (s.motor.shape != Shape::kSinusoidal) {
    add("motor.shape is not \"sinusoidal\"; must be for drive.kind = \"sinusoidal\"");
  }
  if (s.sinusoidal_start.by == StartBy::kPilot && d.saliency < 0.05) {
    add("sinusoidal_start.by is \"pilot\", but (L_q - L_d) / (L_q + L_d) is ", d.saliency,
        "; must be 0.05 or more: give inductance_d_h and inductance_q_h, or start by \"pattern\"");
  }
  if (s.sinusoidal_start.by == StartBy::kPilot && s.motor.saturation == 0) {
    add("sinusoidal_start.by is \"pilot\", but motor.saturation is 0; nothing shows the polarity then");
  }
  constexpr double kMostTurned = 2;  // electrical degrees, less than what the position may be off
  const double turned = d.parameters.pilot.turned * 180 / kPi;
  if (s.sinusoidal_start.by == StartBy::kPilot && turned > kMostTurned) {
    add("sinusoidal_start.by is \"pilot\", but a pulse turns the rotor by up to ", turned,
        " electrical degrees; must be ", kMostTurned,
        " or less: shorter pulses (pilot_short_s, pilot_long_s), or start by \"pattern\"");
  }
  if (s.scenario.speed_rpm > 0.9 * d.no_load_rpm) {
    add("scenario.speed_rpm is ", s.scenario.speed_rpm, " rpm; must be below ", 0.9 * d.no_load_rpm,
        " rpm, 90 % of what the bus voltage allows");
  }
  const double too_slow = rpm_of(s, d.parameters.protection.slow_speed);
  for (const double speed : s.scenario.set_speed_rpm) {
    if (speed < 1.1 * too_slow || speed > 0.9 * d.no_load_rpm) {
      add("scenario.set_speed_rpm has ", speed, " rpm; must be from ", 1.1 * too_slow, " to ", 0.9 * d.no_load_rpm,
          " rpm, what the estimator and the bus allow");
    }
  }
  const double lock = rpm_of(s, d.parameters.start.lock_speed);
  if (s.scenario.speed_rpm < 1.1 * lock) {
    add("scenario.speed_rpm is ", s.scenario.speed_rpm, " rpm; must be 10 % above ", lock,
        " rpm, where the estimate is first trusted");
  }
  if (s.sinusoidal_start.start_current_a.value_or(0) > current_limit(s)) {
    add("sinusoidal_start.start_current_a is ", *s.sinusoidal_start.start_current_a, " A; must be at most ", current_limit(s),
        " A, what the speed regulator may ask for (sinusoidal.current_limit_a)");
  }
  if (s.inverter.dead_time_s > 0.1 / s.control.pwm_hz) {
    add("inverter.dead_time_s is ", s.inverter.dead_time_s, " s; must be at most a tenth of the PWM period");
  }
  if (s.sensors.limit_a <= current_limit(s)) {
    add("sensors.limit_a is ", s.sensors.limit_a,
        " A; must be above the current that the speed regulator may ask for (sinusoidal.current_limit_a)");
  }
  if (s.adc.current_a && *s.adc.current_a < s.sensors.limit_a) {
    add("adc.current_a is ", *s.adc.current_a, " A; must reach sensors.limit_a, ", s.sensors.limit_a,
        " A, or over-current is not seen");
  }
  return lines;
}

}  // namespace steplock::design::sinusoidal
