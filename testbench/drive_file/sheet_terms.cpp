#include "testbench/drive_file/sheet_terms.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace steplock {
namespace {

constexpr double kAgree = 0.1;

class Taker {
 public:
  Taker(const SheetTerms& terms, design::Settings& settings, Lines& lines) : t_(terms), s_(settings), lines_(lines) {}

  std::vector<TermProblem> take() {
    auto& m = s_.motor;
    decide("pole_pairs", m.pole_pairs, {told("poles", t_.poles, [](double n) { return n / 2; })});
    decide("resistance_ohm", m.resistance_ohm, {told("resistance_line_ohm", t_.resistance_line_ohm, half)});
    decide("inductance_h", m.inductance_h,
                   {told("inductance_line_h", t_.inductance_line_h, [&](double l) { return l / 2 + m.mutual_h; })});
    decide("inertia_kgm2", m.inertia_kgm2, {told("inertia_gcm2", t_.inertia_gcm2, [](double j) { return 1e-7 * j; })});
    flux();
    if (!knows("flux_vs")) return std::move(problems_);
    const double k_e = m.flux_vs * k_e_per_flux(m.shape, m.pole_pairs);
    // A sinusoidal drive's current is the peak of a phase.
    const double per_ampere = s_.drive.kind == design::DriveKind::kSinusoidal ? 1.5 * m.pole_pairs * m.flux_vs : k_e;
    decide("rated_current_a", m.rated_current_a,
                   {told("rated_torque_nm", t_.rated_torque_nm, [&](double torque) { return torque / per_ampere; })});
    if (t_.no_load_current_a && knows("viscous_nms")) {
      say("no_load_current_a", "motor.no_load_current_a does not tell dry friction beside motor.viscous_nms; give motor.coulomb_nm instead");
    } else {
      decide("coulomb_nm", m.coulomb_nm, {told("no_load_current_a", t_.no_load_current_a, [&](double i) { return i * k_e; })});
    }
    estimate(k_e);
    return std::move(problems_);
  }

 private:
  static double half(double x) { return x / 2; }
  bool knows(const char* key) const { return lines_.contains(std::string("motor.") + key); }
  template <class Of>
  static std::optional<Told> told(const char* by, const std::optional<double>& given, Of&& of) {
    if (!given) return std::nullopt;
    return Told{by, of(*given)};
  }

  // The key's own value first; what else tells it has to agree.
  template <class V>
  void decide(const char* key, V& value, const std::vector<std::optional<Told>>& ways) {
    std::optional<Told> first;
    if (knows(key)) first = Told{key, static_cast<double>(value)};
    for (const auto& way : ways) {
      if (!way) continue;
      if (first) {
        if (const auto text = disagreement(std::string("motor.") + key, *first, *way)) say(way->by, *text);
        continue;
      }
      first = way;
      take(key, value, *way);
    }
  }
  template <class V>
  void take(const char* key, V& value, const Told& way) {
    const auto range = range_of(key);
    if (way.value < range.low || way.value > range.high) {
      say(way.by, fmt::format("motor.{} gives motor.{} = {:.4g} {}; it must lie in {:g} to {:g}", way.by, key, way.value, range.unit, range.low,
                              range.high));
    } else if (std::is_integral_v<V> && way.value != std::round(way.value)) {
      say(way.by, fmt::format("motor.{} gives {:g} for motor.{}, which is a whole number; poles are even", way.by, way.value, key));
    }
    value = static_cast<V>(way.value);
    lines_["motor." + std::string(key)] = lines_.at("motor." + way.by);
  }
  design::Key range_of(std::string_view name) const {
    design::Key found;
    for_each_key(std::as_const(s_), [&](const design::Key& key, const auto&) {
      if (key.section == "motor" && key.name == name) found = key;
    });
    return found;
  }

  void flux() {
    auto& m = s_.motor;
    const bool asked = t_.torque_constant_nm_a || t_.kv_rpm_per_v || t_.no_load_speed_rpm;
    if (!asked || !knows("pole_pairs")) return;
    if (m.shape == design::Shape::kTable) {
      const char* by = t_.torque_constant_nm_a ? "torque_constant_nm_a" : t_.kv_rpm_per_v ? "kv_rpm_per_v" : "no_load_speed_rpm";
      return say(by, fmt::format("motor.{} says nothing of a phase with motor.shape = \"table\"; give motor.flux_vs", by));
    }
    const double per_flux = k_e_per_flux(m.shape, m.pole_pairs), idle = t_.no_load_current_a.value_or(0);
    std::optional<Told> by_speed;
    if (lines_.contains("inverter.bus_v")) {
      by_speed = told("no_load_speed_rpm", t_.no_load_speed_rpm, [&](double n) {
        return k_e_without_load(s_.inverter.bus_v, idle, 2 * m.resistance_ohm, n) / per_flux;
      });
    }
    decide("flux_vs", m.flux_vs,
           {told("torque_constant_nm_a", t_.torque_constant_nm_a, [&](double k) { return k / per_flux; }),
            told("kv_rpm_per_v", t_.kv_rpm_per_v, [&](double kv) { return k_e_of_kv(kv) / per_flux; }), by_speed});
  }

  // What a file has to have, and a sheet may not print.
  void estimate(double k_e) {
    auto& m = s_.motor;
    if (!knows("inertia_kgm2") && knows("resistance_ohm")) {
      m.inertia_kgm2 = estimated_inertia(k_e, 2 * m.resistance_ohm);
      assume("motor.inertia_kgm2", m.inertia_kgm2, "kg m^2", "a mechanical time constant of 15 ms");
    }
    const bool limits = lines_.contains("sensors.limit_a");
    if (!limits && knows("rated_current_a") && knows("resistance_ohm") && lines_.contains("inverter.bus_v")) {
      const double stalled = s_.inverter.bus_v / (2 * m.resistance_ohm);
      s_.sensors.limit_a = estimated_limit(m.rated_current_a, stalled);
      if (s_.sensors.limit_a < m.rated_current_a) {
        say("rated_current_a", fmt::format("motor.rated_current_a is {:.4g} A, and inverter.bus_v drives {:.4g} A through two phases; at most 0.6 of "
                                           "it, or give sensors.limit_a",
                                           m.rated_current_a, stalled));
      }
      assume("sensors.limit_a", s_.sensors.limit_a, "A",
             "2.5 times the rated current, or 0.6 of what the bus drives through two phases");
    }
  }
  void assume(const std::string& key, double value, const char* unit, const char* why) {
    lines_[key] = 1;
    s_.drive.assumed.push_back(fmt::format("{}: {:.4g} {}, estimated: {}", key, value, unit, why));
  }

  void say(const std::string& key, const std::string& text) { problems_.push_back({"motor." + key, text}); }

  const SheetTerms& t_;
  design::Settings& s_;
  Lines& lines_;
  std::vector<TermProblem> problems_;
};

}  // namespace

std::optional<std::string> disagreement(const std::string& what, const Told& first, const Told& other) {
  if (std::abs(other.value / first.value - 1) <= kAgree) return std::nullopt;
  return fmt::format("{} is {:.4g} by {} and {:.4g} by {}; they must agree within {:g} %, leave the wrong one out", what, first.value, first.by,
                     other.value, other.by, 100 * kAgree);
}

std::vector<TermProblem> take_terms(const SheetTerms& terms, design::Settings& settings, Lines& lines) {
  return Taker(terms, settings, lines).take();
}

}  // namespace steplock
