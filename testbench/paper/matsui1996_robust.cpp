// Figs. 5(b) and 6 of Matsui 1996: wrong parameters, and the rated torque put on and taken off.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "model/design/sinusoidal/design.hpp"
#include "testbench/paper/matsui1996.hpp"
#include "testbench/run/units.hpp"

namespace steplock::matsui1996 {
namespace {

using design::Estimator;

struct Wrong {
  const char* name;
  double resistance, inductance, k_e;  // what the drive believes over what is
};

design::Settings plant_of(design::Settings s, const Wrong& w) {
  s.motor.resistance_ohm /= w.resistance;
  s.motor.inductance_h /= w.inductance;
  s.motor.mutual_h /= w.inductance;
  s.motor.flux_vs /= w.k_e;
  return s;
}

std::string told(const Point& p) {
  return p.held ? fmt::format("{:+.3f} %, {:+.1f} deg", p.error_percent, p.delta_deg) : "lost";
}

}  // namespace

PaperSection wrong_parameters(const design::Settings& drive, const PaperOptions& options) {
  const auto& motor = design::sinusoidal::design_drive(drive).parameters.motor;
  const double rated = rated_torque(drive) / motor.pole_pairs / motor.k_e;
  PaperSection s{
      .title = "Fig. 5(b) and around it: wrong parameters",
      .text = fmt::format(
          "What the drive believes, over what the motor is; rated torque, 0.8 A of gamma current, "
          "the reference in doubles. "
          "The number is the worst mean speed error of both estimators at 100 and 1200 r/min; "
          "beside it speed error and delta theta of each. A wrong parameter shows as an angle, and "
          "costs torque; why the speed is off as well where it is by more than 1 % was not looked "
          "into. What is lost is lost at 100 r/min: there the EMF "
          "is {:.1f} V, and 30 % of R at rated current "
          "are {:.1f} V. In the voltage model K_E is a factor of the speed itself (Sec. IX of the "
          "paper says the same), in the current model of the angle alone.",
          motor.k_e * design::sinusoidal::speed_of(drive, 100), 0.3 * motor.resistance * rated)};
  for (const Wrong& w : {Wrong{"K_E x 1.25", 1, 1, 1.25},
                         {"K_E x 1.1", 1, 1, 1.1},
                         {"K_E x 0.9", 1, 1, 0.9},
                         {"R x 1.3", 1.3, 1, 1},
                         {"R x 0.7", 0.7, 1, 1},
                         {"L x 1.2", 1, 1.2, 1},
                         {"L x 0.8", 1, 0.8, 1}}) {
    double worst = 0;
    std::string told_all;
    for (const Estimator e : {Estimator::kCurrent, Estimator::kVoltage}) {
      told_all += e == Estimator::kCurrent ? "current model" : "; voltage model";
      for (const double rpm : {100.0, 1200.0}) {
        const auto points = measure(drive, plant_of(drive, w),
                                    {.engine = EngineKind::kFloat,
                                     .estimator = e,
                                     .rpm = rpm,
                                     .i_gamma = 0.8,
                                     .torques = {1}},
                                    options, w.name);
        told_all += fmt::format(" {:g}: {}", rpm, told(points.front())) + (rpm == 100 ? "," : "");
        if (points.front().held) worst = std::max(worst, worst_error(points));
      }
    }
    s.claims.push_back({w.name,
                        "%",
                        {},
                        w.k_e == 1.25       ? "current model: good agreement"
                        : w.inductance != 1 ? "robust"
                                            : "not shown",
                        worst,
                        told_all});
  }
  return s;
}

PaperSection torque_on_and_off(const design::Settings& drive, const PaperOptions& options) {
  constexpr double kSpeed = 1200, kOn = 1.1, kOff = 1.5, kEnd = 1.9;
  PaperSection s{.title = "Fig. 6: delta theta under rated torque on and off",
                 .text = fmt::format("At {:g} r/min, a speed that the paper does not name; a step "
                                     "of the whole torque, engine `fixed`. "
                                     "The paper's traces have no numbers in the text.",
                                     kSpeed)};
  Figure f{.name = "fig6",
           .title = "Fig. 6: delta theta, rated torque on and off",
           .axis = "time, s",
           .caption = fmt::format("Torque on at {:g} s, off at {:g} s.", kOn, kOff),
           .marks = {{kOn, "on"}, {kOff, "off"}}};
  for (const Estimator e : {Estimator::kVoltage, Estimator::kCurrent}) {
    const char* name = e == Estimator::kVoltage ? "voltage model" : "current model";
    if (options.progress && !options.progress(std::string("Fig. 6, ") + name, 0)) throw Stopped();
    const auto settings = steady(drive, e, kSpeed);
    const auto rig = make_rig(EngineKind::kFixed, settings, settings, 130);
    Curve angle{name, e == Estimator::kVoltage ? palette::kV : palette::kW, {}};
    Curve speed = angle;
    double worst = 0, dip = 0;
    bool on = false, off = false;
    for (double t = kOn - 0.1; t < kEnd; t += 1e-3) {
      rig->run_until(t);
      if (!on && t >= kOn) rig->set_torque(rated_torque(drive)), on = true;
      if (!off && t >= kOff) rig->set_torque(0), off = true;
      const double now = rpm(rig->state().speed);
      angle.points.push_back({t, rig->delta_deg()});
      speed.points.push_back({t, now});
      worst = std::max(worst, std::abs(rig->delta_deg()));
      dip = std::max(dip, std::abs(now - kSpeed));
    }
    s.claims.push_back(
        {std::string(name) + ": worst delta theta", "deg", {}, "a figure", worst, ""});
    s.claims.push_back(
        {std::string(name) + ": worst speed deviation", "r/min", {}, "not shown", dip, ""});
    if (!rig->locked()) s.failures.push_back(std::string(name) + ": the lock under a torque step");
    f.panels.push_back({.label = "delta theta, deg", .curves = {angle}});
    f.panels.push_back({.label = "speed, r/min", .curves = {speed}});
  }
  s.figures = {f};
  return s;
}

}  // namespace steplock::matsui1996
