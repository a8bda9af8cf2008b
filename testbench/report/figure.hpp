// Figures: panels stacked over one axis, drawn by gnuplot as SVG.  The same numbers give the same bytes.
//
// Doc: docs/report.md   Test: tests/testbench/figure_test.cpp
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace steplock {

struct Point {
  double x, y;
};

struct Curve {
  std::string title;
  std::string color;          // "#1f5fa8"
  std::vector<Point> points = {};
  double width = 1.4;
  bool steps = false;         // holds each value until the next
  bool dots = false;          // points, not joined
  std::vector<std::pair<double, double>> bars = {};  // of each point, if any: least and greatest
};

struct Tick {
  double at;
  std::string text;
};

struct Panel {
  std::string label;          // of the vertical axis
  std::vector<Curve> curves = {};
  double weight = 1;          // share of the height
  std::optional<std::pair<double, double>> range = {};  // of that axis, if the curves do not tell it
  std::vector<Tick> ticks = {};  // names in place of its numbers
  std::string extra = {};        // gnuplot lines for this panel alone
};

struct Mark {
  double x;
  std::string text;
};

struct Figure {
  std::string name;           // of the file, without ending
  std::string title, axis = {}, caption = {};
  std::vector<Panel> panels = {};
  std::vector<Mark> marks = {};// vertical lines through all panels
  bool logarithmic = false;   // horizontal axis
};

std::string gnuplot_script(const Figure&, const std::string& svg_path);

// False if gnuplot is missing or refuses.
bool draw(const Figure&, const std::filesystem::path& directory);
// All of them, in a directory that it makes.  Throws std::runtime_error if gnuplot does not run.
void draw_all(const std::vector<Figure>&, const std::filesystem::path& directory);

// A curve of at most `most` points that covers what this one covers: both ends, and of every stretch
// between them its lowest and its highest point.  A figure shows no more; and every tenth sample of a
// waveform with PWM would show another waveform.
std::vector<Point> outlined(const std::vector<Point>& points, std::size_t most = 1500);
// At most `most` of points that are not a curve, evenly thinned.
std::vector<Point> thinned(std::vector<Point> points, std::size_t most = 1500);

namespace palette {
inline constexpr const char* kU = "#c0392b";
inline constexpr const char* kV = "#1f7a4d";
inline constexpr const char* kW = "#1f5fa8";
inline constexpr const char* kTrue = "#22313f";
inline constexpr const char* kDrive = "#e08214";
inline constexpr const char* kQuiet = "#9aa5b1";
}  // namespace palette

}  // namespace steplock
