#include "testbench/drive/sinusoidal/design_report.hpp"

#include <fmt/format.h>

#include <numbers>

#include "model/design/bounds.hpp"
#include "model/design/sinusoidal/design.hpp"
#include "model/design/sinusoidal/config.hpp"
#include "testbench/report/word_table.hpp"

namespace steplock::sinusoidal {

std::vector<DesignRow> design_rows(const design::Settings& s) {
  const design::sinusoidal::Design d = design::sinusoidal::design_drive(s);
  const auto& p = d.parameters;
  const design::StartBounds bounds = design::start_bounds(s);
  const auto rpm = [&](double w) { return design::sinusoidal::rpm_of(s, w); };
  return {{"rated torque", "N m", d.rated_torque},
          {"no-load speed", "rpm", d.no_load_rpm},
          {"slowest speed", "rpm", d.slowest_rpm},
          {"saliency", "", d.saliency},
          {"ADC's step", "A", d.current_step},
          {"K_E", "V s/rad", p.motor.k_e},
          {"sampling period", "s", p.pwm.period},
          {"K_e", "V/A", p.current_model.k_e},
          {"K_theta", "rad/A", p.current_model.k_theta},
          {"EMF bandwidth", "rad/s", d.emf_bandwidth},
          {"K_SP", "rad/s/V", p.voltage_model.k_sp},
          {"K_SI", "rad/s^2/V", p.voltage_model.k_si},
          {"current bandwidth", "rad/s", d.current_bandwidth},
          {"current kp gamma", "V/A", p.current.kp_gamma},
          {"current kp delta", "V/A", p.current.kp_delta},
          {"current ki gamma", "V/A/s", p.current.ki_gamma},
          {"current ki delta", "V/A/s", p.current.ki_delta},
          {"speed bandwidth", "rad/s", d.speed_bandwidth},
          {"speed kp", "A s/rad", p.speed.kp},
          {"speed ki", "A/rad", p.speed.ki},
          {"speed slew", "rpm/s", rpm(p.speed.slew)},
          {"pattern time", "s", p.start.pattern_s},
          {"start current", "A", p.speed.start_current},
          {"trusted above", "rpm", rpm(p.start.lock_speed)},
          {"pilot pulse, short", "s", p.pilot.short_s},
          {"pilot pulse, long", "s", p.pilot.long_s},
          {"pilot decayed below", "A", p.pilot.decayed},
          {"pilot pulse turns", "deg", p.pilot.turned * 180 / std::numbers::pi},
          {"over-current", "A", p.protection.over_current},
          {"too slow below", "rpm", rpm(p.protection.slow_speed)},
          {"bound of current", "A", bounds.current_a},
          {"bound of kick", "deg", bounds.kick_deg},
          {"bound of speed", "", bounds.speed},
          {"bound of lock", "s", bounds.lock_s}};
}

std::string design_text(const design::Settings& s) {
  std::string text = fmt::format("{}: sinusoidal drive, vectors power-invariant, speeds of gains electrical\n",
                                 s.drive.name);
  for (const DesignRow& row : design_rows(s)) {
    text += fmt::format("  {:<22}{:>12.5g} {}\n", row.name, row.value, row.unit);
  }
  return text + word_table(design::sinusoidal::quantise(s).rows);
}

nlohmann::ordered_json design_json(const design::Settings& s) {
  nlohmann::ordered_json j;
  j["drive"] = s.drive.name;
  j["kind"] = "sinusoidal";
  for (const DesignRow& row : design_rows(s)) {
    j["rows"].push_back({{"name", row.name}, {"unit", row.unit}, {"value", row.value}});
  }
  j["config"] = word_table_json(design::sinusoidal::quantise(s).rows);
  return j;
}

}  // namespace steplock::sinusoidal
