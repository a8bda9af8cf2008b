#include "testbench/drive/sinusoidal/run.hpp"

#include <stdexcept>

#include "testbench/drive/sinusoidal/lockstep_engine.hpp"

namespace steplock::sinusoidal {
namespace {

template <class Engine>
Record run_with(const design::Settings& s, const RunOptions& options) {
  Engine engine(s, adc_parameters(s));
  Record record = run_recorded<Engine, Recorder>(engine, s, options);
  if constexpr (requires { engine.found(); }) record.lockstep = engine.found();
  return record;
}

}  // namespace

Record run(const design::Settings& s, const RunOptions& options) {
  switch (options.engine) {
    case EngineKind::kFloat: return run_with<FloatEngine>(s, options);
    case EngineKind::kFixed: return run_with<FixedEngine>(s, options);
    case EngineKind::kRtl: return options.lockstep ? run_with<LockstepEngine>(s, options) : run_with<RtlEngine>(s, options);
  }
  throw std::invalid_argument("no such engine");
}

}  // namespace steplock::sinusoidal
