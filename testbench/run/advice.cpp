#include "testbench/run/advice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "model/design/design.hpp"
#include "model/design/sinusoidal/design.hpp"
#include "testbench/run/tolerance.hpp"
#include "testbench/run/units.hpp"

namespace steplock {
namespace {

// N m, at any angle, of the drive's most current and of the motor's rated one.
struct Torque {
  double most = 0, rated = 0;
};
Torque torque_of(const design::Settings& s) {
  if (s.drive.kind == design::DriveKind::kSixStep) {
    const double k_e = design::motor_constants(s).k_e;
    return {k_e * s.sensors.limit_a, k_e * s.motor.rated_current_a};
  }
  const double k_t = 1.5 * s.motor.pole_pairs * s.motor.flux_vs;  // of a phase's peak; the design's currents are power-invariant
  return {k_t * design::sinusoidal::design_drive(s).parameters.speed.limit / std::sqrt(1.5), k_t * s.motor.rated_current_a};
}

// A sinusoidal drive takes a step as fast as its current control is, where the bus has the voltage for that current at the set speed.
std::string more_current(const design::Settings& s, double load) {
  if (s.drive.kind == design::DriveKind::kSixStep) return {};
  const auto& p = design::sinusoidal::design_drive(s).parameters;
  const double w = design::sinusoidal::speed_of(s, s.scenario.speed_rpm), ampere = load / (1.5 * s.motor.pole_pairs * s.motor.flux_vs);
  const double volts = std::hypot(w * s.motor.flux_vs + p.motor.resistance * ampere, w * p.motor.inductance_q * ampere);
  if (volts > 0.9 * s.inverter.bus_v / std::numbers::sqrt3) return {};
  return fmt::format(", or raise sinusoidal.current_limit_a to {:.3g}", 1.2 * ampere);  // a fifth to speed up with
}

}  // namespace

std::string ends_too_soon(const design::Settings& s, const Gaining& g) {
  const double missing = s.scenario.speed_rpm * (1 - 0.01 * kSpeedTolerancePercent) - g.to_rpm;
  const double gains = (g.to_rpm - g.from_rpm) / (g.to_s - g.from_s);
  // As much as it lacks within the time that it had: else it is something else that holds it.
  if (!(g.to_s > g.from_s) || missing <= 0 || !(gains * g.to_s > missing)) return {};
  const auto& n = s.scenario;
  std::string key = "duration_s";
  double first = n.duration_s;
  for (const auto& [name, at] : {std::pair{"load_step_s", n.load_step_s}, {"inertia_step_s", n.inertia_step_s}, {"reverse_s", n.reverse_s},
                                 {"stop_s", n.stop_s}}) {
    if (at && *at < first) key = name, first = *at;
  }
  // A swing about the end of the ramp, and as long again for the mean that is judged.
  const double until = g.to_s + 2 * missing / gains + 0.5 * g.to_s;
  return fmt::format("the rotor still gains {:.3g} r/min a second and is at {:.0f} of {:.0f}: raise scenario.{} to {:.2g}{}", gains,
                     g.to_rpm, n.speed_rpm, key, until, key == "duration_s" ? "" : ", and what follows by as much");
}

std::string load_step_beyond(const design::Settings& s) {
  if (!s.scenario.load_step_s) return {};
  const double speed = s.scenario.speed_rpm * std::numbers::pi / 30;
  const double own = s.motor.coulomb_nm + s.motor.viscous_nms * speed + s.load.opposing_nm + s.load.fan_nms2 * speed * speed;
  const auto [most, rated] = torque_of(s);
  const double step = design::load_step_torque(s);
  if (step + own <= most || own >= most) return {};
  // What is left would do for a load that comes slowly; a step stops a light rotor before speed control sees it.
  return fmt::format("the load step asks for {:.3g} N m beside {:.3g} of friction and load, and the limit's current gives {:.3g}: lower "
                     "scenario.load_step_nm to {:.2g}{}", step, own, most, std::min(0.8 * (most - own), rated / 2),
                     more_current(s, step + own));
}

}  // namespace steplock
