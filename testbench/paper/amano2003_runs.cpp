// Figs. 7 to 9 of Amano 2003: the locked state, the steady state, the current limit.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "testbench/paper/amano2003.hpp"
#include "testbench/paper/panels.hpp"
#include "testbench/paper/waveform.hpp"
#include "testbench/drive/six_step/figures.hpp"

namespace steplock::amano2003 {
namespace {

void check(PaperSection& section, const Trial& t, const char* what) {
  if (!t.summary.locked || t.summary.step_outs > 0 || t.summary.lost_locks > 0) {
    section.failures.push_back(fmt::format("{}: the lock", what));
  }
}

double shunt_crest(const Trial& t) {
  double crest = 0;
  for (const Sample& x : t.record.steady) crest = std::max(crest, x.plant.shunt_current);
  return crest;
}

design::Settings limited(design::Settings s, double amps) {
  s.sensors.limit_a = amps;
  s.start.align_current_a = s.start.start_current_a = 0.8 * amps;
  return s;
}

// Pulses of the current limit per electrical turn, over the steady span.
double hits_per_turn(const Trial& t) {
  const auto& all = t.record.overview;
  const auto from = std::ranges::lower_bound(all, t.summary.steady.from_s, {}, &Sample::time);
  if (from == all.end()) return 0;
  const double turns =
      (all.back().plant.electrical_angle - from->plant.electrical_angle) / (2 * std::numbers::pi);
  return (all.back().drive.limit_hits - from->drive.limit_hits) / turns;
}

double electrical_hz(const Trial& t) {
  return t.summary.steady.mean_rpm / 60 * t.settings.motor.pole_pairs;
}

}  // namespace

PaperSection locked_state(const design::Settings& drive, const PaperOptions& options) {
  constexpr double kFullVoltageRpm = 2400;
  const double out_of_reach = 2800;  // with the fan: so the whole 12 V stay on
  const Trial t = run_trial(steady_run(drive, out_of_reach, 8), options, options.engine, "Fig. 7");
  const auto& fine = t.record.steady;
  PaperSection s{
      .title = "Fig. 7: the locked state at 12 V",
      .text = "The whole 12 V, with the fan. V_phv: terminal of phase V; I_phv: its current; V_d: output "
              "of the loop filter, here a frequency; V_c: the VCO, here its phase within a step.",
      .claims = {{"speed at the whole 12 V", "r/min", {}, "not printed", t.summary.steady.mean_rpm,
                  fmt::format("the fan's drag is assumed, for about {:.0f} r/min", kFullVoltageRpm)},
                 {"phase error of the detector", "deg rms", {}, "\"operating correctly\"",
                  t.summary.phase_error_rms_deg, ""},
                 {"commutation against the ideal, mean", "deg", {}, "\"good phase current\"",
                  t.summary.commutation_error_mean_deg, "true angle"},
                 {"steps lost", "", 0, "", double(t.summary.step_outs), ""}}};
  check(s, t, "Fig. 7");
  s.figures.push_back(
      {.name = "fig7", .title = "Fig. 7: locked, 12 V", .axis = "time, ms",
       .caption = "Two electrical turns.",
       .panels = {{.label = "V_phv, V",
                   .curves = {curve_of(fine, "terminal v", palette::kV,
                                       [](const Sample& x) { return x.plant.voltage[1]; })}},
                  {.label = "I_phv, A", .curves = {phase_current(fine, 1, "phase v", palette::kV)}},
                  {.label = "V_d, Hz",
                   .curves = {curve_of(fine, "filter", palette::kDrive,
                                       [](const Sample& x) { return x.drive.steps_per_second / 6; })}},
                  {.label = "V_c, deg",
                   .curves = {curve_of(fine, "VCO", palette::kW,
                                       [](const Sample& x) { return x.drive.step_phase_deg; })}}}});
  return s;
}

PaperSection steady_state(const design::Settings& drive, const PaperOptions& options) {
  constexpr double kHertz = 169.3, kTurns = 0.45;
  const double rpm = kHertz * 60 / drive.motor.pole_pairs;
  design::Settings s = rewound(per_step_loop(without_fan(drive)), kTurns);
  s.loop.maximum_rpm = 1.5 * rpm;
  const Trial t = run_trial(steady_run(s, rpm, 3), options, options.engine, "Fig. 8");
  PaperSection section{
      .title = "Fig. 8: the steady state at 169.3 Hz",
      .text = fmt::format(
          "The paper multiplies 169.3 Hz by 60 and prints 10,158 r/min; a motor of two pole pairs turns "
          "at half of that. Table 1's back-EMF constant allows {:.0f} r/min at {} V, so this run "
          "has {} times the turns of the printed winding, and no fan.", no_load_rpm(drive),
          drive.inverter.bus_v, kTurns),
      .claims = {{"electrical frequency", "Hz", kHertz, "", electrical_hz(t), "set speed", Verdict::kInput},
                 {"speed", "r/min", 10158, "", t.summary.steady.mean_rpm,
                  "the paper's own pole pairs make it half"},
                 {"phase error of the detector", "deg rms", {}, "not printed",
                  t.summary.phase_error_rms_deg, ""},
                 {"steps lost", "", 0, "", double(t.summary.step_outs), ""}}};
  check(section, t, "Fig. 8");
  for (Figure& f : run_figures(t.settings, t.summary, t.record)) {
    if (f.name != "steady") continue;
    f.name = "fig8";
    f.title = "Fig. 8: gates 120 degrees apart, phase currents";
    f.caption = "Two electrical turns.";
    section.figures.push_back(f);
  }
  return section;
}

PaperSection current_control(const design::Settings& drive, const PaperOptions& options) {
  constexpr double kHits = 6;
  const double out_of_reach = 2840;
  design::Settings bare = per_step_loop(without_fan(drive));
  bare.load.fan_nms2 = drive.load.fan_nms2;  // the drag alone: a limit must still let it start
  bare = steady_run(bare, out_of_reach, 5);
  const Trial free = run_trial(bare, options, EngineKind::kFixed, "Fig. 9, without limit");
  const double crest = shunt_crest(free);
  // The paper prints no threshold.  Each step's crest meets the limit somewhere below the crest of the
  // unlimited current.
  design::Settings s = bare;
  double nearest = 1e9;
  std::string table = "\n\n| threshold, of the crest | limit pulses per period |\n|---:|---:|\n";
  for (const double part : {0.95, 0.96, 0.97, 0.98, 0.99, 1.0}) {
    const design::Settings tried = limited(bare, part * crest);
    const double hits = hits_per_turn(run_trial(tried, options, EngineKind::kFixed, "Fig. 9, threshold"));
    table += fmt::format("| {:.2f} | {:.2f} |\n", part, hits);
    if (std::abs(hits - kHits) < nearest) nearest = std::abs(hits - kHits), s = tried;
  }
  table.pop_back();
  const Trial t = run_trial(s, options, options.engine, "Fig. 9");
  PaperSection section{
      .title = "Fig. 9: current limit with fixed off-time",
      .text = fmt::format(
          "The whole {} V, the fan's drag without its inertia, coefficients per step. The paper prints no "
          "threshold, so some below the crest of the unlimited current ({:.2f} A) are tried (engine `fixed`), and "
          "the one nearest to the paper's six pulses is run and drawn: {:.2f} A.{}", s.inverter.bus_v, crest,
          s.sensors.limit_a, table),
      .claims = {{"limit pulses per period of phase current", "", kHits, "", hits_per_turn(t),
                  "mean over the steady span, at the nearest threshold of the table", Verdict::kFitted},
                 {"peak of the shunt current", "A", {}, "not printed", shunt_crest(t), ""},
                 {"steps lost", "", 0, "", double(t.summary.step_outs), ""}}};
  check(section, t, "Fig. 9");
  const auto& fine = t.record.steady;
  section.figures.push_back(
      {.name = "fig9", .title = "Fig. 9: current limit", .axis = "time, ms",
       .caption = "Two electrical turns: shunt current, the high sides' gates, phase current. While the limit cuts, all gates are off, and "
                  "the current flows back into the bus, through the shunt the other way.",
       .panels = {{.label = "shunt, A",
                   .curves = {curve_of(fine, "shunt", palette::kTrue,
                                       [](const Sample& x) { return x.plant.shunt_current; }, 4000)}},
                  {.label = "high side",
                   .curves = {curve_of(fine, "gate", palette::kDrive, [](const Sample& x) {
                                return (x.watch.bits & 0b010101) != 0 ? 1.0 : 0.0;
                              }, 4000)},
                   .weight = 0.6,
                   .extra = "set yrange [-0.2:1.2]\nset ytics ('off' 0, 'on' 1)\n"},
                  {.label = "I_phv, A",
                   .curves = {phase_current(fine, 1, "phase v", palette::kV)}}}});
  return section;
}

}  // namespace steplock::amano2003
