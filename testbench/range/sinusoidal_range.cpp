#include <algorithm>
#include <cmath>

#include "model/design/bounds.hpp"
#include "model/design/sinusoidal/config.hpp"
#include "testbench/range/range.hpp"
#include "testbench/run/timeline.hpp"
#include "testbench/run/units.hpp"
#include "testbench/drive/sinusoidal/fixed_engine.hpp"
#include "testbench/drive/sinusoidal/run.hpp"

namespace steplock {
namespace {

constexpr int kTurns = 40;  // electrical, measured

// The file's motor, beyond its own set speed wound for this one: of 1/r of the turns.  Voltages, torques and the ratio of L to R are
// what they were, currents r times.  It has 1/r of the inertia, so that it takes the same time to its speed.
design::Settings settings_at(design::Settings s, const RangeSettings& range, double erpm) {
  const double rpm = erpm / s.motor.pole_pairs, r = std::max(1.0, rpm / s.scenario.speed_rpm);
  s.control.clock_hz = range.clock_hz;
  s.control.pwm_hz = range.pwm_hz;
  s.control.minimum_pulse_s = std::min(s.control.minimum_pulse_s, 0.02 / range.pwm_hz);
  s.inverter.dead_time_s = std::min(s.inverter.dead_time_s, 0.01 / range.pwm_hz);
  design::InverterSection& bridge = s.inverter;
  for (double* ohm : {&s.motor.resistance_ohm, &bridge.on_resistance_ohm, &bridge.diode_resistance_ohm, &bridge.bus_resistance_ohm}) {
    *ohm /= r * r;
  }
  for (double* henry : {&s.motor.inductance_h, &s.motor.mutual_h}) *henry /= r * r;
  for (auto* henry : {&s.motor.inductance_d_h, &s.motor.inductance_q_h}) {
    if (*henry) **henry /= r * r;
  }
  s.motor.flux_vs /= r;
  s.motor.inertia_kgm2 /= r;
  s.motor.viscous_nms /= r;
  for (double* ampere : {&s.motor.rated_current_a, &s.motor.saturation_a, &s.sensors.limit_a, &s.sinusoidal.i_gamma_a}) *ampere *= r;
  design::SinusoidalStartSection& start = s.sinusoidal_start;
  for (auto* ampere : {&s.adc.current_a, &s.sinusoidal.current_limit_a, &start.pattern_current_a, &start.start_current_a}) {
    if (*ampere) **ampere *= r;
  }
  s.adc.current_offset_a = {};
  s.adc.current_noise_a = s.adc.voltage_noise_v = 0;
  s.load = {};
  // What the file fixed for its own speed follows from this one.
  s.sinusoidal.slew_rpm_s = s.sinusoidal_start.lock_rpm = s.sinusoidal_start.stop_rpm = s.sinusoidal_protection.slow_rpm = std::nullopt;
  drop_events(s.scenario);
  s.scenario.speed_rpm = rpm;
  return s;
}

RangePoint measure_point(const design::Settings& drive, const RangeSettings& range, double erpm) {
  RangePoint point{.erpm = erpm};
  design::Settings s = settings_at(drive, range, erpm);
  if (!design::sinusoidal::quantise(s).problems.empty()) return point;  // `steplock design` would refuse it
  const double turn_s = 60 / erpm, bound_s = 2 * design::start_bounds(s).lock_s;
  s.scenario.duration_s = bound_s + 3 * kTurns * turn_s + 1;
  sinusoidal::BenchOf<sinusoidal::FixedEngine> bench(s, s, timeline(s), s.scenario.start_angle_deg);
  const auto turn = [&] {  // the mean speed over one, r/min
    const double angle = bench.plant().state().electrical_angle, from = bench.time();
    bench.run_until(from + turn_s);
    return rpm((bench.plant().state().electrical_angle - angle) / (bench.time() - from) / s.motor.pole_pairs);
  };
  const auto at_speed = [&] {
    return std::abs(turn() / s.scenario.speed_rpm - 1) < 0.02 && bench.engine().watch().locked();
  };
  // Until it has been at its speed for as long as is measured.
  for (int held = 0; held < kTurns;) {
    if (bench.time() > bound_s) return point;
    held = at_speed() ? held + 1 : 0;
  }
  const sinusoidal::Totals before = bench.recorder().totals();
  point.locked = true;
  const double period = 1 / range.pwm_hz, end = bench.time() + kTurns * turn_s;
  while (bench.time() < end) {
    bench.run_until(bench.time() + period);
    point.worst_deg = std::max(point.worst_deg, std::abs(bench.recorder().delta_theta_deg()));
    point.locked = point.locked && bench.engine().watch().locked();
  }
  const sinusoidal::Totals after = bench.recorder().totals();
  point.mean_deg = (after.angle_deg - before.angle_deg) / static_cast<double>(std::max<std::uint64_t>(1, after.angles - before.angles));
  // Beyond, the current of a wanted torque brakes.
  point.locked = point.locked && point.worst_deg < 90;
  return point;
}

}  // namespace

RangePlan sinusoidal_range() {
  return {
      .stem = "sinusoidal_range",
      .title = "Speed range of the sinusoidal drive",
      .command = "steplock range drives/m2310p_sinusoidal.toml",
      .settings = {{"24 MHz, 5 kHz", 24e6, 5e3}, {"24 MHz, 10 kHz", 24e6, 10e3}, {"24 MHz, 20 kHz", 24e6, 20e3},
                   {"24 MHz, 40 kHz", 24e6, 40e3}, {"48 MHz, 80 kHz", 48e6, 80e3}},
      .erpm = {2e3, 5e3, 10e3, 20e3, 50e3, 100e3, 140e3, 200e3, 280e3},
      .shown_from = 5e3,
      .measure = measure_point,
      .about = "The drive (engine `fixed`, which equals the RTL on every clock) with its motor, beyond its own set speed wound for the speed that is measured: 1/r of the turns, so that "
               "voltages and torques are what they were. It starts from rest, without load, on ADCs without offset or noise. Error: the true angle of the N "
               "pole less the estimate, at each sample of 40 electrical turns at its speed.",
      .cell = "mean and worst, electrical degrees; `-` is no lock, not at its speed within twice the bound of a start, or beyond the words, which hold a sixteenth of a turn per sample.",
      .figure = "The estimate against the true angle",
      .figure_title = "The estimate against the true angle, no load, ideal ADCs",
      .caption = "Worst error of the estimate over forty electrical turns; a curve ends where the lock does. Legend: the rows of the table, in order."};
}

}  // namespace steplock
