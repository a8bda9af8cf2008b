// The figures of a run: the whole run, the lock, the steady state and the load step.
//
// Doc: docs/report.md   Test: tests/testbench/report_test.cpp
#pragma once

#include <vector>

#include "model/design/settings.hpp"
#include "testbench/report/figure.hpp"
#include "testbench/drive/six_step/summary.hpp"

namespace steplock {

// Those for which the record holds samples.
std::vector<Figure> run_figures(const design::Settings&, const Summary&, const Record&);

}  // namespace steplock
