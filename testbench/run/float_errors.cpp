#include "testbench/run/float_errors.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace steplock {
namespace {

// Significant digits enough for any comparison, few enough to be read.
double number(double x) { return std::stod(fmt::format("{:.7g}", x)); }

}  // namespace

bool FloatErrors::within() const {
  return !signals.empty() && std::ranges::all_of(signals, &SignalError::within);
}

nlohmann::ordered_json to_json(const FloatErrors& e) {
  nlohmann::ordered_json j;
  j["within"] = e.within();
  j[e.compared] = e.count;
  j["from_s"] = number(e.from_s);
  j["to_s"] = number(e.to_s);
  j["signals"] = nlohmann::ordered_json::array();
  for (const SignalError& s : e.signals) {
    j["signals"].push_back({{"signal", s.budget.name}, {"unit", s.budget.unit},
                            {"mean", number(s.mean)}, {"rms", number(s.rms)},
                            {"greatest", number(s.greatest)},
                            {"budget_rms", number(s.budget.rms_allowed())},
                            {"budget_greatest", number(s.budget.bound)},
                            {"within", s.within()}});
  }
  return j;
}

std::string to_text(const FloatErrors& e) {
  std::string t = fmt::format(
      "  fixed against float on the same pins, {} {} from {:.3f} to {:.3f} s\n"
      "  {:<20}{:<5}{:>11}{:>11}{:>11}{:>11}{:>11}\n",
      e.count, e.compared, e.from_s, e.to_s, "", "", "mean", "rms", "budget", "worst", "budget");
  for (const SignalError& s : e.signals) {
    t += fmt::format("  {:<20}{:<5}{:>11.2e}{:>11.2e}{:>11.2e}{:>11.2e}{:>11.2e}{}\n", s.budget.name,
                     s.budget.unit, s.mean, s.rms, s.budget.rms_allowed(), s.greatest,
                     s.budget.bound, s.within() ? "" : "  BEYOND");
  }
  if (e.signals.empty()) t += "  none: the two never ran in step\n";
  return t;
}

}  // namespace steplock
