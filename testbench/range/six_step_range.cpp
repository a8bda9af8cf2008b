#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/design/design.hpp"
#include "model/design/config.hpp"
#include "testbench/drive/six_step/fixed_engine.hpp"
#include "testbench/drive/six_step/config.hpp"
#include "testbench/paper/ideal_rotor.hpp"
#include "testbench/range/range.hpp"

namespace steplock {
namespace {

constexpr int kTurns = 40;  // electrical, measured

// The same kind of motor, wound and geared for this speed: what the words are designed for.
design::Settings settings_at(design::Settings s, const RangeSettings& r, double erpm) {
  const double rpm = erpm / s.motor.pole_pairs;
  s.control.clock_hz = r.clock_hz;
  s.control.pwm_hz = r.pwm_hz;
  s.control.blanking_s = r.blanking_s;
  s.control.sample_every_s = r.sample_every_s;
  s.control.samples = r.samples;
  s.inverter.dead_time_s = std::min(s.inverter.dead_time_s, r.blanking_s / 4);
  s.sensors.comparator_offset_v = {};
  s.sensors.comparator_noise_v = 0;
  s.sensors.comparator_delay_s = 0;
  s.loop = {};
  s.loop.maximum_rpm = 1.3 * rpm;
  s.start = {};
  s.speed = {};
  // Half the bus at this speed, so that the PWM chops as much as it ever does.
  const double wanted = 0.5 * s.inverter.bus_v / (rpm * std::numbers::pi / 30);
  s.motor.flux_vs *= wanted / design::motor_constants(s).k_e;
  s.motor.coulomb_nm = s.motor.viscous_nms = 0;
  s.load = {};
  s.protection.wrong_lock_s = 0;  // tells a wrong lock from the current, and there is none here
  s.scenario = {};
  s.scenario.speed_rpm = rpm;
  return s;
}

RangePoint measure_point(const design::Settings& drive, const RangeSettings& r, double erpm) {
  const design::Settings s = settings_at(drive, r, erpm);
  const double turns_per_second = erpm / 60;
  const design::Design d = design::design_drive(s);
  FixedEngine engine(hls_config(design::quantise(d.parameters, r.clock_hz).config), r.clock_hz);
  const IdealRotor rotor(turns_per_second);
  // Time to catch the rotor and for the loop to settle, then the span that is judged.
  const double settle = 0.15 + 60 / turns_per_second, span = kTurns / turns_per_second;
  const auto steps = commutations_on(engine, rotor, r.clock_hz, settle + span);

  RangePoint point{.erpm = erpm};
  double sum = 0;
  int count = 0, before = -1;
  bool in_order = true;
  for (const StepTaken& c : steps) {
    if (c.time < settle) continue;
    in_order = in_order && (before < 0 || (c.step - before + 6) % 6 == 1);
    before = c.step;
    // Pattern k is ideal from 30 + 60 k degrees on.
    const double late = std::remainder(360 * rotor.phase(c.time) - (30 + 60 * c.step), 360);
    sum += late;
    point.worst_deg = std::max(point.worst_deg, std::abs(late));
    ++count;
  }
  point.mean_deg = count > 0 ? sum / count : 0;
  // A lock a step off, or one that hunts beyond half a step, is none.
  point.locked = in_order && std::abs(count - 6 * kTurns) <= 1 && point.worst_deg < 30;
  return point;
}

}  // namespace

RangePlan six_step_range() {
  return {
      .stem = "range",
      .title = "Speed range",
      .command = "steplock range",
      .settings = {
          {"48 MHz, 4 samples of 2 us, blanking 4 us, PWM 30 kHz (defaults)"},
          {"48 MHz, 4 samples of 0.5 us, blanking 2 us, PWM 30 kHz", 48e6, 30e3, 2e-6, 0.5e-6, 4},
          {"48 MHz, 2 samples of 0.25 us, blanking 1 us, PWM 48 kHz", 48e6, 48e3, 1e-6, 0.25e-6, 2},
          {"48 MHz, 2 samples of 0.1 us, blanking 0.5 us, PWM 96 kHz", 48e6, 96e3, 0.5e-6, 0.1e-6, 2},
          {"12 MHz, 2 samples of 0.25 us, blanking 1 us, PWM 48 kHz", 12e6, 48e3, 1e-6, 0.25e-6, 2},
          {"100 MHz, 2 samples of 0.1 us, blanking 0.5 us, PWM 96 kHz", 100e6, 96e3, 0.5e-6, 0.1e-6, 2}},
      .erpm = {600, 1e3, 2e3, 5e3, 10e3, 20e3, 50e3, 100e3, 200e3, 300e3, 500e3, 700e3, 850e3, 1e6, 1.2e6},
      .shown_from = 10e3,
      .measure = measure_point,
      .about = "The blocks (engine `fixed`, which equals the RTL on every clock) on ideal comparators of a rotor that "
               "turns at a constant speed, at duty 1/2, so that PWM edges blank as much as they ever do. Error: the "
               "instant of each commutation against 30 + 60 k electrical degrees, over 40 electrical turns.",
      .cell = "mean (late is positive) and worst, electrical degrees; `-` is no lock. A motor from rest to a "
              "million: `steplock run tests/testbench/million_erpm.toml` (a test runs it).",
      .figure = "Commutation against the ideal",
      .figure_title = "Commutation against the ideal, ideal comparators, duty 1/2",
      .caption = "Worst deviation of a commutation over forty electrical turns; a curve ends where the "
                 "lock does. Legend: the rows of the table, in order."};
}

}  // namespace steplock
