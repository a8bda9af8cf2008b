// Fig. 5 of Amano 2003 and what Eqs. (22), (23) make of it.
#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "model/design/design.hpp"
#include "model/design/start.hpp"
#include "testbench/paper/amano2003.hpp"
#include "testbench/drive/six_step/figures.hpp"
#include "testbench/run/units.hpp"

namespace steplock::amano2003 {
namespace {

// Printed in Sec. 5 and Table 1.
constexpr double kGamma = 4.28, kXi = 83.3, kKappa = 0.7, kInertia = 2.7e-3, kBemf = 0.0383;
constexpr double kAlignTime = 0.622, kAccelerationTime = 0.108;

double entered(const Record& record, State state) {
  const auto it = std::ranges::find(record.changes, state, &StateChange::state);
  return it == record.changes.end() ? record.simulated_s : it->time;
}

}  // namespace

PaperSection start_sequence(const design::Settings& drive, const PaperOptions& options) {
  const Trial t = run_trial(steady_run(drive, drive.scenario.speed_rpm, 4), options, options.engine,
                            "Fig. 5");
  const design::Design d = design::design_drive(t.settings);
  const double reset = entered(t.record, State::kAlign);
  const double accelerate = entered(t.record, State::kAccelerate);
  const double pull_in = entered(t.record, State::kPullIn);
  double back = 0;
  const double from = t.record.overview.front().plant.electrical_angle;
  for (const Sample& s : t.record.overview) {
    if (s.time < accelerate) back = std::min(back, s.plant.electrical_angle - from);
  }

  PaperSection section{
      .title = "Fig. 5: start sequence, with the times of Eqs. (22) and (23)",
      .text = "From rest: two position patterns (the second is the paper's reset position; the first "
              "one moves a rotor that stands exactly opposite to it), forced steps with rising "
              "frequency, then the closed loop. The drive watches for a turning rotor before, and for "
              "consistent crossings before it hands over.",
      .claims = {
          {"reset time t_r by Eq. (22), printed constants", "s", kAlignTime, "",
           design::align_time(kKappa, kInertia, kGamma),
           "the paper contradicts itself: its gamma, J and kappa do not give its t_r"},
          {"reset time as used", "s", kAlignTime, "", accelerate - reset,
           "the printed value is an input", Verdict::kInput},
          {"K_v that Eq. (23) needs for the printed t_a", "", {}, "not printed",
           kAccelerationTime * kBemf / (kXi * kInertia), "Eq. (23) solved for K_v"},
          {"acceleration time t_a", "s", kAccelerationTime, "", pull_in - accelerate,
           fmt::format("to {:.0f} r/min at {:.0f} A; the paper names neither", d.hand_over_rpm,
                       d.start_current)},
          {"steps lost", "", 0, "", double(t.summary.step_outs), "judged from the true angle"},
          {"turned back before the acceleration", "deg electrical", {}, "\"at a smaller angle\"",
           degrees(-back), "the way to the reset position, from this start angle"},
          {"locked after", "s", {}, "not printed", t.summary.lock_time_s.value_or(0), ""},
      }};
  auto figures = run_figures(t.settings, t.summary, t.record);
  for (Figure& f : figures) {
    if (f.name == "start") {
      f.name = "fig5";
      f.title = "Fig. 5: position reset, acceleration, speed control";
      section.figures.push_back(f);
    }
  }
  if (!t.summary.locked || t.summary.step_outs > 0) section.failures.push_back("the start");
  return section;
}

}  // namespace steplock::amano2003
