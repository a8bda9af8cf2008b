// The figures and the page of a sweep.
#include <fmt/format.h>

#include <algorithm>

#include "testbench/report/figure.hpp"
#include "testbench/report/page.hpp"
#include "testbench/report/report.hpp"
#include "testbench/sweep_page/beyond_goals.hpp"
#include "testbench/sweep_page/disturbance_statistics.hpp"
#include "testbench/sweep_page/statistics.hpp"

namespace steplock {
namespace {

using Json = nlohmann::ordered_json;

const char* color(std::size_t k) {
  static constexpr const char* kColors[] = {"#1f5fa8", "#c0392b", "#1f7a4d", "#e08214",
                                            "#7d3c98", "#16a085", "#8d6e63", "#22313f"};
  return kColors[k % std::size(kColors)];
}

// What has a curve of its own: a drive, or all of many.
struct Group {
  std::string name;
  bool all = false;
  bool has(const Row& r) const { return !r.outside && (all || r.drive == name); }
};

std::vector<Group> groups(const SweepSetup& setup) {
  if (of_many(setup)) return {{"all motors", true}};
  std::vector<Group> each;
  for (const SweepDrive& d : setup.drives) each.push_back({d.name});
  return each;
}

// Share of a drive's runs at or below each value, in percent.
template <class Value>
Figure shares(const SweepSetup& setup, const std::vector<Row>& rows, Figure f, const Value& value) {
  Panel panel{.label = "runs, %", .weight = 2.4, .extra = "set yrange [0:100]\n"};
  for (const Group& g : groups(setup)) {
    std::vector<double> values;
    std::size_t all = 0;
    for (const Row& r : rows) {
      if (!g.has(r)) continue;
      ++all;
      if (const auto x = value(r); x && *x > 0) values.push_back(*x);
    }
    std::ranges::sort(values);
    Curve curve{g.name, color(panel.curves.size()), {}, 1.6};
    curve.steps = true;
    for (std::size_t k = 0; k < values.size(); ++k) {
      curve.points.push_back({values[k], 100.0 * static_cast<double>(k + 1) / static_cast<double>(all)});
    }
    panel.curves.push_back(std::move(curve));
  }
  f.panels = {std::move(panel)};
  return f;
}

template <class X, class Y>
Panel dots(const SweepSetup& setup, const std::vector<Row>& rows, const char* label, const X& x, const Y& y) {
  Panel panel{.label = label, .weight = 1.8};
  for (const Group& g : groups(setup)) {
    Curve curve{g.name, color(panel.curves.size())};
    curve.dots = true;
    for (const Row& r : rows) {
      if (!g.has(r)) continue;
      if (const auto value = y(r)) curve.points.push_back({x(r), *value});
    }
    curve.points = thinned(std::move(curve.points), 2000);
    panel.curves.push_back(std::move(curve));
  }
  return panel;
}

// Nearly all end at the limit itself: the axis leaves the lowest eighth out, and has the goal on it.
Figure peak_figure(const SweepSetup& setup, const std::vector<Row>& rows) {
  const auto peak = [&](const Row& r) { return peak_over_limit(setup, r); };
  Figure f = shares(setup, rows,
                    {.name = "peak_current", .title = "Peak phase current", .axis = "current, over the drive's limit",
                     .caption = "Share of the runs inside the envelope whose current never was higher.", .marks = {{kPeakGoal, "goal"}}}, peak);
  std::vector<double> values;
  for (const Row& r : rows) {
    if (const auto x = peak(r); x && !r.outside) values.push_back(*x);
  }
  if (values.empty()) return f;
  std::ranges::sort(values);
  const double low = std::min(0.95, values[values.size() / 8]), high = std::max(kPeakGoal, values.back()) + 0.02;
  f.panels[0].extra += fmt::format("set xrange [{:.3g}:{:.3g}]\n", low, high);
  return f;
}

std::vector<Figure> sweep_figures(const SweepSetup& setup, const std::vector<Row>& rows) {
  if (setup.kind.matrix == Matrix::kDisturb) return disturbance_figures(setup, rows);
  const auto lock = [](const Row& r) { return has_started(r.findings.outcome) ? r.findings.lock_time_s : std::nullopt; };
  std::vector<Figure> all;
  all.push_back(shares(setup, rows,
                       {.name = "lock_time", .title = "Time to lock", .axis = "time after run, s",
                        .caption = "Share of the runs inside the envelope that had locked, for good, by then.",
                        .logarithmic = true},
                       lock));
  all.push_back(peak_figure(setup, rows));
  const auto inertia = [](const Row& r) { return r.conditions.inertia; };
  Figure f{.name = "inertia", .title = "Inertia", .axis = "factor of inertia",
           .caption = "Each dot is a run: how long it took to lock, and how many tries failed before.",
           .logarithmic = true};
  f.panels = {dots(setup, rows, "time to lock, s", inertia, lock),
              dots(setup, rows, "failed tries", inertia,
                   [](const Row& r) { return std::optional(static_cast<double>(r.findings.retries)); })};
  all.push_back(std::move(f));
  Figure kick{.name = "kick", .title = "Backward kick", .axis = "rotor at the start, electrical degrees",
              .caption = "How far the rotor went against its direction, from rest, by where it stood."};
  kick.panels = {dots(setup, rows, "degrees, electrical", [](const Row& r) { return r.conditions.angle_deg; },
                      [](const Row& r) { return r.findings.kick_deg; })};
  all.push_back(std::move(kick));
  // Without a single point gnuplot has no range to draw.
  std::erase_if(all, [](const Figure& figure) {
    return std::ranges::none_of(figure.panels, [](const Panel& p) {
      return std::ranges::any_of(p.curves, [](const Curve& c) { return !c.points.empty(); });
    });
  });
  return all;
}

std::string number(const Json& x) { return x.is_null() ? "-" : fmt::format("{:.4g}", x.get<double>()); }

std::string table_row(const std::string& name, const Json& part, const Json& spreads) {
  std::string cells = fmt::format("<td>{}</td>", escaped(name));
  for (const char* key : {"runs", "started", "started_after_retries", "rough", "latched", "silent_step_outs", "unfinished"}) {
    cells += fmt::format("<td>{}</td>", part[key].get<int>());
  }
  for (const char* key : {"lock_time_s", "speed_time_s", "peak_current_a", "kick_deg"}) {
    const Json& s = spreads[key];
    cells += fmt::format("<td>{} / {} / {}</td>", number(s["min"]), number(s["median"]), number(s["max"]));
  }
  return "<tr>" + cells + "</tr>\n";
}

std::string sweep_page(const SweepSetup& setup, const std::vector<Row>& rows,
                       const std::vector<PageFigure>& figures) {
  if (setup.kind.matrix == Matrix::kDisturb) {
    std::string page = "<h1>Disturbances</h1>\n<pre>" + escaped(sweep_text(setup, rows)) + "</pre>\n";
    return html_page("Sweep", page + figures_html(figures));
  }
  const Json j = sweep_json(setup, rows);
  const bool well = passed(setup, rows);
  std::string page = fmt::format(
      "<h1>{} starts<span class=\"verdict {}\">{}</span></h1>\n<p class=\"sub\">Seed {}, fixed engine; "
      "{} runs repeated on the RTL, {} of them differ.</p>\n",
      rows.size(), well ? "well" : "failed", well ? "passed" : "failed", setup.kind.seed,
      j["rtl_repeats"].get<int>(), j["rtl_differing"].get<int>());
  page += "<div class=\"box\"><table>\n<tr><th>inside the envelope</th><th>runs</th><th>started</th>"
          "<th>after retries</th><th>rough</th><th>latched</th><th>silent step-outs</th><th>unfinished</th>"
          "<th>lock, s: min / median / max</th><th>set speed, s</th><th>peak, A</th><th>kick, deg</th></tr>\n";
  for (const auto& [name, part] : j["per_drive"].items()) page += table_row(name, part, part);
  page += table_row("all", j["inside"], j) + "</table></div>\n";
  if (const Json& o = j["outside_of_envelope"]; o["runs"] > 0) {
    page += fmt::format("<p>Outside the envelope: {} runs, {} started, {} rough, {} latched, {} silent step-outs, "
                        "{} unfinished.</p>\n", o["runs"].get<int>(), o["started"].get<int>(), o["rough"].get<int>(),
                        o["latched"].get<int>(), o["silent_step_outs"].get<int>(), o["unfinished"].get<int>());
  }
  page += figures_html(figures);
  const auto failed = failures(rows);
  if (failed.empty()) return html_page("Sweep", page);
  page += "<h2>Failed</h2>\n<div class=\"box\"><table>\n<tr><th>replay</th><th>outcome</th><th>reason</th>"
          "<th>envelope</th></tr>\n";
  for (const Row* r : failed) {
    page += fmt::format("<tr><td>steplock run {}.toml --replay {}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n",
                        escaped(r->drive), r->seed, name_of(r->findings.outcome), failure(*r),
                        r->outside ? "outside" : "inside");
  }
  return html_page("Sweep", page + "</table></div>\n");
}

}  // namespace

std::vector<std::string> write_sweep_report(const SweepSetup& setup, const std::vector<Row>& rows,
                                            const std::filesystem::path& folder) {
  write_file(folder / "sweep.json", sweep_json(setup, rows).dump(2) + "\n");
  std::vector<PageFigure> figures;
  std::vector<std::string> warnings;
  for (const Figure& figure : sweep_figures(setup, rows)) {
    if (!draw(figure, folder)) {
      warnings.push_back("gnuplot does not run, so there are no figures; install gnuplot-nox");
      break;
    }
    figures.push_back({figure.caption, inline_svg(folder / (figure.name + ".svg"))});
  }
  write_file(folder / "sweep.html", sweep_page(setup, rows, figures));
  return warnings;
}

std::string page_stem(const SweepSetup& setup) {
  const bool sinusoidal = setup.drive_kind == design::DriveKind::kSinusoidal;
  if (setup.kind.matrix == Matrix::kDisturb) return sinusoidal ? "sinusoidal_disturbances" : "disturbances";
  if (setup.kind.matrix == Matrix::kHard) return "hard_starts";
  if (of_drawn_motors(setup)) return "motor_starts";
  return sinusoidal ? "sinusoidal_starts" : "starts";
}

void write_sweep_page(const SweepSetup& setup, const std::vector<Row>& rows, const std::filesystem::path& page) {
  const bool disturb = setup.kind.matrix == Matrix::kDisturb;
  // As many as the tests may repeat.
  const std::uint64_t most = disturb ? 22 : page_stem(setup) == "starts" ? 100 : of_drawn_motors(setup) ? 12 : 60;
  std::vector<Figure> figures = sweep_figures(setup, rows);
  if (!disturb) {  // those that do not grow with every run
    std::erase_if(figures, [](const Figure& f) { return f.name != "lock_time" && f.name != "peak_current"; });
    for (Figure& f : figures) f.name = page_stem(setup) + "_" + f.name;
  }
  draw_all(figures, page.parent_path() / "figures");
  Json j = sweep_json(setup, rows);
  const std::uint64_t prefix = std::min(most, setup.runs);
  j["prefix"] = {{"runs", prefix}, {"digest", prefix_digest(rows, prefix)}};
  std::filesystem::path json = page;
  write_file(json.replace_extension(".json"), j.dump(1) + "\n");
  write_file(page, disturb ? disturbance_page(setup, rows, passed(setup, rows)) : start_page(setup, rows));
}

}  // namespace steplock
