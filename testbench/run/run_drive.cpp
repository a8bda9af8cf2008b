#include "testbench/run/run_drive.hpp"

#include "model/design/design.hpp"
#include "model/design/words.hpp"
#include "testbench/engine/fixed.hpp"
#include "testbench/engine/float.hpp"
#include "testbench/engine/lockstep_engine.hpp"
#include "testbench/engine/rtl.hpp"
#include "testbench/engine/words.hpp"
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

Record run_drive(const design::Settings& s, const RunOptions& options) {
  const design::Design designed = design::design_drive(s);
  const double clock_hz = s.control.clock_hz;
  if (options.engine == EngineKind::kFloat) {
    FloatEngine engine(designed.parameters, clock_hz);
    return run_with(engine, s, options);
  }
  const Words words = hls_words(design::quantise(designed.parameters, clock_hz).words);
  if (options.engine == EngineKind::kFixed) {
    FixedEngine engine(words, clock_hz);
    return run_with(engine, s, options);
  }
  if (options.lockstep) {
    LockstepEngine engine(words, clock_hz);
    Record record = run_with(engine, s, options);
    record.lockstep = engine.found();
    return record;
  }
  RtlEngine engine(words, clock_hz);
  return run_with(engine, s, options);
}

}  // namespace steplock
