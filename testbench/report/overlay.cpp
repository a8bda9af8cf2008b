#include "testbench/report/overlay.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "testbench/drive_file/csv_cells.hpp"
#include "testbench/drive_file/drive_file.hpp"
#include "testbench/report/page.hpp"
#include "testbench/report/report.hpp"
#include "testbench/report/zoom.hpp"

namespace steplock {
namespace {

using Json = nlohmann::ordered_json;

// What a run is called: its folder, and as much of the way there as it takes to tell two.
std::pair<std::string, std::string> names(const RunFolder& a, const RunFolder& b) {
  if (a.path.filename() != b.path.filename()) return {a.path.filename().string(), b.path.filename().string()};
  return {a.path.string(), b.path.string()};
}

// y(file) of each run over its time; `from` is what counts as 0.
template <class Y>
Curve curve(const RunFolder& run, const std::string& name, const char* color, const std::string& file, double scale, const Y& y) {
  Curve c{name, color, {}};
  const auto time = run.column(file, "time_s");
  const std::vector<double> values = y(run);
  if (values.size() != time.size() || time.empty()) return c;
  const double from = file == "run.csv" ? 0 : time.front();
  for (std::size_t k = 0; k < time.size(); ++k) c.points.push_back({(time[k] - from) * scale, values[k]});
  c.points = outlined(c.points);
  return c;
}

std::vector<double> largest_current(const RunFolder& run, const std::string& file) {
  std::vector<double> most = run.column(file, "iu_a");
  for (const char* phase : {"iv_a", "iw_a"}) {
    const auto other = run.column(file, phase);
    if (other.size() != most.size()) return {};
    for (std::size_t k = 0; k < most.size(); ++k) most[k] = std::max(std::abs(most[k]), std::abs(other[k]));
  }
  return most;
}

std::string difference(const Json& a, const Json& b) {
  if (!a.is_number() || !b.is_number()) return number_text(a) == number_text(b) ? "" : "differs";
  const double x = a.get<double>(), y = b.get<double>();
  if (x == y) return "";
  return x == 0 ? fmt::format("{:+.4g}", y) : fmt::format("{:+.4g} ({:+.3g} %)", y - x, 100 * (y / x - 1));
}

}  // namespace

RunFolder::RunFolder(const std::filesystem::path& folder)
    : path(folder.has_filename() ? folder : folder.parent_path()) {
  std::ostringstream read;
  const std::ifstream in(path / "summary.json");
  if (!in || !(read << in.rdbuf())) {
    throw BadInput(fmt::format("{}: no summary.json in it; name a folder that `steplock run` wrote", path.string()));
  }
  summary = read.str();
  if (!Json::accept(summary) || !Json::parse(summary).is_object()) {
    throw BadInput(fmt::format("{}: is no summary of a run; run it again", (path / "summary.json").string()));
  }
}

std::vector<double> RunFolder::column(const std::string& file, const std::string& name) const {
  std::ifstream in(path / file);
  std::string line;
  if (!std::getline(in, line)) return {};
  const auto header = csv_cells(line);
  const auto at = std::ranges::find(header, name) - header.begin();
  std::vector<double> values;
  if (at == std::ssize(header)) return values;
  for (int number = 2; std::getline(in, line); ++number) {
    const auto row = csv_cells(line);
    try {
      values.push_back(std::stod(std::string(row.at(static_cast<std::size_t>(at)))));
    } catch (const std::exception&) {
      throw BadInput(fmt::format("{}:{}: {} is no number here; run it again", (path / file).string(), number, name));
    }
  }
  return values;
}

std::vector<Figure> overlay_figures(const RunFolder& a, const RunFolder& b) {
  const auto [name_a, name_b] = names(a, b);
  const auto panel = [&, &name_a = name_a, &name_b = name_b](const char* label, const std::string& file, double scale, const auto& y,
                                                             double weight = 1) {
    Panel p{.label = label, .weight = weight};
    p.curves = {curve(a, name_a, palette::kW, file, scale, y), curve(b, name_b, palette::kDrive, file, scale, y)};
    if (std::ranges::any_of(p.curves, [](const Curve& c) { return c.points.empty(); })) p.curves.clear();  // not of both
    return p;
  };
  const auto of = [](const std::string& file, const char* column) {
    return [=](const RunFolder& run) { return run.column(file, column); };
  };
  const auto current = [](const std::string& file) { return [=](const RunFolder& run) { return largest_current(run, file); }; };
  const std::string whole = "run.csv", steady = "steady.csv";
  std::vector<Figure> all = {
      {.name = "overlay_run", .title = "The whole run", .axis = "time, s", .caption = "Of the currents the largest of the three phases.",
       .panels = {panel("speed, rpm", whole, 1, of(whole, "speed_rpm"), 1.4), panel("phase current, A", whole, 1, current(whole)),
                  panel("torque, N m", whole, 1, of(whole, "torque_nm")), panel("duty", whole, 1, of(whole, "duty"))}},
      {.name = "overlay_steady", .title = "Steady state", .axis = "time, ms",
       .caption = "Two electrical turns of each before the first disturbance, from where their samples begin.",
       .panels = {panel("speed, rpm", steady, 1e3, of(steady, "speed_rpm")),
                  panel("current of u, A", steady, 1e3, of(steady, "iu_a"), 1.4)}}};
  for (Figure& f : all) std::erase_if(f.panels, [](const Panel& p) { return p.curves.empty(); });
  std::erase_if(all, [](const Figure& f) { return f.panels.empty(); });
  return all;
}

std::string overlay_page(const RunFolder& a, const RunFolder& b, const std::vector<Figure>& figures, const std::filesystem::path& out) {
  const auto [name_a, name_b] = names(a, b);
  std::string page = fmt::format("<h1>{} and {}</h1>\n", escaped(name_a), escaped(name_b));
  std::vector<PageFigure> drawn;
  for (const Figure& f : figures) drawn.push_back({f.caption, inline_svg(out / (f.name + ".svg")), zoom_body(f)});
  page += figures_html(drawn);
  page += fmt::format("<h2>All numbers</h2>\n<div class=\"box\"><table>\n<tr><th></th><th>{}</th><th>{}</th><th>difference</th></tr>\n",
                      escaped(name_a), escaped(name_b));
  const Json of_a = Json::parse(a.summary).flatten(), of_b = Json::parse(b.summary).flatten();
  const auto row = [&](std::string key, const Json& x, const Json& y) {
    key = key.substr(1);
    std::ranges::replace(key, '/', '.');
    page += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n", escaped(key), escaped(number_text(x)),
                        escaped(number_text(y)), difference(x, y));
  };
  for (const auto& [key, value] : of_a.items()) row(key, value, of_b.contains(key) ? of_b[key] : Json());
  for (const auto& [key, value] : of_b.items()) {
    if (!of_a.contains(key)) row(key, Json(), value);
  }
  return html_page(name_a + " and " + name_b, page + "</table></div>\n", zoom_head());
}

}  // namespace steplock
