#include "testbench/report/watch_chart.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <vector>

namespace steplock {
namespace {

std::vector<std::string> lines(const WatchChart& chart) {
  std::vector<std::string> all;
  std::stringstream text(chart.text());
  for (std::string line; std::getline(text, line);) all.push_back(line);
  return all;
}

constexpr std::size_t kFirstColumn = 14;

TEST(WatchChart, HasAsManyLinesFromItsFirstToItsLast) {
  WatchChart chart(2, 3000);
  EXPECT_EQ(lines(chart).size(), std::size_t{WatchChart::kLines}) << "before a run";
  chart.add(1, 1500, 3, "run");
  EXPECT_EQ(lines(chart).size(), std::size_t{WatchChart::kLines});
  EXPECT_EQ(lines(chart).back(), "              1.000 s: run, 1500.0 r/min, 3.00 A");
}

// A ramp to the set speed: a mark a column, from the lowest row to the highest, each row at its part of the time.
TEST(WatchChart, ARampIsADiagonal) {
  WatchChart chart(1, 1000);
  for (int column = 0; column < 64; ++column) chart.add((column + 0.5) / 64, 1000 * (column + 0.5) / 64, 1, "run");
  const auto drawn = lines(chart);
  for (int row = 0; row < WatchChart::kSpeedRows; ++row) {
    for (int column = 0; column < 64; ++column) {
      const int wanted = WatchChart::kSpeedRows - 1 - static_cast<int>((column + 0.5) / 64 * WatchChart::kSpeedRows);
      EXPECT_EQ(drawn[static_cast<std::size_t>(row)][kFirstColumn + static_cast<std::size_t>(column)], row == wanted ? '*' : ' ')
          << row << " " << column;
    }
  }
}

TEST(WatchChart, ASpeedThatSwingsFillsItsColumn) {
  WatchChart chart(1, 1000);
  chart.add(0.5, 50, 1, "run");
  chart.add(0.5, 950, 1, "run");
  const auto drawn = lines(chart);
  for (std::size_t row = 0; row < WatchChart::kSpeedRows; ++row) EXPECT_EQ(drawn[row][kFirstColumn + 32], '*') << row;
}

TEST(WatchChart, AReverseRunHasItsZeroAtTheTop) {
  WatchChart chart(1, -1000);
  chart.add(1, -1000, 1, "run");
  const auto drawn = lines(chart);
  EXPECT_THAT(drawn[WatchChart::kSpeedRows - 1], testing::StartsWith("       -1000 |"));
  EXPECT_EQ(drawn[WatchChart::kSpeedRows - 1].back(), '*') << "the run's end is in its last column";
  EXPECT_THAT(drawn[0], testing::Not(testing::HasSubstr("*")));
}

}  // namespace
}  // namespace steplock
