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

// A drive that is lost has no error and no angle; one that swings has a mean that says little.
constexpr double kSwings = 25;  // percent of the set speed, peak to peak
std::string told(const Point& p) {
  if (!p.held) return "**lost**";
  if (p.swing_percent() > kSwings) return fmt::format("swings {:.0f} %", p.swing_percent());
  return fmt::format("{:+.1f} deg", p.delta_deg);
}

constexpr double kSpeeds[] = {100, 300, 1200};

// One row: both estimators at each speed, with the torque put on at once and, if that ends otherwise, slowly.
std::string mapped(const design::Settings& drive, const Wrong& w, const PaperOptions& options, int& lost, int& at_once) {
  std::string row = fmt::format("| {} |", w.name);
  for (const Estimator e : {Estimator::kCurrent, Estimator::kVoltage}) {
    for (const double rpm : kSpeeds) {
      Case c{.engine = EngineKind::kFixed, .estimator = e, .rpm = rpm, .i_gamma = 0.8, .torques = {1}};
      const Point step = measure(drive, plant_of(drive, w), c, options, w.name).front();
      c.slowly = true;
      const Point slow = measure(drive, plant_of(drive, w), c, options, w.name).front();
      lost += !slow.held;
      at_once += slow.held && !step.held;
      row += step.held == slow.held ? " " + told(slow) + " |" : fmt::format(" {}; slowly {} |", told(step), told(slow));
    }
  }
  return row + "\n";
}

}  // namespace

PaperSection wrong_parameters(const design::Settings& drive, const PaperOptions& options) {
  const auto& motor = design::sinusoidal::design_drive(drive).parameters.motor;
  const double rated = rated_torque(drive) / motor.pole_pairs / motor.k_e;
  std::string map =
      "\n\n| believed, over real | current model, 100 r/min | 300 | 1200 | voltage model, 100 r/min | 300 | 1200 |\n"
      "|---|---|---|---|---|---|---|\n";
  int lost = 0, at_once = 0, cells = 0;
  const Wrong all[] = {{"K_E x 0.5", 1, 1, 0.5},  {"K_E x 0.75", 1, 1, 0.75}, {"K_E x 0.9", 1, 1, 0.9}, {"K_E x 1.1", 1, 1, 1.1},
                       {"K_E x 1.25", 1, 1, 1.25}, {"K_E x 1.5", 1, 1, 1.5},   {"R x 0.5", 0.5, 1, 1},   {"R x 0.7", 0.7, 1, 1},
                       {"R x 0.9", 0.9, 1, 1},     {"R x 1.1", 1.1, 1, 1},     {"R x 1.3", 1.3, 1, 1},   {"R x 1.5", 1.5, 1, 1},
                       {"L x 0.5", 1, 0.5, 1},     {"L x 0.8", 1, 0.8, 1},     {"L x 1.2", 1, 1.2, 1},   {"L x 1.5", 1, 1.5, 1}};
  for (const Wrong& w : all) {
    map += mapped(drive, w, options, lost, at_once);
    cells += 2 * static_cast<int>(std::size(kSpeeds));
  }
  PaperSection s{
      .title = "Fig. 5(b) and around it: wrong parameters",
      .text = fmt::format(
          "What the drive believes, over what the motor is; rated torque, 0.8 A of gamma current, engine `fixed`. Of {} cells {} are lost however "
          "slowly the torque comes, and {} more if all of it comes at once, which stops a slow rotor: those say *slowly* what becomes of them when it is "
          "raised over a second. What is held has delta theta, "
          "which costs torque; *swings* is a true speed that moves by more than {:g} % of the set one, peak to peak. At 100 r/min the EMF "
          "is {:.1f} V, and 10 % of R at rated current are {:.1f} V. In the voltage model K_E is a factor of the speed itself (Sec. IX of the "
          "paper says the same), in the current model of the angle alone. The paper shows K_E x 1.25 with the current model.{}",
          cells, lost, at_once, kSwings, motor.k_e * design::sinusoidal::speed_of(drive, 100), 0.1 * motor.resistance * rated, map)};
  const Wrong shown{"K_E x 1.25", 1, 1, 1.25};
  const auto points = measure(drive, plant_of(drive, shown),
                              {.engine = EngineKind::kFixed,
                               .estimator = Estimator::kCurrent,
                               .rpm = 1200,
                               .i_gamma = 0.8,
                               .torques = {0, 1}},
                              options, shown.name);
  s.claims.push_back({"current model, K_E x 1.25, 1200 r/min, torque 0, 100 %: worst error of the mean", "%", {}, "good agreement",
                      worst_error(points), all_held(points) ? "held" : "**lost**"});
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
