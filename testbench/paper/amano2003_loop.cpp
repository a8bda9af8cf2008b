// Fig. 6 of Amano 2003: the designed loop, and the same loop measured.
#include <fmt/format.h>

#include <cmath>

#include "model/design/design.hpp"
#include "testbench/paper/amano2003.hpp"
#include "testbench/paper/loop_response.hpp"

namespace steplock::amano2003 {
namespace {

constexpr double kPhaseLead = 55;  // degrees, Fig. 6

Figure bode_figure(const design::PerSecond& filter, double tick, double interval,
                   const std::vector<LoopPoint>& measured) {
  Figure f{.name = "fig6",
           .title = "Fig. 6: open loop, designed and measured",
           .axis = "omega, rad/s",
           .caption = "Lines: Eqs. (1)-(4), and the same filter as the drive computes it, once per "
                      "tick with the error of the last crossing held. Dots: measured.",
           .panels = {{.label = "gain, dB", .weight = 1.6},
                      {.label = "phase, degrees", .weight = 1.6}},
           .logarithmic = true};
  const auto add = [&](const design::Response& response, const char* name, const char* color) {
    Curve gain{name, color, {}, 1.6}, phase{name, color, {}, 1.6};
    const double low = measured.front().omega / 1.3, high = measured.back().omega * 1.1;
    for (const design::BodePoint& p : design::bode(response, low, high, 200)) {
      gain.points.push_back({p.omega, p.gain_db});
      phase.points.push_back({p.omega, p.phase_deg});
    }
    f.panels[0].curves.push_back(gain);
    f.panels[1].curves.push_back(phase);
  };
  add(design::open_loop(filter), "Eqs. (1)-(4)", palette::kTrue);
  add(design::open_loop_sampled(filter, tick, interval), "as sampled", palette::kDrive);
  Curve gain{"measured", palette::kU, {}}, phase{"measured", palette::kU, {}};
  gain.dots = phase.dots = true;
  for (const LoopPoint& p : measured) {
    gain.points.push_back({p.omega, p.gain_db()});
    phase.points.push_back({p.omega, p.phase_deg()});
  }
  f.panels[0].curves.push_back(gain);
  f.panels[1].curves.push_back(phase);
  return f;
}

}  // namespace

PaperSection loop_response(const design::Settings& drive, const PaperOptions& options) {
  const LoopExperiment e{.rpm = drive.scenario.speed_rpm, .engine = options.engine};
  if (options.progress) options.progress("Fig. 6", 0);
  const std::vector<LoopPoint> measured = measure_loop(drive, e);
  const design::Design d = design::design_drive(drive);
  const design::LoopParameters& loop = d.parameters.loop;
  const design::PerSecond filter{loop.integral, loop.proportional, loop.pole};
  const double interval = 10 / (e.rpm * drive.motor.pole_pairs);
  const double tick = d.parameters.pwm.tick();
  const design::Margins sampled =
      design::margins(design::open_loop_sampled(filter, tick, interval), 1, 500);
  const Crossover seen = crossover(measured);

  return {
      .title = "Fig. 6: Bode plot of the open loop",
      .text = fmt::format(
          "The paper's filter (C1, C2, R as printed) in the drive's words. Measured: {} tones of {} "
          "degree each modulate the phase of a rotor turning at {:.0f} r/min, all at once; the instants "
          "at which the drive commutates are searched for them. H = T / (1 - T).",
          measured.size(), e.tone_deg, e.rpm),
      .claims = {
          {"crossover by Eqs. (13)-(17)", "rad/s", {}, "not printed", d.components.omega_g(), ""},
          {"crossover, measured", "rad/s", {}, "not printed", seen.omega,
           fmt::format("{:+.1f} % of the equations above", 100 * (seen.omega / d.components.omega_g() - 1))},
          {"phase lead at 0 dB by Eqs. (1)-(4)", "deg", kPhaseLead, "", d.continuous.phase_deg, ""},
          {"phase margin as sampled, computed", "deg", kPhaseLead, "", sampled.phase_deg,
           "the error is held from crossing to crossing, half an interval late on average, and the "
           "filter runs once per tick"},
          {"phase margin, measured", "deg", {}, "not printed", seen.margin_deg,
           fmt::format("{:+.1f} deg of the sampled computation", seen.margin_deg - sampled.phase_deg)},
          {fmt::format("the same with one crossing a turn, at {:.0f} r/min, computed", e.rpm), "deg", {}, "not printed",
           margin_once_per_turn(d, drive.motor.pole_pairs, e.rpm),
           "the paper's detector: six times as long from error to error"},
          {fmt::format("and at hand-over, {:.0f} r/min", d.hand_over_rpm), "deg", {}, "not printed",
           margin_once_per_turn(d, drive.motor.pole_pairs, d.hand_over_rpm), "below 0 the loop is unstable"},
      },
      .figures = {bode_figure(filter, tick, interval, measured)}};
}

}  // namespace steplock::amano2003
