#include "testbench/drive_file/fitted_defaults.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace steplock {
namespace {

constexpr double kBusGives = 0.2, kBusFitted = 0.1;  // of the bus, through its resistance
constexpr double kPeriods = 0.7, kMostPwm = 50e3;    // of the PWM in a step; Hz
constexpr double kLooks = 0.1;                       // of a step, until a crossing is believed
constexpr double kLeastSample = 0.2e-6;              // s
constexpr double kLeastBlanking = 1e-6;              // s, of the current comparator

}  // namespace

void fit_defaults(design::Settings& s, Lines& lines) {
  if (s.drive.kind != design::DriveKind::kSixStep) return;
  const auto silent = [&](const char* key) { return !lines.contains(key); };
  const auto fit = [&](const char* key, double& value, double fitted, const char* unit, const char* why) {
    value = fitted;
    lines[key] = 1;
    s.drive.assumed.push_back(fmt::format("{}: {:.4g} {}, estimated: {}", key, fitted, unit, why));
  };
  auto& c = s.control;
  auto& i = s.inverter;
  if (silent("inverter.bus_resistance_ohm") && i.bus_resistance_ohm * s.sensors.limit_a > kBusGives * i.bus_v) {
    fit("inverter.bus_resistance_ohm", i.bus_resistance_ohm, kBusFitted * i.bus_v / s.sensors.limit_a, "ohm",
        "the limit's current takes a tenth of the bus through it");
  }
  if (c.source != design::Source::kBemf) return;
  const double step = 10 / (s.scenario.speed_rpm * s.motor.pole_pairs);
  if (const double fitted = std::min(kPeriods / step, kMostPwm); silent("control.pwm_hz") && fitted > c.pwm_hz) {
    fit("control.pwm_hz", c.pwm_hz, fitted, "Hz", "a step at the set speed is short");
  }
  const double looks = c.blanking_s + c.samples * c.sample_every_s, part = kLooks * step / looks;
  // The off-time of a cut follows from it, and a long one leaves whole steps without a pulse.
  if (part < 1 && silent("control.limit_blanking_s")) {
    const double fitted = std::min(c.limit_blanking_s, std::max(part * c.limit_blanking_s, kLeastBlanking));
    fit("control.limit_blanking_s", c.limit_blanking_s, fitted, "s",
        "shorter where a step at the set speed is short, as the off-time after a cut is then");
  }
  if (part < 1 && silent("control.blanking_s") && silent("control.sample_every_s") && silent("control.samples")) {
    constexpr const char* kWhy = "a tenth of a step at the set speed, with the samples";
    const double least = 1.05 * (i.dead_time_s + s.sensors.comparator_delay_s) + 4 / c.clock_hz;
    fit("control.blanking_s", c.blanking_s, std::min(c.blanking_s, std::max(part * c.blanking_s, least)), "s", kWhy);
    fit("control.sample_every_s", c.sample_every_s, std::max({part * c.sample_every_s, kLeastSample, 2 / c.clock_hz}), "s", kWhy);
  }
}

}  // namespace steplock
