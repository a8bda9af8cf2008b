// Differences of one signal, collected one by one.
//
// Test: tests/testbench/compare_test.cpp
#pragma once

#include <algorithm>
#include <cmath>

#include "testbench/run/float_errors.hpp"

namespace steplock {

class Differences {
 public:
  void add(double d) {
    ++count_;
    sum_ += d;
    squares_ += d * d;
    greatest_ = std::max(greatest_, std::abs(d));
  }
  SignalError beside(const design::BudgetRow& budget) const {
    // What was never compared is within no bound.
    if (count_ == 0) return {budget, std::nan(""), std::nan(""), std::nan("")};
    const auto n = static_cast<double>(count_);
    return {budget, sum_ / n, std::sqrt(squares_ / n), greatest_};
  }

 private:
  std::size_t count_ = 0;
  double sum_ = 0, squares_ = 0, greatest_ = 0;
};

}  // namespace steplock
