// Whether a value that nobody has written can reach what a module gives or keeps.
//
//     int v; if (a) v = 1; ... if (a) use(v);      it cannot: both conditions are the same
//     int v; if (a) v = 1; use(v);                 it can
//
// Node by node from the sources on: does a mark reach it, under no condition but its own?  What is
// cleared so is not looked into again, which keeps the work small.  For one node, choices are
// followed backwards, with all that follows from the conditions passed on the way (Conditions); a
// contradiction means that nobody comes that way.
//
// Doc: docs/generator.md   Test: tests/generator/frontend/reach_test.cpp, design_test.cpp

#pragma once

#include "generator/dataflow/conditions.hpp"
#include "generator/netlist.hpp"

#include <optional>
#include <vector>

namespace hlsgen {

class Reach {
 public:
  // Marks are inputs beyond the module's own: index inputs.size() + i stands for mark i.
  explicit Reach(const Module& module);

  // A mark that is reached, if any is.
  std::optional<unsigned> find();

 private:
  std::optional<unsigned> from(NodeId node);
  std::optional<unsigned> under(NodeId condition, bool holds, NodeId node);
  unsigned mark_below(NodeId node) const;

  const Module& module_;
  Conditions conditions_;
  std::vector<bool> carries_;  // a mark may reach the node
  unsigned budget_ = 0;
};

}  // namespace hlsgen
