// What words that are rounded put into a signal, for the sinusoidal drive's shadows.
//
// Test: tests/testbench/sinusoidal_compare_test.cpp
#pragma once

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "model/design/config.hpp"

namespace steplock {

inline constexpr double kUniform = 0.29;  // standard deviation, of its width

// What lasts, and the standard deviation of what scatters.
struct Rounding {
  double bias = 0, scatter = 0;
};

// Relative error of a word.
inline double rounded(const std::vector<design::WordRow>& rows, const std::string& name) {
  const auto row = std::ranges::find(rows, name, &design::WordRow::name);
  if (row == rows.end()) throw std::logic_error("no word " + name);
  return row->wanted == 0 ? 0 : std::abs(row->error() / row->wanted);
}

}  // namespace steplock
