#include "testbench/compare/compare.hpp"

#include "model/design/design.hpp"
#include "model/design/words.hpp"
#include "testbench/compare/shadow.hpp"
#include "testbench/engine/lockstep_engine.hpp"
#include "testbench/engine/words.hpp"
#include "testbench/run/drive_loop.hpp"

namespace steplock {

bool Comparison::passed() const { return lockstep.equal() && shadow.within() && !interrupted; }

Comparison compare_engines(const design::Settings& s, const CompareOptions& options) {
  Comparison c;
  const auto progress = [&](const char* what) {
    return [&, what](double done) {
      c.interrupted = options.progress && !options.progress(what, done);
      return !c.interrupted;
    };
  };
  RunOptions run{.engine = EngineKind::kFixed, .angle_deg = options.angle_deg};
  if (options.lockstep) {
    const design::Design designed = design::design_drive(s);
    const double clock_hz = s.control.clock_hz;
    LockstepEngine engine(hls_words(design::quantise(designed.parameters, clock_hz).words),
                          clock_hz);
    engine.invert_comparators(options.wrong_from_clock, options.wrong_to_clock);
    run.progress = progress("rtl = fixed");
    const Record record = run_with(engine, s, run);
    c.lockstep = engine.found();
    c.fixed = summarise(s, run, record);  // the fixed engine drove
  } else {
    run.progress = progress("fixed");
    c.fixed = summarise(s, run, run_drive(s, run));
  }
  if (c.interrupted) return c;
  c.shadow = shadow_errors(s, c.fixed, progress("fixed against float"), options.reference);
  if (c.interrupted) return c;
  run.engine = EngineKind::kFloat;
  run.progress = progress("float");
  c.floating = summarise(s, run, run_drive(s, run));
  return c;
}

}  // namespace steplock
