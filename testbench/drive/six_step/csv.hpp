// Samples as comma-separated text, one header line; the columns are named with their units.
//
// Doc: docs/report.md   Test: tests/testbench/report_test.cpp
#pragma once

#include <string>
#include <vector>

#include "testbench/drive/six_step/record.hpp"

namespace steplock {

std::string samples_csv(const std::vector<Sample>&, int pole_pairs);

}  // namespace steplock
