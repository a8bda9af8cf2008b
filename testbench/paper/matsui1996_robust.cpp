// Figs. 5(b) and 6 of Matsui 1996: wrong parameters, and the rated torque put on and taken off.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include "model/design/sinusoidal/design.hpp"
#include "testbench/paper/matsui1996.hpp"
#include "testbench/run/units.hpp"

namespace steplock::matsui1996 {
namespace {

using design::Estimator;

// What the drive believes of one parameter, over what is.
struct Wrong {
  const char* parameter;
  double factor;
  bool is(const char* name) const { return std::string_view(parameter) == name; }
  double of(const char* name) const { return is(name) ? factor : 1; }
  std::string name() const { return fmt::format("{} x {:g}", parameter, factor); }
};

design::Settings plant_of(design::Settings s, const Wrong& w) {
  s.motor.resistance_ohm /= w.of("R");
  s.motor.inductance_h /= w.of("L");
  s.motor.mutual_h /= w.of("L");
  s.motor.flux_vs /= w.of("K_E");
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

// One place of the map: with the torque put on at once, and slowly.
struct Place {
  Wrong wrong;
  Estimator estimator;
  double rpm;
  Point step, slow;
};

std::vector<Place> mapped(const design::Settings& drive, const Wrong& w, const PaperOptions& options) {
  std::vector<Place> row;
  for (const Estimator e : {Estimator::kCurrent, Estimator::kVoltage}) {
    for (const double rpm : kSpeeds) {
      Case c{.engine = EngineKind::kFixed, .estimator = e, .rpm = rpm, .i_gamma = 0.8, .torques = {1}};
      Place place{w, e, rpm, measure(drive, plant_of(drive, w), c, options, w.name()).front(), {}};
      c.slowly = true;
      place.slow = measure(drive, plant_of(drive, w), c, options, w.name()).front();
      row.push_back(std::move(place));
    }
  }
  return row;
}

std::string cell(const Place& p) {
  return p.step.held == p.slow.held ? told(p.step) : fmt::format("{}; slowly {}", told(p.step), told(p.slow));
}

// Delta theta over what is believed of each parameter; at the bottom of a panel what is lost.
Figure figure_of(const std::vector<Place>& places) {
  Figure f{.name = "fig5b",
           .title = "Fig. 5(b) and around it: delta theta with wrong parameters",
           .axis = "believed, over real",
           .caption = "Delta theta of current and voltage model at 100, 300 and 1200 r/min under rated torque, raised slowly; a dot at the "
                      "bottom is a drive that is lost, one line of them for each model."};
  constexpr double kLowest = -40;
  const char* colors[][std::size(kSpeeds)] = {{palette::kU, palette::kV, palette::kW}, {palette::kTrue, palette::kDrive, palette::kQuiet}};
  for (const char* parameter : {"K_E", "R", "L"}) {
    Panel panel{.label = fmt::format("{}: deg", parameter), .weight = 1.8, .extra = fmt::format("set yrange [{}:30]\n", kLowest)};
    for (const Estimator e : {Estimator::kCurrent, Estimator::kVoltage}) {
      const bool current = e == Estimator::kCurrent;
      Curve lost{current ? "current, lost" : "voltage, lost", palette::kTrue, {}};
      lost.dots = true;
      for (std::size_t k = 0; k < std::size(kSpeeds); ++k) {
        Curve held{fmt::format("{}, {:g}", current ? "current" : "voltage", kSpeeds[k]), colors[current ? 0 : 1][k], {}};
        for (const Place& p : places) {
          if (!p.wrong.is(parameter) || p.estimator != e || p.rpm != kSpeeds[k]) continue;
          if (p.slow.held) held.points.push_back({p.wrong.factor, p.slow.delta_deg});
          else lost.points.push_back({p.wrong.factor, kLowest + (current ? 2 : 5)});
        }
        panel.curves.push_back(std::move(held));
      }
      if (!lost.points.empty()) panel.curves.push_back(std::move(lost));
    }
    f.panels.push_back(std::move(panel));
  }
  return f;
}

}  // namespace

PaperSection wrong_parameters(const design::Settings& drive, const PaperOptions& options) {
  const auto& motor = design::sinusoidal::design_drive(drive).parameters.motor;
  const double rated = rated_torque(drive) / motor.pole_pairs / motor.k_e;
  std::string map =
      "\n\n| believed, over real | current model, 100 r/min | 300 | 1200 | voltage model, 100 r/min | 300 | 1200 |\n"
      "|---|---|---|---|---|---|---|\n";
  std::vector<Place> places;
  const std::pair<const char*, std::vector<double>> all[] = {
      {"K_E", {0.5, 0.75, 0.9, 1.1, 1.25, 1.5}}, {"R", {0.5, 0.7, 0.9, 1.1, 1.3, 1.5}}, {"L", {0.5, 0.8, 1.2, 1.5}}};
  for (const auto& [parameter, factors] : all) {
    for (const double factor : factors) {
      const Wrong w{parameter, factor};
      map += fmt::format("| {} |", w.name());
      for (Place& p : mapped(drive, w, options)) {
        map += fmt::format(" {} |", cell(p));
        places.push_back(std::move(p));
      }
      map += "\n";
    }
  }
  const auto lost = std::ranges::count_if(places, [](const Place& p) { return !p.slow.held; });
  const auto at_once = std::ranges::count_if(places, [](const Place& p) { return p.slow.held && !p.step.held; });
  PaperSection s{
      .title = "Fig. 5(b) and around it: wrong parameters",
      .text = fmt::format(
          "What the drive believes, over what the motor is; rated torque, 0.8 A of gamma current, engine `fixed`. Of {} cells {} are lost however "
          "slowly the torque comes, and {} more if all of it comes at once, which stops a slow rotor: those say *slowly* what becomes of them when it is "
          "raised over a second. What is held has delta theta, "
          "which costs torque; *swings* is a true speed that moves by more than {:g} % of the set one, peak to peak. At 100 r/min the EMF "
          "is {:.1f} V, and 10 % of R at rated current are {:.1f} V. In the voltage model K_E is a factor of the speed itself (Sec. IX of the "
          "paper says the same), in the current model of the angle alone. The paper shows K_E x 1.25 with the current model.{}",
          places.size(), lost, at_once, kSwings, motor.k_e * design::sinusoidal::speed_of(drive, 100),
          0.1 * motor.resistance * rated, map)};
  const Wrong shown{"K_E", 1.25};
  const auto points = measure(drive, plant_of(drive, shown),
                              {.engine = EngineKind::kFixed,
                               .estimator = Estimator::kCurrent,
                               .rpm = 1200,
                               .i_gamma = 0.8,
                               .torques = {0, 1}},
                              options, shown.name());
  s.claims.push_back({"current model, K_E x 1.25, 1200 r/min, torque 0, 100 %: worst error of the mean", "%", {}, "good agreement",
                      worst_error(points), all_held(points) ? "held" : "**lost**"});
  s.figures = {figure_of(places)};
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
