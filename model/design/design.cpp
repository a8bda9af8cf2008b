// See design.hpp for the rules; problems() is in problems.cpp.
#include "model/design/design.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/design/believed.hpp"
#include "model/design/rules.hpp"

namespace steplock::design {
namespace {

constexpr double kPi = std::numbers::pi;

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

// s.  At a standstill the bus drives the current up while the comparator is not believed, and resistance alone takes it down
// in the off-time: one that is shorter than this lets it climb from pulse to pulse.  With all gates off the bus does, as
// steeply as it drove it up, in a quarter of the off-time.
double off_time(const Settings& s) {
  constexpr double kShortest = 20e-6, kLongest = 4095;  // s; clocks, the word
  const double off = kCorner * unbelieved(s) * s.inverter.bus_v / (s.sensors.limit_a * motor_constants(s).r_loop);
  return std::clamp(std::max(off, least_off_time(s)), kShortest, kLongest / s.control.clock_hz);
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
  p.maximum = l.maximum_rpm ? steps_per_second(s, *l.maximum_rpm)
                            : std::min(steps_per_second(s, 1.3 * d.motor.no_load * 30 / kPi), most_frequency(p, s.control.clock_hz));
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

double duty_for(const Settings& s, double current, double resistance) {
  const auto& i = s.inverter;
  const double dead = i.dead_time_s * s.control.pwm_hz;  // each pulse begins that much later
  const double duty = s.control.chopping == Chopping::kComplementary
                          ? current * resistance / i.bus_v
                          : (current * resistance + i.diode_drop_v) / (i.bus_v + i.diode_drop_v);
  return std::clamp(duty + dead, 0.0, s.speed.maximum_duty);
}

double followed(const LoopParameters& l, double frequency) {
  constexpr double kFollow = 10.0 / 60;  // turns of a step: error that an acceleration may cause
  const bool per_step = l.form == LoopForm::kPerStep;
  return kFollow * l.integral * (per_step ? frequency * frequency / steps_per_update(l) : 1);
}

double steps_per_second(const Settings& s, double rpm) { return rpm * s.motor.pole_pairs / 10; }
double rpm_of(const Settings& s, double f) { return f * 10 / s.motor.pole_pairs; }

double unbelieved(const Settings& s) {
  constexpr double kClocks = 4;  // synchroniser, decision, gate
  return s.control.limit_blanking_s + s.sensors.limit_delay_s + kClocks / s.control.clock_hz;
}

double least_off_time(const Settings& s) { return 4 * unbelieved(s); }

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

Design design_drive(const Settings& given) {
  const Settings s = as_believed(given);
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
