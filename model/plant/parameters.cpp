#include "model/plant/parameters.hpp"

#include <cmath>
#include <cstdio>

#include "model/plant/salient.hpp"

namespace steplock::plant {
namespace {

class Checks {
 public:
  // Closed range; NaN is in none.
  void range(const std::string& name, double value, double low, double high) {
    if (value >= low && value <= high) return;
    complain(name, value, "must be from " + text(low) + " to " + text(high));
  }
  void positive(const std::string& name, double value) {
    if (value > 0 && std::isfinite(value)) return;
    complain(name, value, "must be above 0");
  }
  void not_negative(const std::string& name, double value) {
    if (value >= 0 && std::isfinite(value)) return;
    complain(name, value, "must be 0 or above");
  }
  void finite(const std::string& name, double value) {
    if (!std::isfinite(value)) complain(name, value, "must be a number");
  }
  void that(bool holds, const std::string& problem) {
    if (!holds) problems.push_back(problem);
  }

  std::vector<std::string> problems;

 private:
  static std::string text(double value) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%g", value);
    return buffer;
  }
  void complain(const std::string& name, double value, const std::string& rule) {
    problems.push_back(name + " is " + text(value) + "; " + rule);
  }
};

void check(Checks& c, const BackEmfShape& s) {
  if (s.kind == BackEmfShape::Kind::kTrapezoidal) {
    c.range("motor.shape.flat_top_deg", s.flat_top_deg, 0, 175);
  }
  if (s.kind != BackEmfShape::Kind::kTable) return;
  c.that(s.table.size() >= 8, "motor.shape.table has " + std::to_string(s.table.size()) +
                                  " values; must have at least 8 over one electrical turn");
  for (std::size_t n = 0; n < s.table.size(); ++n) {
    c.range("motor.shape.table[" + std::to_string(n) + "]", s.table[n], -2, 2);
  }
}

void check(Checks& c, const Motor& m) {
  c.positive("motor.resistance", m.resistance);
  c.positive("motor.inductance", m.inductance);
  c.that(m.inductance - m.mutual > 0, "motor.mutual must be below motor.inductance");
  c.not_negative("motor.inductance_d", m.inductance_d);
  c.not_negative("motor.inductance_q", m.inductance_q);
  c.range("motor.saturation", m.saturation, 0, 0.9);
  c.positive("motor.saturation_current", m.saturation_current);
  c.that(!SalientWinding::needed(m) || m.shape.kind == BackEmfShape::Kind::kSinusoidal,
         "motor.shape is not sinusoidal; must be with inductance_d, inductance_q or saturation, whose "
         "equations know one sine");
  c.not_negative("motor.flux", m.flux);
  c.range("motor.pole_pairs", m.pole_pairs, 1, 100);
  check(c, m.shape);
  c.positive("motor.inertia", m.inertia);
  c.not_negative("motor.cogging_torque", m.cogging_torque);
  c.that(m.cogging_periods >= 1,
         "motor.cogging_periods is " + std::to_string(m.cogging_periods) + "; must be 1 or above");
  c.finite("motor.cogging_phase", m.cogging_phase);
  c.not_negative("motor.coulomb_friction", m.coulomb_friction);
  c.not_negative("motor.static_friction", m.static_friction);
  c.that(!(m.static_friction < m.coulomb_friction),
         "motor.static_friction is below motor.coulomb_friction; a rotor breaks away at no less "
         "torque than it slides");
  c.not_negative("motor.viscous_friction", m.viscous_friction);
  c.not_negative("motor.fan_friction", m.fan_friction);
}

void check(Checks& c, const std::string& name, const Comparator& comparator) {
  c.finite(name + ".offset", comparator.offset);
  c.not_negative(name + ".hysteresis", comparator.hysteresis);
  c.not_negative(name + ".delay", comparator.delay);
  c.not_negative(name + ".noise", comparator.noise);
  c.range(name + ".noise_interval", comparator.noise_interval, 1e-9, 1);
}

}  // namespace

std::vector<std::string> validate(const Parameters& p) {
  Checks c;
  check(c, p.motor);
  c.not_negative("load.inertia", p.load.inertia);
  c.not_negative("load.opposing_torque", p.load.opposing_torque);
  c.finite("load.active_torque", p.load.active_torque);
  c.not_negative("load.breakaway_torque", p.load.breakaway_torque);
  c.not_negative("load.unbalance_torque", p.load.unbalance_torque);
  c.finite("load.unbalance_angle", p.load.unbalance_angle);
  c.finite("load.wind_speed", p.load.wind_speed);
  c.that(p.load.wind_speed == 0 || p.motor.fan_friction > 0,
         "load.wind_speed is not 0 and motor.fan_friction is; wind turns a fan, give it one");
  c.not_negative("load.spring_stiffness", p.load.spring_stiffness);
  c.not_negative("load.spring_damping", p.load.spring_damping);
  c.that(p.load.spring_stiffness == 0 || p.load.inertia > 0,
         "load.spring_stiffness is not 0 and load.inertia is; a spring needs an inertia behind it");
  c.positive("bus.voltage", p.bus.voltage);
  c.not_negative("bus.resistance", p.bus.resistance);
  if (p.bus.resistance > 0) c.positive("bus.capacitance", p.bus.capacitance);
  c.that(p.bus.sinks || p.bus.resistance > 0,
         "bus.sinks is false with bus.resistance 0; a stiff bus always sinks, give a resistance");
  c.not_negative("bridge.on_resistance", p.bridge.on_resistance);
  c.positive("bridge.diode_drop", p.bridge.diode_drop);
  c.not_negative("bridge.diode_resistance", p.bridge.diode_resistance);
  for (std::size_t k = 0; k < 3; ++k) {
    const std::string index = "[" + std::to_string(k) + "]";
    check(c, "sensing.comparator" + index, p.sensing.comparator[k]);
    c.range("sensing.hall_error_deg" + index, p.sensing.hall_error_deg[k], -30, 30);
  }
  c.positive("sensing.limit_threshold", p.sensing.limit_threshold);
  check(c, "sensing.limit", p.sensing.limit);
  c.not_negative("sensing.hall_delay", p.sensing.hall_delay);
  c.range("accuracy.tolerance", p.accuracy.tolerance, 1e-12, 1e-3);
  c.range("accuracy.max_step", p.accuracy.max_step, 1e-9, 1);
  return c.problems;
}

}  // namespace steplock::plant
