#include "testbench/compare/compare.hpp"

#include <memory>

#include "model/design/design.hpp"
#include "model/design/config.hpp"
#include "testbench/drive/drive.hpp"
#include "testbench/drive/six_step/lockstep_engine.hpp"
#include "testbench/drive/six_step/config.hpp"
#include "testbench/drive/six_step/run.hpp"
#include "testbench/drive/sinusoidal/lockstep_engine.hpp"

namespace steplock {
namespace {

// What the two drives do not share: how their engines are made, and which figures a run has.
std::unique_ptr<LockstepEngine> lockstep_engine(SixStepDrive, const design::Settings& s, const CompareOptions& options) {
  const design::Design designed = design::design_drive(s);
  const double clock_hz = s.control.clock_hz;
  auto engine = std::make_unique<LockstepEngine>(hls_config(design::quantise(designed.parameters, clock_hz).config), clock_hz);
  engine->invert_comparators(options.wrong_from_clock, options.wrong_to_clock);
  return engine;
}
std::unique_ptr<sinusoidal::LockstepEngine> lockstep_engine(SinusoidalDrive, const design::Settings& s, const CompareOptions&) {
  return std::make_unique<sinusoidal::LockstepEngine>(s, adc_parameters(s));
}
template <class Engine>
Record run_in(SixStepDrive, Engine& engine, const design::Settings& s, const RunOptions& run) {
  return run_with(engine, s, run);
}
template <class Engine>
sinusoidal::Record run_in(SinusoidalDrive, Engine& engine, const design::Settings& s, const RunOptions& run) {
  return run_recorded<Engine, sinusoidal::Recorder>(engine, s, run);
}
const auto& reference_of(SixStepDrive, const CompareOptions& options) { return options.reference; }
const auto& reference_of(SinusoidalDrive, const CompareOptions& options) { return options.sinusoidal_reference; }

std::vector<OwnFigure> own_figures(const Summary& a, const Summary& b) {
  return {{"lock time", "s", a.lock_time_s.value_or(-1), b.lock_time_s.value_or(-1)},
          {"start time", "s", a.start_time_s.value_or(-1), b.start_time_s.value_or(-1)},
          {"mean speed", "rpm", a.steady.mean_rpm, b.steady.mean_rpm},
          {"phase error, rms", "deg", a.phase_error_rms_deg, b.phase_error_rms_deg},
          {"commutation error, rms", "deg", a.commutation_error_rms_deg, b.commutation_error_rms_deg},
          {"peak current", "A", a.peak_current_a, b.peak_current_a},
          {"rms current", "A", a.rms_current_a, b.rms_current_a}};
}
std::vector<OwnFigure> own_figures(const sinusoidal::Result& a, const sinusoidal::Result& b) {
  std::vector<OwnFigure> all = {{"lock time", "s", a.lock_time_s.value_or(-1), b.lock_time_s.value_or(-1)},
                                {"turned backward", "deg", a.backward_deg, b.backward_deg},
                                {"mean speed", "rpm", a.mean_rpm, b.mean_rpm},
                                {"angle error, mean", "deg", a.delta_theta_mean_deg, b.delta_theta_mean_deg},
                                {"angle error, rms", "deg", a.delta_theta_rms_deg, b.delta_theta_rms_deg},
                                {"peak current", "A", a.peak_current_a, b.peak_current_a},
                                {"rms current", "A", a.rms_current_a, b.rms_current_a}};
  if (a.load_dip_percent && b.load_dip_percent) {
    all.push_back({"dip of the load step", "%", *a.load_dip_percent, *b.load_dip_percent});
  }
  return all;
}

template <class Drive>
Comparison compare(Drive drive, const design::Settings& s, const CompareOptions& options) {
  Comparison c;
  const auto progress = [&](const char* what) {
    return [&, what](double done) {
      c.interrupted = options.progress && !options.progress(what, done);
      return !c.interrupted;
    };
  };
  RunOptions run{.engine = EngineKind::kFixed, .angle_deg = options.angle_deg};
  typename Drive::Summary fixed;
  if (options.lockstep) {
    const auto engine = lockstep_engine(drive, s, options);
    engine->spoil(options.spoilt_clock);
    run.progress = progress("rtl = fixed");
    fixed = Drive::summarise(s, run, run_in(drive, *engine, s, run));  // the fixed engine drove
    c.lockstep = engine->found();
  } else {
    run.progress = progress("fixed");
    fixed = Drive::summarise(s, run, Drive::run(s, run));
  }
  if (c.interrupted) return c;
  c.shadow = Drive::shadow(s, fixed, progress("fixed against float"), reference_of(drive, options));
  if (c.interrupted) return c;
  run.engine = EngineKind::kFloat;
  run.progress = progress("float");
  c.own = own_figures(fixed, Drive::summarise(s, run, Drive::run(s, run)));
  return c;
}

}  // namespace

bool Comparison::passed() const { return lockstep.equal() && shadow.within() && !interrupted; }

Comparison compare_engines(const design::Settings& s, const CompareOptions& options) {
  return with_drive(s, [&](auto drive) { return compare(drive, s, options); });
}

}  // namespace steplock
