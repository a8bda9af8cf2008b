// The phase detector that Amano 2003 has, one crossing a turn, with the paper's own filter: where it holds, and where not.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "model/design/design.hpp"
#include "testbench/paper/amano2003.hpp"
#include "testbench/paper/loop_response.hpp"
#include "testbench/paper/panels.hpp"
#include "testbench/run/units.hpp"

namespace steplock::amano2003 {
namespace {

constexpr double kSpinning = 2200;  // r/min

// From hand-over's speed on, as the drive file's currents start it.
design::Settings once_per_turn(design::Settings s, double hand_over_rpm) {
  const design::Design d = design::design_drive(s);
  s.start.align_current_a = d.align_current;
  s.start.start_current_a = d.start_current;
  s.start.hand_over_rpm = hand_over_rpm;
  s.loop.detector = design::Detector::kOncePerTurn;
  return s;
}

// r/min below which the loop is unstable, by the sampled computation.
double least_stable_rpm(const design::Design& d, int pole_pairs) {
  double below = 300, above = 3000;
  while (above - below > 0.5) {
    const double middle = (below + above) / 2;
    (margin_once_per_turn(d, pole_pairs, middle) < 0 ? below : above) = middle;
  }
  return above;
}

// When the drive first left its closed loop; the run's end if it never did.
double left_lock(const Record& r) {
  const auto run = std::ranges::find(r.changes, State::kRun, &StateChange::state);
  return run == r.changes.end() || run + 1 == r.changes.end() ? r.simulated_s : (run + 1)->time;
}

const Sample& sample_at(const Record& r, double time) {
  const auto it = std::ranges::lower_bound(r.overview, time, {}, &Sample::time);
  return it == r.overview.end() ? r.overview.back() : *it;
}

Figure falling(const Trial& t, const design::Design& d) {
  const int pairs = t.settings.motor.pole_pairs;
  Figure f{.name = "detector", .title = "One crossing a turn: the loop as its rotor slows down", .axis = "time, s",
           .caption = fmt::format("A spinning rotor is caught and let down to a third of its speed. Margin: computed, at the rotor's speed. Below "
                                  "{:.0f} r/min an error is answered by a greater one, until the drive gives up the lock and catches the rotor anew.",
                                  least_stable_rpm(d, t.settings.motor.pole_pairs))};
  const auto curve = [&](const char* name, const char* color, auto&& value) {
    std::vector<Point> points;
    for (const Sample& x : t.record.overview) points.push_back({x.time, value(x)});
    return Curve{name, color, outlined(points), 1.1};
  };
  const auto true_rpm = [&](const Sample& x) { return rpm(x.plant.speed); };
  f.panels = {{.label = "speed, r/min",
               .curves = {curve("loop", palette::kDrive, [&](const Sample& x) { return 10 * x.drive.steps_per_second / pairs; }),
                          curve("rotor", palette::kTrue, true_rpm)}},
              {.label = "detector, deg",
               .curves = {curve("phase error", palette::kU, [](const Sample& x) { return x.drive.phase_error_deg; })}},
              {.label = "margin, deg", .curves = {curve("phase margin", palette::kW, [&](const Sample& x) {
                 return margin_once_per_turn(d, pairs, std::max(300.0, true_rpm(x)));
               })}}};
  return f;
}

}  // namespace

double margin_once_per_turn(const design::Design& d, int pole_pairs, double rpm) {
  const design::LoopParameters& l = d.parameters.loop;
  const double turn = 60 / (rpm * pole_pairs);
  const design::PerSecond filter{l.integral, l.proportional, l.pole};
  return design::margins(design::open_loop_sampled(filter, d.parameters.pwm.tick(), turn), 1, 500).phase_deg;
}

PaperSection own_detector(const design::Settings& drive, const PaperOptions& options) {
  const int pairs = drive.motor.pole_pairs;
  const double first = design::design_drive(drive).hand_over_rpm;
  const design::Settings printed = once_per_turn(drive, first), stable = once_per_turn(drive, 1500);
  const design::Design d = design::design_drive(stable);

  design::Settings s = steady_run(stable, 2800, 4);  // out of reach: the whole bus, as Fig. 7
  s.scenario.start_speed_rpm = kSpinning;
  const Trial whole = run_trial(s, options, options.engine, "one crossing a turn, 12 V");
  if (options.progress) options.progress("one crossing a turn, loop", 0);
  const LoopExperiment e{.rpm = kSpinning, .lowest = 20, .highest = 150, .engine = options.engine};  // rad/s; a turn takes 14 ms
  const Crossover seen = crossover(measure_loop(stable, e));

  const std::vector<std::string> refused = design::problems(steady_run(printed, drive.scenario.speed_rpm, 4));
  const Trial rest =
      run_refused(steady_run(printed, drive.scenario.speed_rpm, 6), options, options.engine, "one crossing a turn, from rest");
  s = steady_run(printed, kSpinning / 3, 4);
  s.scenario.start_speed_rpm = kSpinning;
  const Trial slows = run_refused(s, options, options.engine, "one crossing a turn, slowed down");
  const double gave_up = rpm(sample_at(slows.record, left_lock(slows.record)).plant.speed);

  PaperSection section{
      .title = "The paper's own detector: one crossing a turn",
      .text = fmt::format(
          "`loop.detector = \"once_per_turn\"`, with the paper's filter as printed. Where its loop is stable it is run beside Figs. 6 and 7: hand-over at "
          "1500 r/min, a rotor that spins at {:.0f} r/min when the drive begins. At the hand-over of Fig. 5, {:.0f} r/min, `steplock design` refuses it "
          "(\"{}\"); it is run all the same, from rest and from {:.0f} r/min down.",
          kSpinning, first, refused.empty() ? "nothing" : refused.front(), kSpinning),
      .claims = {
          {"speed at the whole 12 V", "r/min", {}, "not printed", whole.summary.steady.mean_rpm, "as Fig. 7's"},
          {"phase error of the detector", "deg rms", {}, "\"operating correctly\"", whole.summary.phase_error_rms_deg, ""},
          {"commutation against the ideal, mean", "deg", {}, "\"good phase current\"", whole.summary.commutation_error_mean_deg,
           "true angle"},
          {"steps lost at 12 V", "", 0, "", double(whole.summary.step_outs), ""},
          {fmt::format("phase margin at {:.0f} r/min, computed", kSpinning), "deg", {}, "not printed",
           margin_once_per_turn(d, pairs, kSpinning), "Fig. 6's 55 deg are of the equations; the error of a crossing is held for a turn"},
          {"the same, measured", "deg", {}, "not printed", seen.margin_deg, ""},
          {"the loop is unstable below, computed", "r/min", {}, "not printed", least_stable_rpm(d, pairs), "phase margin 0"},
          {fmt::format("locks that last, of one start from rest to {:.0f} r/min", drive.scenario.speed_rpm), "", 1, "",
           double(rest.summary.locked),
           fmt::format("{} locks lost and {} retries in {} s", rest.summary.lost_locks, rest.summary.retries, rest.record.simulated_s)},
          {"slowed down, the drive gives up its lock at", "r/min", {}, "not printed", gave_up, ""},
      },
      .figures = {falling(slows, d)}};
  if (!whole.summary.locked || whole.summary.step_outs > 0) section.failures.push_back("one crossing a turn at 12 V: the lock");
  return section;
}

}  // namespace steplock::amano2003
