// Conditions on the step, and what they choose among.
//
//     chosen({2: a, 5: b}, present)  ->  step == 2 ? a : step == 5 ? b : present
//
// Test: tests/generator/schedule_test.cpp

#pragma once

#include "generator/dataflow/nodes.hpp"

#include <vector>

namespace hlsgen::scheduling {

struct Load {
  unsigned step = 0;
  NodeId value = kNone;
};

class Steps {
 public:
  Steps(NodeBuilder& nodes, unsigned last);

  unsigned width() const { return width_; }
  void count_in(NodeId counter) { counter_ = counter; }

  NodeId at(unsigned step);
  NodeId any_of(const std::vector<Load>& loads);
  // Without `otherwise`, in steps without a load, it does not matter which.
  NodeId chosen(std::vector<Load> loads, NodeId otherwise = kNone);

 private:
  NodeBuilder& nodes_;
  unsigned width_ = 1;
  NodeId counter_ = kNone;
};

}  // namespace hlsgen::scheduling
