#include "testbench/report/watch_chart.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace steplock {

void WatchChart::Seen::see(double x) {
  least = std::min(least, x);
  greatest = std::max(greatest, x);
}

void WatchChart::add(double time_s, double speed_rpm, double current_a, const std::string& state) {
  const double part = duration_s_ > 0 ? std::clamp(time_s / duration_s_, 0.0, 1.0) : 0;
  const auto column = static_cast<std::size_t>(std::min(kColumns - 1, static_cast<int>(part * kColumns)));
  speed_[column].see(speed_rpm);
  current_[column].see(current_a);
  all_speed_.see(speed_rpm);
  all_current_.see(current_a);
  time_s_ = time_s, speed_rpm_ = speed_rpm, current_a_ = current_a, state_ = state;
}

// A column is filled from its least to its greatest value.
std::string WatchChart::panel(const Curve& curve, int rows, double low, double high, const char* unit) {
  const double row_height = (high - low) / rows;
  std::string text;
  for (int row = 0; row < rows; ++row) {
    const double top = high - row * row_height, bottom = row == rows - 1 ? low : top - row_height;
    const std::string label = row == 0 ? fmt::format("{:.4g} {}", high, unit) : row == rows - 1 ? fmt::format("{:.4g}", low) : "";
    text += fmt::format("{:>12} |", label);
    for (const Seen& seen : curve) {
      const bool above = row == 0 ? seen.least <= top : seen.least < top;  // each value in one row
      text += above && seen.greatest >= bottom ? '*' : ' ';
    }
    text += '\n';
  }
  return text;
}

std::string WatchChart::text() const {
  const double low = std::min({0.0, set_speed_rpm_, all_speed_.least});
  const double high = std::max({1.0, set_speed_rpm_, all_speed_.greatest});
  std::string text = panel(speed_, kSpeedRows, low, high, "r/min");
  text += fmt::format("{:>12} |{:-<{}}\n", "", "", kColumns);
  text += panel(current_, kCurrentRows, 0, std::max(0.1, all_current_.greatest), "A");
  text += fmt::format("{:>12} +{:-<{}}\n", "", "", kColumns);
  text += fmt::format("{:>12}  0{:>{}}\n", "", fmt::format("{:g} s", duration_s_), kColumns - 1);
  text += fmt::format("{:>12}  {:.3f} s: {}, {:.1f} r/min, {:.2f} A\n", "", time_s_, state_, speed_rpm_, current_a_);
  return text;
}

}  // namespace steplock
