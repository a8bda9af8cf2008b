// What a motor's data sheet prints, as keys of [motor] beside those of model/design/settings_keys.hpp:
//
//     poles                                                           gives pole_pairs
//     resistance_line_ohm, inductance_line_h   between two terminals  give resistance_ohm, inductance_h (L = line / 2 + M)
//     kv_rpm_per_v, torque_constant_nm_a, no_load_speed_rpm           give flux_vs
//     rated_torque_nm                                                 gives rated_current_a
//     inertia_gcm2                                                    gives inertia_kgm2
//     no_load_current_a                                               gives coulomb_nm
//
//     k_e     back-EMF constant, peak, of two terminals, V s/rad mechanical:  60 / (2 pi KV) = torque constant
//             = (bus_v - no-load current R_line) / no-load speed
//     flux    k_e / (sqrt 3 pole_pairs) of a sinusoidal motor, k_e / (2 pole_pairs) of a trapezoidal one
//
// What says the same thing twice has to agree within 10 %; the project's own key is believed first, then the order above.
// Inertia and limit are estimated where a file is silent, and named under `assumed`.
//
// Doc: docs/first_motor.md   Test: tests/testbench/sheet_terms_test.cpp
#pragma once

#include <algorithm>
#include <map>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "model/design/settings_keys.hpp"

namespace steplock {

// One quantity, told in one way.
struct Told {
  std::string by;
  double value;
};
// What to say where they are more than 10 % apart; no text where they agree.
std::optional<std::string> disagreement(const std::string& what, const Told& first, const Told& other);

// k_e: back-EMF constant, peak, of two terminals, V s/rad mechanical.
inline constexpr double kRadPerSecond = std::numbers::pi / 30;  // of 1 r/min
inline double k_e_of_kv(double rpm_per_v) { return 1 / (rpm_per_v * kRadPerSecond); }
inline double kv_of_k_e(double k_e) { return 1 / (k_e * kRadPerSecond); }
inline double k_e_without_load(double bus_v, double current, double line_ohm, double rpm) {
  return (bus_v - current * line_ohm) / (rpm * kRadPerSecond);
}
// Of k_e for one V s of a phase, electrical.
inline double k_e_per_flux(design::Shape shape, double pole_pairs) {
  return (shape == design::Shape::kTrapezoidal ? 2 : std::numbers::sqrt3) * pole_pairs;
}
// What is taken where nobody tells: a mechanical time constant of 15 ms, and a current that bus and winding can give, or no
// start could count on it.
inline double estimated_inertia(double k_e, double line_ohm) { return 15e-3 * k_e * k_e / line_ohm; }
inline double estimated_limit(double rated_a, double stalled_a) { return std::min(2.5 * rated_a, 0.6 * stalled_a); }

// Nothing is what the file does not give.
struct SheetTerms {
  std::optional<double> poles, kv_rpm_per_v, torque_constant_nm_a, no_load_speed_rpm, no_load_current_a, resistance_line_ohm,
      inductance_line_h, inertia_gcm2, rated_torque_nm;
};

template <class S, class Visitor>
void for_each_term(S& s, Visitor&& visit) {
  const auto k = [&](const char* name, auto& value, const char* unit, const char* about, double low, double high) {
    visit(design::Key{"motor", name, unit, about, low, high, false}, value);
  };
  k("poles", s.poles, "", "pole_pairs: magnet poles, what `12N14P` calls 14P", 2, 200);
  k("kv_rpm_per_v", s.kv_rpm_per_v, "", "flux_vs: KV, of the peak between two terminals", 0.01, 1e6);
  k("torque_constant_nm_a", s.torque_constant_nm_a, "N m/A", "flux_vs: per dc current with six steps, not per a phase's rms", 1e-6, 1e3);
  k("no_load_speed_rpm", s.no_load_speed_rpm, "rpm", "flux_vs: without load, at inverter.bus_v", 1, 1e6);
  k("no_load_current_a", s.no_load_current_a, "A", "coulomb_nm: of the dc bus, all of it taken for dry friction", 0, 1e3);
  k("resistance_line_ohm", s.resistance_line_ohm, "ohm", "resistance_ohm: between two terminals, without the leads", 2e-4, 2e3);
  k("inductance_line_h", s.inductance_line_h, "H", "inductance_h: between two terminals", 1e-7, 2);
  k("inertia_gcm2", s.inertia_gcm2, "g cm^2", "inertia_kgm2: 1 kg m^2 is 10,000,000 of them", 1e-3, 1e9);
  k("rated_torque_nm", s.rated_torque_nm, "N m", "rated_current_a: continuous", 1e-7, 1e5);
}

// Which keys a file gives, as "motor.poles", and where.
using Lines = std::map<std::string, int>;

struct TermProblem {
  std::string key;  // which of those that the file gives
  std::string text;
};

// A key whose value is estimated as soon as all else is there.
constexpr bool is_estimated(std::string_view key) { return key == "motor.inertia_kgm2" || key == "sensors.limit_a"; }

// Writes what follows from the terms into the settings, and the lines of the keys that it follows from.
std::vector<TermProblem> take_terms(const SheetTerms&, design::Settings&, Lines&);

}  // namespace steplock
