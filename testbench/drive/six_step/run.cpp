#include "testbench/drive/six_step/run.hpp"

#include "model/design/design.hpp"
#include "model/design/config.hpp"
#include "testbench/drive/six_step/fixed_engine.hpp"
#include "testbench/drive/six_step/float_engine.hpp"
#include "testbench/drive/six_step/lockstep_engine.hpp"
#include "testbench/drive/six_step/rtl_engine.hpp"
#include "testbench/drive/six_step/config.hpp"

namespace steplock {

Record run_drive(const design::Settings& s, const RunOptions& options) {
  const design::Design designed = design::design_drive(s);
  const double clock_hz = s.control.clock_hz;
  if (options.engine == EngineKind::kFloat) {
    FloatEngine engine(designed.parameters, clock_hz);
    return run_with(engine, s, options);
  }
  const SixStepConfig config = hls_config(design::quantise(designed.parameters, clock_hz).config);
  if (options.engine == EngineKind::kFixed) {
    FixedEngine engine(config, clock_hz);
    return run_with(engine, s, options);
  }
  if (options.lockstep) {
    LockstepEngine engine(config, clock_hz);
    Record record = run_with(engine, s, options);
    record.lockstep = engine.found();
    return record;
  }
  RtlEngine engine(config, clock_hz);
  return run_with(engine, s, options);
}

}  // namespace steplock
