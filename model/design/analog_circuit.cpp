#include "model/design/analog_circuit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace steplock::design {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kMargin = 1.25;       // a motor that brakes lifts its bus
constexpr double kLargestInput = 2.5;  // V, leaves a rail of 3.3 V for offsets and overshoot
constexpr double kShuntVoltage = 0.1;  // V, at the limit
constexpr double kTolerance = 0.001;   // of the resistors
constexpr double kLargestLag = 1;      // electrical degree

// The series up to E24 are a table, not the formula (IEC 60063).
double preferred(int series, int index) {
  constexpr std::array<double, 24> kE24 = {1.0, 1.1, 1.2, 1.3, 1.5, 1.6, 1.8, 2.0,
                                           2.2, 2.4, 2.7, 3.0, 3.3, 3.6, 3.9, 4.3,
                                           4.7, 5.1, 5.6, 6.2, 6.8, 7.5, 8.2, 9.1};
  const int decade = static_cast<int>(std::floor(static_cast<double>(index) / series));
  const int place = index - decade * series;
  const double value = series <= 24 ? kE24[static_cast<std::size_t>(place * (24 / series))]
                                    : std::round(100 * std::pow(10, double(place) / series)) / 100;
  return value * std::pow(10, decade);
}

// The first index whose value is at least that, but for rounding.
int index_at_least(double value, int series) {
  int index = static_cast<int>(std::floor(series * std::log10(value))) - 2;
  while (preferred(series, index) < value * (1 - 1e-9)) ++index;
  return index;
}

std::string quantity(double value, const char* unit) {
  constexpr std::array<const char*, 7> kPrefixes = {"p", "n", "u", "m", "", "k", "M"};
  const int thousands =
      value == 0
          ? 0
          : std::clamp(static_cast<int>(std::floor(std::log10(value * 1.000001) / 3)), -4, 2);
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.3g %s%s", value / std::pow(1000, thousands),
                kPrefixes[static_cast<std::size_t>(thousands + 4)], unit);
  return text.data();
}

std::string number(double value) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.2g", value);
  return text.data();
}

std::string row(const std::string& part, const std::string& value, const std::string& why) {
  return "| " + part + " | " + value + " | " + why + " |\n";
}

}  // namespace

double preferred_at_least(double value, int series) {
  return preferred(series, index_at_least(value, series));
}
double preferred_at_most(double value, int series) {
  const int above = index_at_least(value, series);
  return preferred(series, preferred(series, above) <= value * (1 + 1e-9) ? above : above - 1);
}
double preferred_nearest(double value, int series) {
  const double below = preferred_at_most(value, series), above = preferred_at_least(value, series);
  return value / below < above / value ? below : above;
}

Circuit circuit_of(const Settings& s) {
  Circuit c;
  const double bus = s.inverter.bus_v;
  c.r_high = preferred_at_least(c.r_low * std::max(kMargin * bus / kLargestInput - 1, 0.1), 24);
  c.ratio = c.r_low / (c.r_high + c.r_low);
  c.largest_input = kMargin * bus * c.ratio;

  const double source = c.r_high * c.ratio;  // of the divider, R_high || R_low
  const double turns_per_s = s.scenario.speed_rpm * s.motor.pole_pairs / 60;
  const double settled = s.control.blanking_s / std::log(bus / s.sensors.comparator_hysteresis_v);
  const double tau = std::min(settled, kLargestLag / 360 / turns_per_s);
  c.c_filter = preferred_at_most(tau / source, 6);
  c.tau = source * c.c_filter;
  c.lag_deg = std::atan(2 * kPi * turns_per_s * c.tau) * 180 / kPi;
  c.mismatch = 2 * kTolerance * (1 - c.ratio) * bus;

  c.r_shunt = preferred_at_most(kShuntVoltage / s.sensors.limit_a, 12);
  c.shunt_power = s.motor.rated_current_a * s.motor.rated_current_a * c.r_shunt;
  const double wanted = c.r_shunt * s.sensors.limit_a;
  c.r_top = preferred_nearest(c.r_bottom * (c.supply / wanted - 1), 96);
  c.threshold = c.supply * c.r_bottom / (c.r_top + c.r_bottom);
  c.limit = c.threshold / c.r_shunt;
  c.c_edge = preferred_at_most(s.control.limit_blanking_s / 5 / c.r_edge, 6);
  return c;
}

std::string circuit_text(const Settings& s, const Circuit& c) {
  std::string text = "| part | value | why |\n|---|---|---|\n";
  text += row("divider at U, V, W: terminal to comparator", quantity(c.r_high, "ohm"),
              quantity(c.largest_input, "V") + " at 5/4 of " + quantity(s.inverter.bus_v, "V"));
  text +=
      row("divider: comparator to ground", quantity(c.r_low, "ohm"), "1 : " + number(1 / c.ratio));
  text += row("filter: comparator to ground", quantity(c.c_filter, "F"),
              quantity(c.tau, "s") + ", " + number(c.lag_deg) +
                  " degrees at the set speed; add it to `comparator_delay_s`");
  switch (s.sensors.reference) {
    case Reference::kVirtualNeutral:
      text += row("reference: from U, V and W to the star", "3 x " + quantity(c.r_high, "ohm"),
                  "the same ratio");
      text +=
          row("reference: star to ground", "3 x " + quantity(c.r_low, "ohm") + " in parallel", "");
      text += row("reference: star to ground", "3 x " + quantity(c.c_filter, "F") + " in parallel",
                  "the same filter");
      break;
    case Reference::kHalfBus:
      text += row(
          "reference: bus to comparators",
          "2 x " + quantity(c.r_high, "ohm") + " and " + quantity(c.r_low, "ohm") + " in series",
          "half the ratio");
      text += row("reference: comparators to ground", quantity(c.r_low, "ohm"), "");
      break;
    case Reference::kStarPoint:
      text += row("reference: the motor's star point to comparators", quantity(c.r_high, "ohm"),
                  "the same ratio");
      text += row("reference: comparators to ground", quantity(c.r_low, "ohm"), "");
      text += row("reference: comparators to ground", quantity(c.c_filter, "F"), "the same filter");
      break;
  }
  text +=
      row("tolerance of these resistors", "0.1 %",
          "shifts a crossing by " + quantity(c.mismatch, "V") + " at most: `comparator_offset_v`");
  text += row("shunt, bridge to ground", quantity(c.r_shunt, "ohm"),
              quantity(c.shunt_power, "W") + " at " + quantity(s.motor.rated_current_a, "A"));
  text += row("shunt to the limit's comparator",
              quantity(c.r_edge, "ohm") + ", " + quantity(c.c_edge, "F") + " to ground",
              "a fifth of `limit_blanking_s`");
  text += row("threshold: " + quantity(c.supply, "V") + " to comparator", quantity(c.r_top, "ohm"),
              quantity(c.threshold, "V") + ": " + quantity(c.limit, "A"));
  text += row("threshold: comparator to ground", quantity(c.r_bottom, "ohm"),
              "`limit_a` is " + quantity(s.sensors.limit_a, "A"));
  text += row("each gate to ground, at the driver", "4.7 kohm", "off until the FPGA is configured");
  return text;
}

}  // namespace steplock::design
