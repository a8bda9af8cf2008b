// When everything happens: list scheduling under a budget of multipliers, the most urgent first.
//
// Step 0 is the clock of the start, the last step ends with the results' registers.  Logic comes as
// early as its operands, several operators in one step as far as the delay allows; a unit takes new
// operands in every step.  Urgent is what has the longest way to go; ties and near-ties are tried
// in several orders, and the shortest schedule is kept.
//
// `bound` is a number of steps that no order can undercut: the longest path without any limit on
// units, or, for all products that come no earlier than a and have b steps to go behind them, a +
// (their number / multipliers - 1) + b.
//
// Test: tests/generator/schedule_test.cpp

#pragma once

#include "generator/schedule/operations.hpp"

namespace hlsgen::scheduling {

struct Order {
  std::vector<unsigned> step;   // per node: the first in which its value is there
  std::vector<unsigned> depth;  // delay within that step
  std::vector<unsigned> issue;  // of a unit's operands
  std::vector<unsigned> unit;   // within its pool
  unsigned last = 1;            // step
  unsigned bound = 1;           // for it
};

Order order(const Operations& operations);

}  // namespace hlsgen::scheduling
