// A comparison as JSON for programs and as tables for people.
#include <fmt/format.h>

#include "testbench/compare/compare.hpp"
#include "testbench/drive/six_step/summary.hpp"

namespace steplock {
namespace {

using Json = nlohmann::ordered_json;

Json number(double x) { return std::stod(fmt::format("{:.7g}", x)); }

}  // namespace

Json to_json(const Comparison& c) {
  Json j;
  j["passed"] = c.passed();
  j["rtl_equals_fixed"] = to_json(c.lockstep);
  j["fixed_against_float"] = to_json(c.shadow);
  Json own;
  for (const OwnFigure& p : c.own) {
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
  for (const OwnFigure& p : c.own) {
    t += fmt::format("  {:<28}{:<6}{:>12.5g}{:>12.5g}\n", p.name, p.unit, p.fixed, p.floating);
  }
  return t;
}

}  // namespace steplock
