// Figs. 10 to 12 of Amano 2003, and the loop forms on the rotor without its fan.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "model/design/design.hpp"
#include "testbench/paper/amano2003.hpp"
#include "testbench/paper/panels.hpp"

namespace steplock::amano2003 {
namespace {

bool kept(const Trial& t) {
  return t.summary.locked && t.summary.step_outs == 0 && t.summary.lost_locks == 0;
}

double electrical_hz(const Trial& t) {
  return t.summary.steady.mean_rpm / 60 * t.settings.motor.pole_pairs;
}

Figure current_figure(std::string name, std::string title, const Trial& t) {
  return {.name = std::move(name), .title = std::move(title), .axis = "time, ms",
          .caption = "Two electrical turns.",
          .panels = {{.label = "V_phv, V",
                      .curves = {curve_of(t.record.steady, "terminal v", palette::kV,
                                          [](const Sample& x) { return x.plant.voltage[1]; })}},
                     {.label = "I_phv, A",
                      .curves = {phase_current(t.record.steady, 1, "phase v", palette::kV)}}}};
}

}  // namespace

PaperSection varied_load(const design::Settings& drive, const PaperOptions& options) {
  constexpr double kHertz = 85.84, kDifference = 0.6, kPercent = 0.7014;
  const double rpm = kHertz * 60 / drive.motor.pole_pairs;
  // 12 V must hold this speed with the fan, as the paper's did: so a third of the assumed drag.
  design::Settings with = drive;
  with.load.fan_nms2 /= 3;
  const Trial fan = run_trial(steady_run(with, rpm, 8), options, options.engine, "Fig. 10, fan");
  const Trial bare = run_trial(steady_run(without_fan(drive), rpm, 4), options, options.engine,
                               "Fig. 10, without fan");
  const double difference = std::abs(electrical_hz(bare) - electrical_hz(fan));
  PaperSection s{
      .title = "Fig. 10: the load, varied fifteen-fold",
      .text = fmt::format(
          "The same set speed with the fan ({:.2g} kg m^2 in all) and without it ({:.3g} kg m^2); the "
          "paper's loop filter for both. The drag is {:.2g} N m s^2: with the {:.2g} of the other "
          "runs, 12 V do not reach {} Hz.",
          drive.motor.inertia_kgm2 + drive.load.inertia_kgm2, drive.motor.inertia_kgm2,
          with.load.fan_nms2, drive.load.fan_nms2, kHertz),
      .claims = {
          {"frequency without fan", "Hz", kHertz, "", electrical_hz(bare), "set speed", Verdict::kInput},
          {"difference to the one with fan", "Hz", kDifference, "", difference,
           "speed control here has an integral; whether the paper's has one is not printed"},
          {"the same, relative", "%", kPercent, "", 100 * difference / electrical_hz(bare), ""},
          {"current without fan", "A rms", {}, "smaller", bare.summary.rms_current_a, ""},
          {"current with fan", "A rms", {}, "greater", fan.summary.rms_current_a, ""},
          {"steps lost, both", "", 0, "",
           double(fan.summary.step_outs + bare.summary.step_outs), ""}}};
  if (!kept(fan) || !kept(bare)) s.failures.push_back("a lock");
  Figure f{.name = "fig10", .title = "Fig. 10: phase current with and without fan", .axis = "time, ms",
           .caption = "Two electrical turns of each."};
  f.panels.push_back({.label = "with fan, A",
                      .curves = {phase_current(fan.record.steady, 1, "phase v", palette::kV)}});
  f.panels.push_back({.label = "without, A",
                      .curves = {phase_current(bare.record.steady, 1, "phase v", palette::kV)}});
  s.figures.push_back(f);
  return s;
}

PaperSection high_speed(const design::Settings& drive, const PaperOptions& options) {
  constexpr double kFast = 21000, kSlow = 5100, kTurns = 0.33, kVolts = 35;
  const double kMeanHz = kFast / 60 * drive.motor.pole_pairs;
  design::Settings s = redesigned_loop(rewound(without_fan(drive), kTurns), kMeanHz);
  s.inverter.bus_v = kVolts;
  design::Settings at_full_voltage = drive;
  at_full_voltage.inverter.bus_v = kVolts;
  const double drag_kw = drive.load.fan_nms2 * std::pow(kFast * std::numbers::pi / 30, 3) / 1e3;
  s.loop.maximum_rpm = 25000;
  s.start.hand_over_rpm = 1500;
  s.speed.slew_rpm_s = 8000;
  // Of the drive as it is wound: at this speed the back-EMF takes the current down, and the off-time that a ninth of
  // the resistance asks for at a standstill would leave too little of it.
  s.control.limit_off_time_s = design::design_drive(drive).parameters.limit.off_time;
  const Trial fast = run_trial(steady_run(s, kFast, 4.5), options, options.engine, "Fig. 11");
  const Trial slow = run_trial(steady_run(s, kSlow, 2.5), options, options.engine, "Fig. 12");
  PaperSection section{
      .title = "Figs. 11 and 12: 21,000 and 5,100 r/min",
      .text = fmt::format(
          "At {} V Table 1's back-EMF constant allows {:.0f} r/min; this run has {} times the turns of the "
          "printed winding, and no fan, whose drag would take {:.0f} kW at {:.0f} r/min. The loop filter "
          "is designed again, by Eqs. (15)-(17) with f_m = {} Hz, the electrical frequency of that speed.",
          kVolts, no_load_rpm(at_full_voltage), kTurns, drag_kw, kFast, kMeanHz),
      .claims = {{"speed", "r/min", kFast, "", fast.summary.steady.mean_rpm, "set speed", Verdict::kInput},
                 {"commutation against the ideal, mean", "deg", {}, "not printed",
                  fast.summary.commutation_error_mean_deg, "true angle"},
                 {"speed", "r/min", kSlow, "", slow.summary.steady.mean_rpm, "set speed", Verdict::kInput},
                 {"steps lost, both", "", 0, "",
                  double(fast.summary.step_outs + slow.summary.step_outs), ""}}};
  if (!kept(fast)) section.failures.push_back("the lock at 21,000 r/min");
  if (!kept(slow)) section.failures.push_back("the lock at 5,100 r/min");
  section.figures = {current_figure("fig11", "Fig. 11: 21,000 r/min at 35 V", fast),
                     current_figure("fig12", "Fig. 12: 5,100 r/min", slow)};
  return section;
}

PaperSection light_rotor(const design::Settings& drive, const PaperOptions& options) {
  const double rpm = 2575;
  // As a user would who keeps the paper's coefficients and asks for the acceleration that the motor
  // can give, and as the design library limits it.
  design::Settings brisk = without_fan(drive);
  brisk.speed.slew_rpm_s = 20000;
  design::Settings wide = per_step_loop(brisk);
  const Trial paper = run_trial(steady_run(brisk, rpm, 4), options, EngineKind::kFixed,
                                "light rotor, per second");
  const Trial slow = run_trial(steady_run(without_fan(drive), rpm, 4), options, EngineKind::kFixed,
                               "light rotor, limited slew");
  const Trial step = run_trial(steady_run(wide, rpm, 4), options, EngineKind::kFixed,
                               "light rotor, per step");
  const auto told = [](const Trial& t) {
    return kept(t) ? std::string("holds") : "fails: " + t.summary.failures().front();
  };
  PaperSection s{
      .title = "Beyond the paper: coefficients per second and per step",
      .text = fmt::format(
          "The paper's filter crosses over at {:.0f} rad/s at any speed. A rotor without its fan ({:.3g} kg m^2) "
          "accelerates faster than such a loop can follow. Coefficients per step let the bandwidth grow "
          "with speed. All three start the light rotor and go to {} r/min (engine `fixed`, which equals the "
          "RTL on every clock).", design::design_drive(drive).components.omega_g(),
          drive.motor.inertia_kgm2, rpm),
      .claims = {{"per second, 20,000 r/min/s: steps lost", "", {}, "", double(paper.summary.step_outs),
                  told(paper)},
                 {"per second, slew as designed: steps lost", "", {}, "", double(slow.summary.step_outs),
                  told(slow)},
                 {"per second, slew as designed: at set speed after", "s", {}, "",
                  slow.summary.start_time_s.value_or(0), ""},
                 {"per step, 20,000 r/min/s: steps lost", "", {}, "", double(step.summary.step_outs),
                  told(step)},
                 {"per step, 20,000 r/min/s: at set speed after", "s", {}, "",
                  step.summary.start_time_s.value_or(0), ""}}};
  if (!kept(slow) || !kept(step)) s.failures.push_back("a lock that should hold");
  return s;
}

}  // namespace steplock::amano2003
