#include "testbench/run/ripple.hpp"

#include <fmt/format.h>

namespace steplock {

void to_json(nlohmann::ordered_json& summary, const Ripple& r) {
  const auto put = [&](const char* name, double x) { summary[name] = std::stod(fmt::format("{:.7g}", x)); };
  put("speed_least_rpm", r.speed_rpm.least);
  put("speed_greatest_rpm", r.speed_rpm.greatest);
  put("speed_ripple_rms_rpm", r.speed_rpm.rms);
  put("torque_mean_nm", r.torque_nm.mean);
  put("torque_least_nm", r.torque_nm.least);
  put("torque_greatest_nm", r.torque_nm.greatest);
  put("torque_ripple_rms_nm", r.torque_nm.rms);
}

std::string speed_text(const Ripple& r) {
  const Swing& w = r.speed_rpm;
  return fmt::format("{:.2f} to {:.2f} rpm, {:.2f} rpm rms about the mean", w.least, w.greatest, w.rms);
}

std::string torque_text(const Ripple& r) {
  const Swing& w = r.torque_nm;
  return fmt::format("{:.4g} to {:.4g} N m, {:.3g} N m rms about {:.4g}", w.least, w.greatest, w.rms, w.mean);
}

}  // namespace steplock
