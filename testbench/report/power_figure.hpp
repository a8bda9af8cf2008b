// Where the power goes while a scenario runs, as a figure of either drive's report: from the source to the load, into what is stored,
// and into heat on the way.  Each point is the mean of a three-hundredth of the run, from the plant's running energies
// (testbench/run/power.hpp), so that no pulse of the PWM is missed between two samples.
//
// Doc: docs/report.md   Test: tests/testbench/power_figure_test.cpp
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "testbench/report/figure.hpp"
#include "testbench/run/power.hpp"

namespace steplock {

Figure power_figure(const std::vector<Power>& spans, std::vector<Mark> marks);

template <class Sample>
Figure power_figure(const std::vector<Sample>& samples, std::vector<Mark> marks) {
  constexpr std::size_t kSpans = 300;
  const std::size_t stride = std::max<std::size_t>(1, samples.size() / kSpans);
  std::vector<Power> spans;
  for (std::size_t k = stride; k < samples.size(); k += stride) {
    const Sample &a = samples[k - stride], &b = samples[k];
    spans.push_back(power_between(a.time, a.plant.energy, b.time, b.plant.energy));
  }
  return power_figure(spans, std::move(marks));
}

}  // namespace steplock
