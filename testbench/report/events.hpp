// What the host and the load do in a scenario, as marks in a figure of it.
//
// Doc: docs/report.md   Test: tests/testbench/report_test.cpp
#pragma once

#include <vector>

#include "model/design/settings.hpp"
#include "testbench/report/figure.hpp"

namespace steplock {

// Of either drive, from the second event on: the first is that gates are off.
std::vector<Mark> events_of(const design::Settings&);

}  // namespace steplock
