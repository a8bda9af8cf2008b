#include "testbench/report/zoom.hpp"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "zoom_script.hpp"

namespace steplock {
namespace {

std::string read(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

// As text within a script: nothing in it ends the element.
std::string quoted(const std::string& text) {
  std::string json = nlohmann::json(text).dump();
  for (std::size_t at = 0; (at = json.find("</", at)) != json.npos; at += 3) json.replace(at, 2, "<\\/");
  return json;
}

// Six digits are more than a screen shows, and a third of what a double takes.
template <class Coordinate>
std::string numbers(const std::vector<Point>& points, Coordinate&& coordinate) {
  std::string all;
  for (const Point& p : points) {
    const double x = coordinate(p);
    all += (all.empty() ? "" : ",") + (std::isfinite(x) ? fmt::format("{:.6g}", x) : std::string("null"));
  }
  return all;
}

std::string curve_text(const Curve& c) {
  return fmt::format(R"({{"title":{},"color":{},"width":{},"steps":{},"dots":{},"x":[{}],"y":[{}]}})", quoted(c.title), quoted(c.color),
                     c.width, c.steps, c.dots, numbers(c.points, [](const Point& p) { return p.x; }),
                     numbers(c.points, [](const Point& p) { return p.y; }));
}

}  // namespace

std::string zoom_head(const std::filesystem::path& library) {
  const std::string script = read(library / "dygraph.min.js"), style = read(library / "dygraph.min.css");
  if (script.empty() || style.empty()) return "";
  // A legend stands above its panel, and names of ticks do not break.
  constexpr const char* kOwn = ".legend { position: relative; z-index: 20; text-align: right; font-size: 14px; line-height: 20px; }\n"
                               ".dygraph-axis-label-y { white-space: nowrap; }\n";
  return "<style>" + style + kOwn + "</style>\n<script>\n" + script + "\n</script>\n<script>\n" + kZoomScript + "</script>\n";
}

std::string zoom_body(const Figure& f) {
  if (f.logarithmic) return "";
  std::string panels, marks;
  for (const Panel& p : f.panels) {
    std::string curves;
    for (const Curve& c : p.curves) curves += (curves.empty() ? "" : ",") + curve_text(c);
    std::string ticks;
    for (const Tick& t : p.ticks) ticks += fmt::format("{}[{:g},{}]", ticks.empty() ? "" : ",", t.at, quoted(t.text));
    const std::string range = p.range ? fmt::format("[{:g},{:g}]", p.range->first, p.range->second) : "null";
    panels += fmt::format(R"({}{{"label":{},"weight":{},"range":{},"ticks":[{}],"curves":[{}]}})", panels.empty() ? "" : ",\n",
                          quoted(p.label), p.weight, range, ticks, curves);
  }
  for (const Mark& m : f.marks) marks += fmt::format("{}[{:.6g},{}]", marks.empty() ? "" : ",", m.x, quoted(m.text));
  return fmt::format("<div class=\"panels\"></div>\n<script>steplockZoom(document.currentScript.parentElement, {{\"axis\":{},\"marks\":[{}],\n"
                     "\"panels\":[{}]}});</script>\n", quoted(f.axis), marks, panels);
}

}  // namespace steplock
