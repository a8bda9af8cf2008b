#include <stdexcept>

#include "model/design/design.hpp"
#include "testbench/paper/amano2003.hpp"
#include "testbench/drive/six_step/run.hpp"
#include "testbench/run/timeline.hpp"
#include "testbench/run/units.hpp"

namespace steplock::amano2003 {

Trial run_trial(const design::Settings& s, const PaperOptions& options, EngineKind engine,
                const std::string& what) {
  const std::vector<std::string> problems = design::problems(s);
  if (!problems.empty()) throw std::runtime_error(what + ": " + problems.front());
  return run_refused(s, options, engine, what);
}

Trial run_refused(const design::Settings& s, const PaperOptions& options, EngineKind engine,
                  const std::string& what) {
  bool stopped = false;
  RunOptions run{.engine = engine,
                 .angle_deg = s.scenario.start_angle_deg,
                 .progress = [&](double done) {
                   stopped = options.progress && !options.progress(what, done);
                   return !stopped;
                 }};
  Trial trial{s, {}, run_drive(s, run)};
  if (stopped) throw Stopped();
  trial.summary = summarise(s, run, trial.record);
  return trial;
}

design::Settings steady_run(design::Settings s, double rpm, double seconds) {
  s.scenario.speed_rpm = rpm;
  s.scenario.duration_s = seconds;
  drop_events(s.scenario);
  return s;
}

design::Settings without_fan(design::Settings s) {
  s.load = {};
  const design::StartSection start = s.start;
  s.start = {};
  s.start.align_current_a = start.align_current_a;
  s.start.start_current_a = start.start_current_a;
  s.speed = {};
  return s;
}

design::Settings rewound(design::Settings s, double turns) {
  s.motor.flux_vs *= turns;
  s.motor.resistance_ohm *= turns * turns;
  s.motor.inductance_h *= turns * turns;
  return s;
}

design::Settings per_step_loop(design::Settings s) {
  const std::optional<double> maximum = s.loop.maximum_rpm;
  s.loop = {};
  s.loop.maximum_rpm = maximum;
  return s;
}

design::Settings redesigned_loop(design::Settings s, double f_m_hz) {
  s.loop.f_m_hz = f_m_hz;
  s.loop.c1_f.reset();
  s.loop.c2_f.reset();
  s.loop.r_ohm.reset();
  return s;
}

double no_load_rpm(const design::Settings& s) { return rpm(design::motor_constants(s).no_load); }

}  // namespace steplock::amano2003
