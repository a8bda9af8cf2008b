#include "testbench/compare/coefficients.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "model/design/design.hpp"
#include "testbench/compare/corner_inputs.hpp"
#include "testbench/drive/six_step/config.hpp"

namespace steplock {
namespace {

struct Coefficient {
  const char *name, *unit;
  double& (*of)(design::Parameters&);
  double asked;  // 0: a percent of its value
};

#define STEPLOCK_OF(member) [](design::Parameters& p) -> double& { return p.member; }
constexpr double kPhase = 0x1p-16, kDelay = 100e-9;
const Coefficient kCoefficients[] = {
    {"loop.expected", "step", STEPLOCK_OF(loop.expected), kPhase},
    {"loop.lead_error", "step", STEPLOCK_OF(loop.lead_error), kPhase},
    {"loop.delay", "s", STEPLOCK_OF(loop.delay), kDelay},
    {"loop.ki", "", STEPLOCK_OF(loop.integral), 0},
    {"loop.kp", "", STEPLOCK_OF(loop.proportional), 0},
    {"loop.alpha", "", STEPLOCK_OF(loop.pole), 0},
    {"loop.minimum", "step/s", STEPLOCK_OF(loop.minimum), 0},
    {"loop.maximum", "step/s", STEPLOCK_OF(loop.maximum), 0},
    {"speed.slew", "step/s^2", STEPLOCK_OF(speed.slew), 0},
    {"speed.kp", "1/(step/s)", STEPLOCK_OF(speed.kp), 0},
    {"speed.ki", "1/step", STEPLOCK_OF(speed.ki), 0},
    {"speed.bemf", "1/(step/s)", STEPLOCK_OF(speed.bemf), 0},
    {"speed.minimum", "", STEPLOCK_OF(speed.minimum), 0},
    {"speed.maximum", "", STEPLOCK_OF(speed.maximum), 0},
    {"speed.duty_slew", "1/s", STEPLOCK_OF(speed.duty_slew), 0},
};
#undef STEPLOCK_OF

// What the words stand for, instead of what was wanted.
design::Parameters meant(design::Parameters p, const design::Quantised& q) {
  for (const design::WordRow& row : q.rows) {
    for (const Coefficient& c : kCoefficients) {
      if (row.name == c.name) c.of(p) = row.meant;
    }
  }
  // Per second the word is the part that a tick takes.
  if (p.loop.form == design::LoopForm::kPerSecond) p.loop.pole = -std::log1p(-p.loop.pole) / p.pwm.tick();
  return p;
}

// Of either kind of input the greater part of its bound.
std::vector<LawError> worst_errors(const Told& told, const design::Parameters& p) {
  std::vector<LawError> all = law_errors(told.run, p, told.clock_hz);
  const auto corners = law_errors(told.corners, p, told.clock_hz);
  for (std::size_t k = 0; k < all.size(); ++k) {
    LawError& mine = all[k];
    mine.updates += corners[k].updates;
    if (corners[k].of_bound() > mine.of_bound()) mine.worst = corners[k].worst, mine.bound = corners[k].bound, mine.at_s = corners[k].at_s;
  }
  return all;
}

bool within(const std::vector<LawError>& all) { return std::ranges::all_of(all, &LawError::within); }

std::string of_value(const Sensitivity& s) {
  if (s.least == 0) return "-";
  if (s.unit == "s") return fmt::format("{:.2g} ns", s.least * 1e9);
  if (s.unit == "step") return fmt::format("{:.2g} places", s.least / kPhase);
  return fmt::format("{:.2g} %", 100 * s.least / s.value);
}

}  // namespace

Told told_of(const design::Settings& s, double angle_deg, const std::function<bool(double done)>& progress) {
  const double clock_hz = s.control.clock_hz;
  const design::Parameters wanted = design::design_drive(s).parameters;
  const design::Quantised q = design::quantise(wanted, clock_hz);
  return {.run = law_inputs(s, angle_deg, true, progress),
          .corners = corner_inputs(hls_config(q.config), clock_hz),
          .parameters = meant(wanted, q),
          .clock_hz = clock_hz};
}

std::vector<Sensitivity> sensitivities(const Told& told) {
  constexpr double kTimes = 100, kFine = 1.1, kLeast = 1e-3;
  std::vector<Sensitivity> all;
  for (const Coefficient& c : kCoefficients) {
    design::Parameters p = told.parameters;
    const double value = c.of(p), asked = c.asked > 0 ? c.asked : value / 100;
    const auto noticed = [&](double change) {
      c.of(p) = value + change;
      return !within(worst_errors(told, p));
    };
    double least = kTimes * asked;
    if (!noticed(least)) least = 0;
    // Down by tens to one that is not noticed, then between the two.  Where a limit's own place decides, none is too small.
    double less = least / 10;
    while (least > kLeast * asked && noticed(less)) least = less, less /= 10;
    while (least > kLeast * asked && least > kFine * less) {
      const double middle = std::sqrt(least * less);
      (noticed(middle) ? least : less) = middle;
    }
    all.push_back({.name = c.name, .unit = c.unit, .value = value, .asked = asked, .least = least});
  }
  return all;
}

bool CoefficientsOf::passed() const {
  const auto like = [](const LawError& e) { return e.unlike == 0; };
  return within(errors) && std::ranges::all_of(errors, like) && std::ranges::all_of(coefficients, &Sensitivity::noticed);
}

CoefficientsOf coefficients_of(const std::string& drive, const Told& told) {
  return {drive, worst_errors(told, told.parameters), sensitivities(told)};
}

std::string coefficients_page(const std::vector<CoefficientsOf>& drives) {
  std::string head = "|", line = "|---|", page;
  for (const auto& d : drives) head += fmt::format(" | {}", d.drive), line += "---:|";
  head += " |\n" + line + "\n";

  page += head;
  for (std::size_t k = 0; k < std::size(kCoefficients); ++k) {
    page += fmt::format("| `{}`", kCoefficients[k].name);
    for (const auto& d : drives) {
      const Sensitivity& s = d.coefficients[k];
      page += fmt::format(" | {}{}", of_value(s), s.noticed() ? "" : " (!)");
    }
    page += " |\n";
  }
  page += "\nWith the words' own coefficients, the greatest part of its bound that an error took, of so many updates:\n\n" + head;
  for (std::size_t k = 0; !drives.empty() && k < drives.front().errors.size(); ++k) {
    page += fmt::format("| {}", drives.front().errors[k].signal);
    for (const auto& d : drives) page += fmt::format(" | {:.2g} of {}", d.errors[k].of_bound(), d.errors[k].updates);
    page += " |\n";
  }
  const auto row = [&](const char* name, std::size_t LawError::*count) {
    page += fmt::format("| {}", name);
    for (const auto& d : drives) {
      std::size_t all = 0;
      for (const auto& e : d.errors) all += e.*count;
      page += fmt::format(" | {}", all);
    }
    page += " |\n";
  };
  row("disturbed", &LawError::disturbed);
  row("law not as block", &LawError::unlike);
  return page;
}

}  // namespace steplock
