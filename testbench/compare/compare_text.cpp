// A comparison as JSON for programs and as tables for people.
#include <fmt/format.h>

#include "testbench/compare/compare.hpp"

namespace steplock {
namespace {

using Json = nlohmann::ordered_json;

Json number(double x) { return std::stod(fmt::format("{:.7g}", x)); }

struct Pair {
  const char* name;
  const char* unit;
  double fixed, floating;
};

std::vector<Pair> own_runs(const Comparison& c) {
  const Summary &a = c.fixed, &b = c.floating;
  return {{"lock time", "s", a.lock_time_s.value_or(-1), b.lock_time_s.value_or(-1)},
          {"start time", "s", a.start_time_s.value_or(-1), b.start_time_s.value_or(-1)},
          {"mean speed", "rpm", a.steady.mean_rpm, b.steady.mean_rpm},
          {"phase error, rms", "deg", a.phase_error_rms_deg, b.phase_error_rms_deg},
          {"commutation error, rms", "deg", a.commutation_error_rms_deg,
           b.commutation_error_rms_deg},
          {"peak current", "A", a.peak_current_a, b.peak_current_a},
          {"rms current", "A", a.rms_current_a, b.rms_current_a}};
}

}  // namespace

Json to_json(const Comparison& c) {
  Json j;
  j["passed"] = c.passed();
  j["rtl_equals_fixed"] = to_json(c.lockstep);
  j["fixed_against_float"] = to_json(c.shadow);
  Json own;
  for (const Pair& p : own_runs(c)) {
    own.push_back({{"figure", p.name}, {"unit", p.unit}, {"fixed", number(p.fixed)},
                   {"float", number(p.floating)}});
  }
  j["own_motors"] = own;
  return j;
}

std::string to_text(const Comparison& c) {
  std::string t;
  if (c.lockstep.clocks > 0) {
    t += fmt::format("  rtl = fixed: {}\n", to_text(c.lockstep));
  }
  t += to_text(c.shadow);
  t += fmt::format("  each with a motor of its own:\n  {:<28}{:<6}{:>12}{:>12}\n", "figure", "unit",
                   "fixed", "float");
  for (const Pair& p : own_runs(c)) {
    t += fmt::format("  {:<28}{:<6}{:>12.5g}{:>12.5g}\n", p.name, p.unit, p.fixed, p.floating);
  }
  return t;
}

}  // namespace steplock
