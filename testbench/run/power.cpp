#include "testbench/run/power.hpp"

#include <fmt/format.h>

namespace steplock {

Power power_between(double from_s, const plant::Energy& from, double to_s, const plant::Energy& to) {
  const double span = to_s - from_s;
  return {.from_s = from_s,
          .to_s = to_s,
          .input = (to.supplied - from.supplied) / span,
          .copper = (to.copper - from.copper) / span,
          .switches = (to.bridge - from.bridge) / span,
          .bus_resistance = (to.bus_resistance - from.bus_resistance) / span,
          .friction = (to.friction - from.friction) / span,
          .load = (to.load - from.load) / span,
          .stored = (to.stored() - from.stored()) / span};
}

nlohmann::ordered_json to_json(const Power& p) {
  nlohmann::ordered_json j;
  const auto put = [&](const char* name, double x) { j[name] = std::stod(fmt::format("{:.7g}", x)); };
  put("from_s", p.from_s), put("to_s", p.to_s);
  put("input_w", p.input), put("load_w", p.load);
  put("copper_w", p.copper), put("switches_w", p.switches), put("bus_resistance_w", p.bus_resistance);
  put("friction_w", p.friction), put("stored_w", p.stored);
  put("efficiency_percent", 100 * p.efficiency());
  return j;
}

std::string to_text(const Power& p) {
  const std::string out = p.load > 0 ? fmt::format("{:.3g} W to the load ({:.1f} %)", p.load, 100 * p.efficiency()) : "no load";
  return fmt::format("{:.3g} W in, {}; copper {:.2g}, switches {:.2g}, bus {:.2g}, friction {:.2g} W", p.input, out, p.copper, p.switches,
                     p.bus_resistance, p.friction);
}

}  // namespace steplock
