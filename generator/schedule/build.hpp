// The scheduled block as an ordinary module: a counter of steps, shared units with choices in front
// of their registers, kept values, and the sample's own logic in between.
//
//     step         0: waiting; counts from the start to the last step
//     factor_a, factor_b -> product     per multiplier: chosen by the step, multiplied in the next
//     kept_0 ...                        values between steps
//     registers of the block, outputs   as Keeping says: in the last step, or early
//
// Test: tests/generator/schedule_test.cpp

#pragma once

#include "generator/schedule/bind.hpp"

namespace hlsgen::scheduling {

// What stands around the sample: ports that it does not have, and what its outputs show at first.
struct Frame {
  Leaf start, done, busy, missed;
  std::vector<llvm::APInt> output_resets;
  std::vector<bool> early = {};  // per output, of a program; none: none is
};

Module build(const Operations& operations, const Order& order, const Keeping& keeping,
             const Binding& binding, const Frame& frame);

}  // namespace hlsgen::scheduling
