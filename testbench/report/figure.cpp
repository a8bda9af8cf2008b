#include "testbench/report/figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <stdexcept>

namespace steplock {
namespace {

std::string quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text) {
    out += c;
    if (c == '\'') out += c;
  }
  return out + "'";
}

struct Span {
  double low, high;
};

// Of a logarithmic axis: a little more than the points take, so that none stands on the border.
Span widened(Span points) {
  const double margin = std::pow(points.high / points.low, 0.02);
  return {points.low / margin, points.high * margin};
}

// Labels of a logarithmic axis: gnuplot's own are the powers of ten, and often one only is in sight.  The
// coarsest of three rows that shows five or more; of many decades the powers of ten.
std::vector<double> labels(Span axis) {
  static const std::vector<double> kRows[] = {{1}, {1, 2, 5}, {1, 2, 3, 4, 5, 6, 7, 8, 9}};
  std::vector<double> found;
  for (const auto& row : kRows) {
    found.clear();
    for (int decade = static_cast<int>(std::floor(std::log10(axis.low))); std::pow(10, decade) <= axis.high; ++decade) {
      for (const double digit : row) {
        const double at = digit * std::pow(10, decade);
        if (at >= axis.low && at <= axis.high) found.push_back(at);
      }
    }
    if (found.size() >= 5) break;
  }
  return found;
}

}  // namespace

std::vector<Point> outlined(const std::vector<Point>& points, std::size_t most) {
  if (points.size() <= most) return points;
  const std::size_t inner = points.size() - 2, stretches = (most - 2) / 2;
  std::vector<Point> kept = {points.front()};
  for (std::size_t k = 0; k < stretches; ++k) {
    const auto from = points.begin() + 1 + static_cast<std::ptrdiff_t>(k * inner / stretches);
    const auto to = points.begin() + 1 + static_cast<std::ptrdiff_t>((k + 1) * inner / stretches);
    const auto lower = [](const Point& a, const Point& b) { return a.y < b.y; };
    const auto low = std::min_element(from, to, lower), high = std::max_element(from, to, lower);
    kept.push_back(*std::min(low, high));
    if (low != high) kept.push_back(*std::max(low, high));
  }
  kept.push_back(points.back());
  return kept;
}

std::vector<Point> thinned(std::vector<Point> points, std::size_t most) {
  if (points.size() <= most) return points;
  std::vector<Point> kept;
  kept.reserve(most);
  for (std::size_t i = 0; i < most; ++i) kept.push_back(points[i * (points.size() - 1) / (most - 1)]);
  return kept;
}

std::string gnuplot_script(const Figure& f, const std::string& svg_path) {
  std::string s;
  const auto add = [&]<class... A>(fmt::format_string<A...> text, A&&... a) {
    fmt::format_to(std::back_inserter(s), text, std::forward<A>(a)...);
  };
  double weights = 0;
  for (const Panel& p : f.panels) weights += p.weight;
  const double height = 126 + 125 * weights;

  // Data first: gnuplot takes no data blocks inside a multiplot.
  double low = 0, high = 0;
  bool any = false;
  for (std::size_t i = 0; i < f.panels.size(); ++i) {
    for (std::size_t j = 0; j < f.panels[i].curves.size(); ++j) {
      add("$d{}_{} << EOD\n", i, j);
      const Curve& c = f.panels[i].curves[j];
      for (std::size_t k = 0; k < c.points.size(); ++k) {
        const Point& p = c.points[k];
        if (c.bars.empty()) {
          add("{:.7g} {:.5g}\n", p.x, p.y);
        } else {
          add("{:.7g} {:.5g} {:.5g} {:.5g}\n", p.x, p.y, c.bars[k].first, c.bars[k].second);
        }
        if (!any || p.x < low) low = p.x;
        if (!any || p.x > high) high = p.x;
        any = true;
      }
      if (c.points.empty()) add("NaN NaN\n");
      add("EOD\n");
    }
  }
  add("set terminal svg size 960,{:.0f} dynamic noenhanced font 'Helvetica,13' background '#ffffff' "
      "name '{}'\nset output {}\n", height, f.name, quoted(svg_path));
  add("set multiplot\nset border 3 lc rgb '#8795a1'\nset tics nomirror font ',11' textcolor rgb '#52606d'\n"
      "set grid lc rgb '#e4e7eb' lt 1 lw 0.6\n"
      "set lmargin at screen 0.09\nset rmargin at screen 0.83\n");
  if (any && high > low) {
    Span axis{low, high};
    if (f.logarithmic && low > 0) {
      axis = widened(axis);
      std::string list;
      for (const double at : labels(axis)) list += fmt::format("{}{:.6g}", list.empty() ? "" : ", ", at);
      add("set logscale x\nset xtics ({})\n", list);
    }
    add("set xrange [{:.7g}:{:.7g}]\n", axis.low, axis.high);
  }
  for (const Mark& m : f.marks) {
    add("set arrow from first {0:.7g}, graph 0 to first {0:.7g}, graph 1 nohead lc rgb '#b8c4ce' "
        "dt 2 back\n", m.x);
  }
  const double top = 1 - 66 / height, bottom = 60 / height, gap = 14 / height;
  double at = top;
  for (std::size_t i = 0; i < f.panels.size(); ++i) {
    const Panel& p = f.panels[i];
    const bool first = i == 0, last = i + 1 == f.panels.size();
    const double below = at - (top - bottom) * p.weight / weights;
    add("set tmargin at screen {:.4f}\nset bmargin at screen {:.4f}\n", at - (first ? 0 : gap / 2),
        below + (last ? 0 : gap / 2));
    // Under the title stand the labels of the marks, so it is placed by hand.
    if (first) {
      add("set label 100 {} at screen 0.09, screen {:.4f} font ',15' textcolor rgb '#22313f'\n",
          quoted(f.title), 1 - 20 / height);
    }
    add("set key at screen 0.845, screen {:.4f} left center Left reverse samplen 1.5 font ',11'\n",
        (at + below) / 2);
    add("set xlabel {} textcolor rgb '#52606d'\nset format x {}\n", last ? quoted(f.axis) : "''",
        last ? "'%g'" : "''");
    if (first) {
      double level = 1.05;
      for (std::size_t k = 0; k < f.marks.size(); ++k) {
        const bool close = k > 0 && f.marks[k].x - f.marks[k - 1].x < 0.09 * (high - low);
        level = close && level < 1.1 ? 1.16 : 1.05;
        add("set label {} {} at first {:.7g}, graph {} font ',10' textcolor rgb '#7b8794' center\n",
            k + 1, quoted(f.marks[k].text), f.marks[k].x, level);
      }
    } else if (i == 1) {
      add("unset label\n");
    }
    // Placed by hand as well: gnuplot's own label goes out of the figure where numbers are long.
    add("set label 101 {} at screen 0.012, screen {:.4f} center rotate by 90 textcolor rgb '#52606d'\n",
        quoted(p.label), (at + below) / 2);
    if (p.range) add("set yrange [{:g}:{:g}]\n", p.range->first, p.range->second);
    std::string names;
    for (const Tick& t : p.ticks) names += fmt::format("{}{} {:g}", names.empty() ? "" : ", ", quoted(t.text), t.at);
    if (!names.empty()) add("set ytics ({}) font ',10'\n", names);
    s += p.extra;
    std::string curves;
    for (std::size_t j = 0; j < p.curves.size(); ++j) {
      const Curve& c = p.curves[j];
      const char* with = c.dots ? "points pt 7 ps 0.4" : c.steps ? "steps" : "lines";
      curves += fmt::format("{}$d{}_{} using {} lc rgb '{}' lw {:g} title {}", curves.empty() ? "" : ", ", i, j,
                            c.bars.empty() ? std::string("1:2 with ") + with : "1:2:3:4 with yerrorbars pt 7 ps 0.5", c.color, c.width,
                            quoted(c.title));
    }
    add("plot {}\n", curves);
    if (p.range || !p.ticks.empty() || !p.extra.empty()) add("set yrange [*:*]\nset ytics auto\n");
    at = below;
  }
  add("unset multiplot\nset output\n");
  return s;
}

bool draw(const Figure& figure, const std::filesystem::path& directory) {
  const std::string script =
      gnuplot_script(figure, (directory / (figure.name + ".svg")).string());
  std::FILE* gnuplot = popen("gnuplot - 2>/dev/null", "w");
  if (gnuplot == nullptr) return false;
  const bool written = std::fwrite(script.data(), 1, script.size(), gnuplot) == script.size();
  return pclose(gnuplot) == 0 && written;
}

void draw_all(const std::vector<Figure>& figures, const std::filesystem::path& directory) {
  std::filesystem::create_directories(directory);
  for (const Figure& f : figures) {
    if (!draw(f, directory)) {
      throw std::runtime_error("gnuplot does not run, so no figure can be drawn; install gnuplot-nox");
    }
  }
}

}  // namespace steplock
