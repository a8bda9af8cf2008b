#include "testbench/report/power_figure.hpp"

#include <algorithm>
#include <utility>

namespace steplock {
namespace {

template <class F>
Curve curve(const std::vector<Power>& spans, const char* title, const char* color, F&& watts) {
  Curve c{title, color};
  for (const Power& p : spans) c.points.push_back({(p.from_s + p.to_s) / 2, watts(p)});
  return c;
}

// Of what comes in: where a rotor slows down, its energy goes to the load beside the source's, and counts as much.
Curve efficiency(const std::vector<Power>& spans) {
  Curve c{"load's share", palette::kV};
  c.dots = true;
  for (const Power& p : spans) {
    if (p.load > 0) c.points.push_back({(p.from_s + p.to_s) / 2, 100 * p.load / (p.input - std::min(0.0, p.stored))});
  }
  return c;
}

}  // namespace

Figure power_figure(const std::vector<Power>& spans, std::vector<Mark> marks) {
  Figure f{.name = "power", .title = "Where the power goes", .axis = "time, s",
           .caption = "Power from the source, to the load and into what is stored (rotor, windings, bus capacitor); what becomes heat on "
                      "the way, and how much of what source and store give the load gets. Iron losses are no part of the plant.",
           .marks = std::move(marks)};
  f.panels = {{.label = "power, W",
               .curves = {curve(spans, "source", palette::kTrue, [](const Power& p) { return p.input; }),
                          curve(spans, "load", palette::kV, [](const Power& p) { return p.load; }),
                          curve(spans, "stored", palette::kQuiet, [](const Power& p) { return p.stored; })},
               .weight = 1.3},
              {.label = "heat, W",
               .curves = {curve(spans, "copper", palette::kU, [](const Power& p) { return p.copper; }),
                          curve(spans, "switches", palette::kW, [](const Power& p) { return p.switches; }),
                          curve(spans, "bus resistance", palette::kDrive, [](const Power& p) { return p.bus_resistance; }),
                          curve(spans, "friction", palette::kQuiet, [](const Power& p) { return p.friction; })}}};
  if (Curve c = efficiency(spans); !c.points.empty()) {
    f.panels.push_back({.label = "efficiency, %", .curves = {std::move(c)}, .range = {{0, 100}}});
  }
  return f;
}

}  // namespace steplock
