#include "testbench/report/figure.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

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
  const std::filesystem::path here = testing::TempDir();
  ASSERT_TRUE(draw(example(), here));
  const std::string svg = read(here / "example.svg");
  for (const char* text : {"A rotor's start", "time, s", "speed, rpm", "duty", "locked", "rotor"}) {
    EXPECT_NE(svg.find(text), svg.npos) << text;
  }
}

TEST(Figure, TheSameNumbersGiveTheSameBytes) {
  const std::filesystem::path here = testing::TempDir();
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

}  // namespace
}  // namespace steplock
