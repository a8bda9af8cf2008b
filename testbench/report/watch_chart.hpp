// Speed and phase current of a run while it is simulated, as a chart of characters.
//
//     steplock run FILE --watch
//
// Doc: docs/report.md   Test: tests/testbench/watch_chart_test.cpp
#pragma once

#include <array>
#include <limits>
#include <string>

namespace steplock {

class WatchChart {
 public:
  WatchChart(double duration_s, double set_speed_rpm) : duration_s_(duration_s), set_speed_rpm_(set_speed_rpm) {}

  // Speed in r/min, the greatest of the three phase currents in A.  Instants out of the run count as its ends.
  void add(double time_s, double speed_rpm, double current_a, const std::string& state);

  // Always as many lines, each with its end, so that one can be drawn over the last.
  static constexpr int kSpeedRows = 10, kCurrentRows = 5, kLines = kSpeedRows + kCurrentRows + 4;
  std::string text() const;

 private:
  static constexpr int kColumns = 64;
  // What was seen in a column's share of the time.
  struct Seen {
    double least = std::numeric_limits<double>::infinity(), greatest = -std::numeric_limits<double>::infinity();
    void see(double x);
  };
  using Curve = std::array<Seen, kColumns>;
  static std::string panel(const Curve&, int rows, double low, double high, const char* unit);

  double duration_s_, set_speed_rpm_;
  double time_s_ = 0, speed_rpm_ = 0, current_a_ = 0;
  std::string state_;
  Curve speed_ = {}, current_ = {};
  Seen all_speed_, all_current_;
};

}  // namespace steplock
