#include "testbench/command/judged.hpp"

#include <fmt/format.h>

#include "model/design/bounds.hpp"
#include "model/design/design.hpp"
#include "testbench/drive_file/key_text.hpp"
#include "testbench/drive/six_step/config.hpp"
#include "testbench/registers/registers.hpp"
#include "testbench/drive/sinusoidal/config.hpp"

namespace steplock {
namespace {

std::string settings_text(const design::Settings& s) {
  std::string text;
  design::for_each_key(s, [&](const design::Key& key, const auto& value) {
    using T = std::decay_t<decltype(value)>;
    if constexpr (!std::is_same_v<T, std::string> && !std::is_same_v<T, std::vector<std::string>>) {
      if (!design::belongs(key.section, s.drive.kind) || !design::belongs(key.section, key.name, s.drive.kind)) return;
      const std::string shown = toml_text(value);
      const bool none = shown.empty() || shown == "0" || shown == "false" || shown == "[]";
      if (!none) text += fmt::format("{}.{} = {}\n", key.section, key.name, shown);
    }
  });
  return text;
}

std::string config_text(const design::Settings& s) {
  if (s.drive.kind == design::DriveKind::kSinusoidal) return registers::config_mem(sinusoidal::config_of(s), "judged", s.control.clock_hz);
  const auto designed = design::design_drive(s);
  return registers::config_mem(hls_config(design::quantise(designed.parameters, s.control.clock_hz).config), "judged",
                              s.control.clock_hz);
}

}  // namespace

std::string judged_text(const DriveFile& file) {
  const design::StartBounds b = design::start_bounds(file.settings);
  return settings_text(file.settings) + config_text(file.settings) +
         fmt::format("bounds {:g} {:g} {:g} {:g}\n", b.current_a, b.kick_deg, b.speed, b.lock_s);
}

}  // namespace steplock
