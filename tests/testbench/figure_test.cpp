#include "testbench/report/figure.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "tests/testbench/own_folder.hpp"

namespace steplock {
namespace {

Figure example() {
  return {.name = "example",
          .title = "A rotor's start",
          .axis = "time, s",
          .panels = {{.label = "speed, rpm", .curves = {{"rotor", palette::kTrue, {{0, 0}, {1, 9}}}}},
                     {.label = "duty", .curves = {{"", palette::kW, {{0, 1}, {1, 0}}, 1, true}}}},
          .marks = {{0.5, "locked"}}};
}

std::string read(const std::filesystem::path& path) {
  std::ifstream in(path);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

TEST(Figure, ShowsTitleAxisLabelsAndMarks) {
  const std::filesystem::path here = own_folder();
  ASSERT_TRUE(draw(example(), here));
  const std::string svg = read(here / "example.svg");
  for (const char* text : {"A rotor's start", "time, s", "speed, rpm", "duty", "locked", "rotor"}) {
    EXPECT_NE(svg.find(text), svg.npos) << text;
  }
}

// A point with a bar is drawn from its least to its greatest, and at its own place.
TEST(Figure, APointMayHaveABar) {
  Figure f = example();
  f.panels = {{.label = "speed", .curves = {{"swing", palette::kW, {{1, 5}, {2, 6}}}}}};
  f.panels[0].curves[0].bars = {{4, 7}, {5.5, 6.5}};
  const std::string script = gnuplot_script(f, "out.svg");
  EXPECT_NE(script.find("1 5 4 7\n2 6 5.5 6.5\n"), script.npos) << script;
  EXPECT_NE(script.find("using 1:2:3:4 with yerrorbars"), script.npos);
  const std::filesystem::path here = own_folder();
  EXPECT_TRUE(draw(f, here));
}

std::string labels_of_axis(double low, double high) {
  Figure f = example();
  f.marks = {};
  f.logarithmic = true;
  f.panels = {{.label = "gain", .curves = {{"", palette::kW, {{low, 1}, {high, 2}}}}}};
  const std::string script = gnuplot_script(f, "out.svg");
  const auto from = script.find("set xtics (") + 11;
  return script.substr(from, script.find(')', from) - from);
}

// A value can be read off between two labels, whether the axis is short or long.
TEST(Figure, ALogarithmicAxisHasLabelsEnough) {
  EXPECT_EQ(labels_of_axis(1, 2000), "1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000");
  EXPECT_EQ(labels_of_axis(1e-4, 10), "0.0001, 0.001, 0.01, 0.1, 1, 10");
  EXPECT_EQ(labels_of_axis(0.5, 20), "0.5, 1, 2, 5, 10, 20");
  EXPECT_EQ(labels_of_axis(3, 8), "3, 4, 5, 6, 7, 8");
}

// No point stands on the border: the axis goes on by two hundredths of its length either way.
TEST(Figure, ALogarithmicAxisIsLongerThanItsPoints) {
  Figure f = example();
  f.logarithmic = true;
  f.panels = {{.label = "gain", .curves = {{"", palette::kW, {{1, 1}, {100, 2}}}}}};
  EXPECT_NE(gnuplot_script(f, "out.svg").find("set xrange [0.9120108:109.6478]"), std::string::npos);
}

TEST(Figure, TheSameNumbersGiveTheSameBytes) {
  const std::filesystem::path here = own_folder();
  ASSERT_TRUE(draw(example(), here));
  const std::string first = read(here / "example.svg");
  ASSERT_TRUE(draw(example(), here));
  EXPECT_EQ(read(here / "example.svg"), first);
}

TEST(Figure, ThinningKeepsBothEnds) {
  std::vector<Point> points;
  for (int i = 0; i < 10000; ++i) points.push_back({i * 1.0, i * 2.0});
  const auto few = thinned(points, 100);
  ASSERT_EQ(few.size(), 100u);
  EXPECT_EQ(few.front().x, 0);
  EXPECT_EQ(few.back().x, 9999);
  EXPECT_EQ(thinned({{1, 2}, {3, 4}}, 100).size(), 2u);
}

// 1000 periods of a pulse that is high for a tenth of each, 50 samples a period: every fiftieth sample, as
// even thinning takes them, is of the same level.
TEST(Figure, OutliningKeepsEndsAndEveryPulse) {
  std::vector<Point> points;
  for (int i = 0; i < 50'000; ++i) points.push_back({i * 1.0, i % 50 < 5 ? 1.0 : 0.0});
  const auto few = outlined(points, 1000);
  EXPECT_LE(few.size(), 1000u);
  EXPECT_EQ(few.front().x, 0);
  EXPECT_EQ(few.back().x, 49'999);
  // Any stretch of two holds both levels.
  for (std::size_t i = 2; i < few.size(); ++i) {
    ASSERT_LT(few[i - 1].x, few[i].x);
    ASSERT_TRUE(few[i - 2].y != few[i].y || few[i - 1].y != few[i].y) << few[i].x;
  }
  EXPECT_EQ(outlined({{1, 2}, {3, 4}}, 100).size(), 2u);
}

// A level that changes once does so in its own place.
TEST(Figure, OutliningLeavesAStepWhereItIs) {
  std::vector<Point> points;
  for (int i = 0; i < 10'000; ++i) points.push_back({i * 1.0, i < 4321 ? 3.0 : 1.0});
  const auto few = outlined(points, 100);
  const auto down = std::ranges::find(few, 1.0, &Point::y);
  EXPECT_EQ(down->x, 4321);
}

}  // namespace
}  // namespace steplock
