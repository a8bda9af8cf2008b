#include "testbench/run/ripple.hpp"

#include <fmt/format.h>

namespace steplock {

void to_json(nlohmann::ordered_json& summary, const Ripple& r) {
  const auto put = [&](const char* name, double x) { summary[name] = std::stod(fmt::format("{:.7g}", x)); };
  put("speed_least_rpm", r.least_rpm);
  put("speed_greatest_rpm", r.greatest_rpm);
  put("speed_ripple_rms_rpm", r.rms_rpm);
}

std::string to_text(const Ripple& r) {
  return fmt::format("{:.2f} to {:.2f} rpm, {:.2f} rpm rms about the mean", r.least_rpm, r.greatest_rpm, r.rms_rpm);
}

}  // namespace steplock
