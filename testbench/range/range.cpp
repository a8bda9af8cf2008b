#include "testbench/range/range.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "testbench/drive_file/drive_file.hpp"
#include "testbench/run/run_options.hpp"

namespace steplock {

double RangeCurve::cap_erpm() const {
  double cap = 0;
  for (const RangePoint& p : points) {
    if (!p.locked) break;
    cap = p.erpm;
  }
  return cap;
}

Range measure_range(const RangePlan& plan, const design::Settings& drive, double least_erpm,
                    const std::function<bool(double done)>& progress) {
  // Round speeds beat with a round PWM frequency: then samples always fall on the same place.
  constexpr double kNotRound = 1.0037;
  std::vector<double> speeds = plan.erpm;
  if (!(least_erpm <= speeds.back())) {  // so that what is no number is refused, too
    throw BadInput(fmt::format("--from {:g} leaves no speed: name one up to {:g}", least_erpm, speeds.back()));
  }
  std::erase_if(speeds, [&](double erpm) { return erpm < least_erpm; });
  Range range;
  double done = 0;
  for (const RangeSettings& r : plan.settings) {
    RangeCurve curve{r, {}};
    for (const double erpm : speeds) {
      curve.points.push_back(plan.measure(drive, r, kNotRound * erpm));
      done += 1.0 / static_cast<double>(plan.settings.size() * speeds.size());
      if (progress && !progress(done)) throw Stopped();
    }
    range.curves.push_back(curve);
  }
  return range;
}

Figure range_figure(const RangePlan& plan, const Range& range) {
  constexpr std::array kColors = {palette::kTrue, palette::kDrive, palette::kU,
                                  palette::kV,    palette::kW,     palette::kQuiet};
  Figure f{.name = plan.stem, .title = plan.figure_title, .axis = "electrical r/min", .caption = plan.caption,
           .logarithmic = true};
  f.panels.push_back({.label = "worst, degrees electrical", .weight = 2.4,
                      .extra = "set yrange [0:*]\nset format x '%.0f'\n"});
  for (std::size_t i = 0; i < range.curves.size(); ++i) {
    Curve c{fmt::format("row {}", i + 1), kColors[i % kColors.size()], {}, 1.6};
    for (const RangePoint& p : range.curves[i].points) {
      if (p.locked) c.points.push_back({p.erpm, p.worst_deg});
    }
    f.panels[0].curves.push_back(c);
  }
  return f;
}

std::string range_page(const RangePlan& plan, const Range& range) {
  std::string text = fmt::format(
      "# {}\n\nPrinted by `{}`; the test `pages_are_current_{}` fails when this page is stale.\n\n{}\n\n| settings | locks up to, eRPM |",
      plan.title, plan.command, plan.stem, plan.about);
  const auto& speeds = range.curves.front().points;
  const auto shown = [&](double erpm) { return erpm >= plan.shown_from; };
  for (const RangePoint& p : speeds) {
    if (shown(p.erpm)) text += fmt::format(" {:.0f} k |", p.erpm / 1e3);
  }
  text += "\n|---|---:|";
  for (const RangePoint& p : speeds) {
    if (shown(p.erpm)) text += "---:|";
  }
  text += "\n";
  for (const RangeCurve& c : range.curves) {
    text += fmt::format("| {} | {:.0f} |", c.settings.name, c.cap_erpm());
    for (const RangePoint& p : c.points) {
      if (!shown(p.erpm)) continue;
      text += p.locked ? fmt::format(" {:+.2f}, {:.2f} |", p.mean_deg, p.worst_deg) : " - |";
    }
    text += "\n";
  }
  if (!std::ranges::all_of(speeds, [&](const RangePoint& p) { return shown(p.erpm); })) {
    text += "\nSlower speeds stand in the figure alone.\n";
  }
  return text + fmt::format("\nEach cell: {}\n\n![{}](figures/{}.svg)\n\n*{}*\n", plan.cell, plan.figure, plan.stem, plan.caption);
}

}  // namespace steplock
