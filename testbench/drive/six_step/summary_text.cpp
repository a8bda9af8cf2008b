// A summary as JSON for programs and as lines for people.
#include <fmt/format.h>

#include "testbench/drive/six_step/summary.hpp"

namespace steplock {
namespace {

using Json = nlohmann::ordered_json;

// Significant digits enough for any comparison, few enough to be read.
Json number(double x) { return std::stod(fmt::format("{:.7g}", x)); }
Json number(const std::optional<double>& x) { return x ? number(*x) : Json(nullptr); }

Json speed(const SpeedResult& r) {
  return {{"from_s", number(r.from_s)}, {"to_s", number(r.to_s)},
          {"mean_speed_rpm", number(r.mean_rpm)}, {"speed_error_percent", number(r.error_percent)}};
}

std::string seconds(const std::optional<double>& t) {
  return t ? fmt::format("{:.4f} s", *t) : "never";
}

}  // namespace

Json to_json(const Summary& s) {
  Json j;
  j["drive"] = s.drive;
  j["engine"] = s.engine;
  j["start_angle_deg"] = number(s.angle_deg);
  j["passed"] = s.failures().empty();
  j["failures"] = s.failures();
  j["advice"] = s.advice;
  j["locked"] = s.locked;
  j["step_outs"] = s.step_outs;
  j["lost_locks"] = s.lost_locks;
  j["fault"] = s.fault;
  j["failed_tries"] = s.reasons;
  j["retries"] = s.retries;
  j["start_time_s"] = number(s.start_time_s);
  j["lock_time_s"] = number(s.lock_time_s);
  j["set_speed_rpm"] = number(s.set_speed_rpm);
  j["mean_speed_rpm"] = number(s.steady.mean_rpm);
  j["speed_error_percent"] = number(s.steady.error_percent);
  to_json(j, s.ripple);
  j["power"] = to_json(s.power);
  j["steady_from_s"] = number(s.steady.from_s);
  j["steady_to_s"] = number(s.steady.to_s);
  j["phase_error_rms_deg"] = number(s.phase_error_rms_deg);
  j["commutation_error_mean_deg"] = number(s.commutation_error_mean_deg);
  j["commutation_error_rms_deg"] = number(s.commutation_error_rms_deg);
  j["peak_current_a"] = number(s.peak_current_a);
  j["current_bound_a"] = number(s.current_bound_a);
  j["rms_current_a"] = number(s.rms_current_a);
  j["load_step_nm"] = number(s.load_step_nm);
  j["load_dip_percent"] = number(s.load_dip_percent);
  j["loaded"] = s.loaded ? speed(*s.loaded) : Json(nullptr);
  j["loaded_power"] = s.loaded_power ? to_json(*s.loaded_power) : Json(nullptr);
  j["reverse_time_s"] = number(s.reverse_time_s);
  j["reversed"] = s.reversed ? speed(*s.reversed) : Json(nullptr);
  j["profile"] = Json::array();
  for (const Piece& p : s.profile) j["profile"].push_back(to_json(p));
  j["crossings"] = s.crossings;
  j["missed"] = s.missed;
  j["freewheel_long"] = s.freewheel_long;
  j["limit_hits"] = s.limit_hits;
  j["shoot_throughs"] = s.shoot_throughs;
  j["energy_residual"] = number(s.energy_residual);
  j["rtl_equals_fixed"] = s.lockstep ? to_json(*s.lockstep) : Json(nullptr);
  j["fixed_against_float"] = s.float_errors ? to_json(*s.float_errors) : Json(nullptr);
  j["interrupted"] = s.interrupted;
  j["clocks"] = s.clocks;
  j["simulated_s"] = number(s.simulated_s);
  j["wall_s"] = number(s.wall_s);
  j["clocks_per_cpu_second"] = number(s.clocks_per_cpu_second);
  return j;
}

std::string to_text(const Summary& s) {
  std::string t;
  const auto line = [&](const char* name, const std::string& value) {
    t += fmt::format("  {:<18}{}\n", name, value);
  };
  t += fmt::format("{}, engine {}, rotor at {:g} deg\n", s.drive, s.engine, s.angle_deg);
  line("locked", fmt::format("{}, first after {}", s.locked ? "yes" : "NO", seconds(s.lock_time_s)));
  line("at set speed", seconds(s.start_time_s) + " after run");
  line("speed", fmt::format("{:.2f} rpm, set {:g} rpm, error {:+.4f} %", s.steady.mean_rpm,
                            s.set_speed_rpm, s.steady.error_percent));
  line("speed ripple", speed_text(s.ripple));
  line("torque", torque_text(s.ripple));
  line("phase error", fmt::format("{:.2f} deg rms (detector)", s.phase_error_rms_deg));
  line("commutation", fmt::format("{:+.2f} deg late on average, {:.2f} deg rms (true angle)",
                                  s.commutation_error_mean_deg, s.commutation_error_rms_deg));
  line("phase current", fmt::format("peak {:.2f} A of at most {:.2f} A, rms {:.2f} A steady", s.peak_current_a,
                                    s.current_bound_a, s.rms_current_a));
  line("power", to_text(s.power));
  if (s.loaded) {
    line("load step", fmt::format("{:.4g} N m: dips {:.2f} %, then {:+.4f} %", *s.load_step_nm,
                                  *s.load_dip_percent, s.loaded->error_percent));
    line("power under it", to_text(*s.loaded_power));
  }
  if (s.reversed) {
    line("reversal", fmt::format("locked after {}, {:.2f} rpm, error {:+.4f} %",
                                 seconds(s.reverse_time_s), s.reversed->mean_rpm,
                                 s.reversed->error_percent));
  }
  for (const Piece& p : s.profile) line("profile", to_text(p));
  line("step-outs", fmt::format("{} (true angle), {} locks lost, {} retries", s.step_outs,
                                s.lost_locks, s.retries));
  line("crossings", fmt::format("{}, missed {}, long freewheeling {}, limit hits {}", s.crossings,
                                s.missed, s.freewheel_long, s.limit_hits));
  line("fault", s.fault);
  line("simulated", fmt::format("{:.4g} s in {:.3g} s ({:.3g} s per s), {:.3g} M clocks per CPU second",
                                s.simulated_s, s.wall_s, s.simulated_s / s.wall_s,
                                s.clocks_per_cpu_second / 1e6));
  if (s.lockstep) line("rtl = fixed", to_text(*s.lockstep));
  if (s.float_errors) t += to_text(*s.float_errors);
  for (const std::string& why : s.failures()) t += fmt::format("  FAILED: {}\n", why);
  for (const std::string& line : s.advice) t += fmt::format("  advice: {}\n", line);
  return t;
}

}  // namespace steplock
