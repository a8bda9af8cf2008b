#include "testbench/report/events.hpp"

#include "testbench/run/timeline.hpp"

namespace steplock {

std::vector<Mark> events_of(const design::Settings& s) {
  std::vector<Mark> marks;
  for (const Event& e : timeline(s).events) marks.push_back({static_cast<double>(e.clock) / s.control.clock_hz, e.what});
  marks.erase(marks.begin());
  return marks;
}

}  // namespace steplock
