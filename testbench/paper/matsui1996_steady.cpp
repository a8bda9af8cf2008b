// Figs. 4 and 5 of Matsui 1996: angle, and speed error over speed and torque.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "model/design/sinusoidal/design.hpp"
#include "testbench/paper/matsui1996.hpp"
#include "testbench/run/units.hpp"

namespace steplock::matsui1996 {
namespace {

// True and estimated angle over two electrical turns, at every sample.
Figure angles(const design::Settings& drive, design::Estimator estimator, double rpm, double torque,
              std::string name, std::string title) {
  const auto s = steady(drive, estimator, rpm);
  const auto rig = make_rig(EngineKind::kFixed, s, s, 130);
  rig->run_until(0.9);
  rig->set_torque(torque * rated_torque(drive));
  rig->run_until(1.3);
  Curve real{"rotor", palette::kTrue, {}, 2.2}, estimated{"theta_c", palette::kDrive, {}};
  estimated.dots = true;
  Curve delta{"delta theta", palette::kU, {}};
  Curve turns{"rotor", palette::kTrue, {}}, believed{"believed", palette::kDrive, {}};
  const double from = rig->time(), end = 2 * 60 / rpm / drive.motor.pole_pairs;
  for (int n = 1; rig->time() - from < end; ++n) {
    // Just before the next sample's strobe: what is shown belongs to the last one.
    rig->run_until(from + n / drive.control.pwm_hz);
    const double ms = 1e3 * (rig->time() - from), seen = rig->view().angle_deg;
    real.points.push_back(
        {ms, seen + rig->delta_deg() - 360 * std::floor((seen + rig->delta_deg()) / 360)});
    estimated.points.push_back({ms, seen});
    delta.points.push_back({ms, rig->delta_deg()});
    turns.points.push_back({ms, steplock::rpm(rig->state().speed)});
    believed.points.push_back({ms, rig->view().speed_rpm});
  }
  return {.name = std::move(name),
          .title = std::move(title),
          .axis = "time, ms",
          .caption = fmt::format("Two electrical turns at {:g} r/min, {:g} % torque, engine fixed.",
                                 rpm, 100 * torque),
          .panels = {{.label = "angle, deg", .curves = {real, estimated}, .weight = 1.6},
                     {.label = "delta theta, deg", .curves = {delta}},
                     {.label = "speed, r/min", .curves = {turns, believed}}}};
}

struct Grid {
  double rpm, i_gamma;
  std::vector<double> torques;
};

struct Swept {
  std::vector<Claim> claims;
  Panel panel, swing;
  bool held = true;               // nothing lost
  double slowest = 0, worst = 0;  // of what holds from there on, gamma current or not
  double swing_percent = 0;       // at the slowest
};

// The curve of a point's torque: its mean, and as a bar how far the true speed swings.
Curve& bars_of(Panel& panel, double torque, double i_gamma, bool alone) {
  constexpr const char* kColors[] = {palette::kQuiet, palette::kW, palette::kV, palette::kU, palette::kDrive};
  const bool without = alone && i_gamma == 0;
  const std::string title = fmt::format("{}{:g} %{}", without ? "" : "torque ", 100 * torque, without ? ", i_gamma 0" : "");
  const auto at = std::ranges::find(panel.curves, title, &Curve::title);
  if (at != panel.curves.end()) return *at;
  panel.curves.push_back({title, kColors[panel.curves.size() % std::size(kColors)], {}});
  return panel.curves.back();
}

Swept sweep(const design::Settings& drive, design::Estimator estimator,
            const std::vector<Grid>& grid, double limit, const PaperOptions& options,
            const std::string& figure, const std::string& shown, double shown_from) {
  Swept all;
  all.panel.label = "speed error, %";
  all.panel.extra = "set yrange [-1:1]\n";
  all.swing.label = "mean, and swing, %";
  all.swing.weight = 1.8;
  Curve fixed{"engine fixed", palette::kW, {}}, exact{"float", palette::kQuiet, {}};
  fixed.dots = exact.dots = true;
  for (const Grid& g : grid) {
    const std::string what = fmt::format("{}, {:g} r/min", figure, g.rpm);
    const Case c{.estimator = estimator, .rpm = g.rpm, .i_gamma = g.i_gamma, .torques = g.torques};
    const auto points = measure(drive, drive, c, options, what);
    Case c_float = c;
    c_float.engine = EngineKind::kFloat;
    const auto floats = measure(drive, drive, c_float, options, what + ", float");
    for (const Point& p : points) {
      fixed.points.push_back({p.rpm, p.error_percent});
      Curve& bars = bars_of(all.swing, p.torque, g.i_gamma, g.torques.size() == 1);
      // Torques stand beside each other.
      const double beside = 1 + 0.05 * static_cast<double>(&bars - all.swing.curves.data());
      bars.points.push_back({p.rpm * beside, p.error_percent});
      bars.bars.push_back({100 * (p.least_rpm / p.rpm - 1), 100 * (p.greatest_rpm / p.rpm - 1)});
    }
    for (const Point& p : floats) exact.points.push_back({p.rpm, p.error_percent});
    const double worst = worst_error(points);
    const bool good = all_held(points) && worst <= limit;
    std::string torques;
    for (const double t : g.torques)
      torques += fmt::format("{}{:g}", torques.empty() ? "" : ", ", 100 * t);
    std::string reason = fmt::format("float {:.2g} %", worst_error(floats));
    if (!all_held(floats)) reason = "float: lost";
    if (!all_held(points))
      reason = "**missed**: lost; " + reason;
    else if (!good)
      reason = fmt::format("**missed** ({:g} %); ", limit) + reason;
    if (g.i_gamma == 0 && g.rpm <= 50) {
      reason += "; no phase current, see the text";
    }
    const std::string name =
        fmt::format("{:g} r/min{}, torque {} %: worst error of the mean", g.rpm,
                    g.i_gamma == 0 ? "" : fmt::format(", i_gamma {:g} A", g.i_gamma), torques);
    all.claims.push_back(
        {name, "%", {}, g.rpm >= shown_from ? shown : "not reached", worst, reason});
    const Point& most = most_swinging(points);
    all.claims.push_back({"its swing about the mean, peak to peak", "%", {}, "", most.swing_percent(),
                          fmt::format("{:.4g} to {:.4g} r/min at torque {:g} %, rms {:.2g} r/min; delta theta {:.2g} deg rms, "
                                      "{:.2g} at most; float {:.2g} %",
                                      most.least_rpm, most.greatest_rpm, 100 * most.torque, most.rms_rpm, most.delta_rms_deg,
                                      most.delta_greatest_deg, most_swinging(floats).swing_percent())});
    // The slowest speed from which on all is good, with whatever gamma current it took; a lone
    // point without is extra.
    if (g.torques.size() == 1) continue;
    all.held = all.held && all_held(points);
    all.worst = std::max(good ? all.worst : 0, good ? worst : 0);
    if (good && all.slowest == 0) all.swing_percent = most.swing_percent();
    all.slowest = !good ? 0 : all.slowest == 0 ? g.rpm : all.slowest;
  }
  all.panel.curves = {exact, fixed};
  return all;
}

constexpr const char* kGammaText =
    "A gamma current of a tenth of the rated one keeps the phase currents out of the band around "
    "zero where "
    "nobody knows which way dead time acts; the paper holds it at zero. Without it and without "
    "load, pulses that differ by less than "
    "the dead time reach no winding, and the speed swings around its mean.";

}  // namespace

PaperSection voltage_model(const design::Settings& drive, const PaperOptions& options,
                           Found& found) {
  constexpr auto kModel = design::Estimator::kVoltage;
  const std::vector<double> torques = {0, 0.5, 1};
  const Swept swept = sweep(
      drive, kModel,
      {{50, 0, {0}}, {50, 0.8, torques}, {100, 0, {0}}, {100, 0.8, torques}, {1200, 0, torques}},
      0.5, options, "Fig. 4", "within 1 %", 100);
  found.slowest[int(kModel)] = swept.slowest;
  found.error_percent[int(kModel)] = swept.worst;
  found.swing_percent[int(kModel)] = swept.swing_percent;
  PaperSection s{.title = "Fig. 4: voltage model, steady state",
                 .text = fmt::format(
                     "Mean speed over whole electrical turns, the mean of 8 samples in Eq. (7); engine "
                     "`fixed`, which equals the RTL on every clock, and beside it the reference in "
                     "doubles. Aim: "
                     "50 to 1200 r/min within 0.5 %. The mean of a drive that is locked cannot be off by much; what limits it at low "
                     "speed, in the paper as here, is how far the speed swings, so that stands below each mean, of the torque at "
                     "which it swings most. {}",
                     kGammaText),
                 .claims = swept.claims};
  s.claims.push_back(rtl_point(drive,
                               {.estimator = kModel, .rpm = 100, .i_gamma = 0.8, .torques = {1}},
                               "100 r/min", options, s.failures));
  if (!swept.held) s.failures.push_back("the lock");
  s.figures = {
      angles(drive, kModel, 500, 0.5, "fig4a",
             "Fig. 4(a): actual and estimated angle, voltage model"),
      {.name = "fig4b",
       .title = "Fig. 4(b): speed error, voltage model",
       .axis = "speed, r/min",
       .caption = "All torques of the table; each point is a mean over whole electrical turns. Below with how far the true speed swings "
                  "about the set one in that time; torques of one speed stand beside each other.",
       .panels = {swept.panel, swept.swing},
       .logarithmic = true}};
  return s;
}

PaperSection current_model(const design::Settings& drive, const PaperOptions& options,
                           Found& found) {
  constexpr auto kModel = design::Estimator::kCurrent;
  const std::vector<double> torques = {0, 1, -1};
  const Swept swept = sweep(drive, kModel,
                            {{10, 0.8, torques},
                             {35, 0, {0}},
                             {35, 0.8, torques},
                             {100, 0.8, torques},
                             {1200, 0, torques},
                             {1500, 0, torques}},
                            0.2, options, "Fig. 5", "within 0.4 %", 35);
  found.slowest[int(kModel)] = swept.slowest;
  found.error_percent[int(kModel)] = swept.worst;
  found.swing_percent[int(kModel)] = swept.swing_percent;
  PaperSection s{
      .title = "Fig. 5(a), (c): current model, steady state",
      .text = fmt::format("As above, with regeneration. Aim: 10 to 1500 r/min within 0.2 %. {}",
                          kGammaText),
      .claims = swept.claims};
  s.claims.push_back(rtl_point(drive,
                               {.estimator = kModel, .rpm = 100, .i_gamma = 0.8, .torques = {1}},
                               "100 r/min", options, s.failures));
  if (!swept.held) s.failures.push_back("the lock");
  s.figures = {
      angles(drive, kModel, 1200, 1, "fig5a",
             "Fig. 5(a): actual and estimated angle, current model"),
      {.name = "fig5c",
       .title = "Fig. 5(c): speed error, current model",
       .axis = "speed, r/min",
       .caption = "Torques of -100, 0 and 100 %; each point is a mean over whole electrical turns. Below with how far the true speed swings "
                  "about the set one in that time; torques of one speed stand beside each other.",
       .panels = {swept.panel, swept.swing},
       .logarithmic = true}};
  return s;
}

}  // namespace steplock::matsui1996
