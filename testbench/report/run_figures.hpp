// The figures of a run: the whole run, the lock, the steady state and the load step.
//
// Doc: docs/report.md   Test: tests/testbench/report_test.cpp
#pragma once

#include <vector>

#include "model/design/settings.hpp"
#include "testbench/report/figure.hpp"
#include "testbench/run/summary.hpp"

namespace steplock {

// What the host and the load do in the scenario, of either drive, from the second event on: the first is that gates are off.
std::vector<Mark> events_of(const design::Settings&);

// Those for which the record holds samples.
std::vector<Figure> run_figures(const design::Settings&, const Summary&, const Record&);

}  // namespace steplock
