#include "testbench/run/profile.hpp"

#include <fmt/format.h>

namespace steplock {

std::vector<Piece> pieces(const design::Settings& s, double simulated_s) {
  const Timeline events = timeline(s);
  std::vector<Piece> all;
  double set_rpm = s.scenario.speed_rpm;
  for (std::size_t k = 0; k < events.events.size(); ++k) {
    const Event& e = events.events[k];
    if (e.command.set_speed != 0) set_rpm = rpm_of_steps(e.command.set_speed, s.motor.pole_pairs);
    if (e.what != kSetSpeed && e.what != kLoad) continue;
    const auto seconds = [&](std::uint64_t clock) { return static_cast<double>(clock) / s.control.clock_hz; };
    const double from = seconds(e.clock), to = seconds(k + 1 < events.events.size() ? events.events[k + 1].clock : events.clocks);
    if (from >= simulated_s) break;
    all.push_back({.from_s = from,
                   .to_s = std::min(to, simulated_s),
                   .set_rpm = e.command.reverse ? -set_rpm : set_rpm,
                   .load_nm = e.load_nm - s.load.opposing_nm});
  }
  return all;
}

nlohmann::ordered_json to_json(const Piece& p) {
  const auto number = [](double x) { return std::stod(fmt::format("{:.7g}", x)); };
  return {{"from_s", number(p.from_s)},
          {"to_s", number(p.to_s)},
          {"set_rpm", number(p.set_rpm)},
          {"load_nm", number(p.load_nm)},
          {"mean_rpm", number(p.mean_rpm)},
          {"error_percent", number(p.error_percent())},
          {"least_rpm", number(p.speed_rpm.least)},
          {"greatest_rpm", number(p.speed_rpm.greatest)},
          {"locked", p.locked}};
}

std::string to_text(const Piece& p) {
  return fmt::format("{:g} rpm and {:.3g} N m from {:.3f} s: {:.2f} rpm, error {:+.4f} %, {:.2f} to {:.2f} rpm{}", p.set_rpm, p.load_nm,
                     p.from_s, p.mean_rpm, p.error_percent(), p.speed_rpm.least, p.speed_rpm.greatest,
                     p.locked ? "" : ", not locked");
}

std::vector<std::string> failures(const std::vector<Piece>& all) {
  std::vector<std::string> lines;
  for (const Piece& p : all) {
    if (!p.locked) lines.push_back(fmt::format("not locked at {:.3f} s, with {:g} rpm and {:.3g} N m", p.to_s, p.set_rpm, p.load_nm));
  }
  return lines;
}

}  // namespace steplock
