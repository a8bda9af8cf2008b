#include "testbench/run/drive_loop.hpp"

namespace steplock {

RecorderSettings recorder_settings(const design::Settings& s, const Timeline& t) {
  return {.advance_deg = s.loop.advance_deg,
          .electrical_turn_s = 60 / (s.scenario.speed_rpm * s.motor.pole_pairs),
          .steady_end_s = t.steady_end_s,
          .duration_s = s.scenario.duration_s,
          .pwm_s = 1 / s.control.pwm_hz};
}

const char* name_of(EngineKind kind) {
  switch (kind) {
    case EngineKind::kRtl: return "rtl";
    case EngineKind::kFixed: return "fixed";
    case EngineKind::kFloat: return "float";
  }
  return "";
}

}  // namespace steplock
