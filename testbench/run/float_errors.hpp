// How far the fixed-point drive is from the reference in doubles on the same pins, signal by signal,
// beside what the error budget allows (model/design/budget.hpp).
//
// Doc: docs/report.md   Test: tests/testbench/compare_test.cpp
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "model/design/budget.hpp"

namespace steplock {

struct SignalError {
  design::BudgetRow budget;                 // with name and unit
  double mean = 0, rms = 0, greatest = 0;   // measured; greatest of either sign
  // Scatter is the budget's to foresee, worst case as well as on the whole.
  bool within() const { return greatest <= budget.bound && rms <= budget.rms_allowed(); }
};

struct FloatErrors {
  std::string compared = "commutations";  // what
  std::size_t count = 0;             // of them
  double from_s = 0, to_s = 0;       // the span
  std::vector<SignalError> signals;  // none if the two never ran in step
  bool within() const;
};

nlohmann::ordered_json to_json(const FloatErrors&);
std::string to_text(const FloatErrors&);  // a table, indented like a summary

}  // namespace steplock
