// What `steplock design` shows of a sinusoidal drive: estimator gains, regulators, start, limits.
//
// Doc: docs/sinusoidal.md   Test: tests/testbench/sinusoidal_run_test.cpp
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "model/design/settings.hpp"

namespace steplock::sinusoidal {

struct DesignRow {
  std::string name, unit;
  double value;
};
std::vector<DesignRow> design_rows(const design::Settings&);

std::string design_text(const design::Settings&);
nlohmann::ordered_json design_json(const design::Settings&);

}  // namespace steplock::sinusoidal
