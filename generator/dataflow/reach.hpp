// Whether a value that nobody has written can reach what a module gives or keeps.
//
//     int v; if (a) v = 1; ... if (a) use(v);      it cannot: both conditions are the same
//     int v; if (a) v = 1; use(v);                 it can
//
// Follows choices from outputs and next values backwards, with what the conditions passed on the way
// say about the conditions to come.
//
// Doc: docs/generator.md   Test: tests/generator/frontend/refusal_test.cpp, design_test.cpp

#pragma once

#include "generator/netlist.hpp"

#include <map>
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
  std::optional<bool> known(NodeId condition) const;
  void assume(NodeId condition, bool holds);

  const Module& module_;
  std::vector<bool> carries_;  // a mark is among the node's operands, or theirs
  std::map<NodeId, bool> conditions_;
  std::map<NodeId, llvm::APInt> values_;  // from equalities that hold
  unsigned budget_;
};

}  // namespace hlsgen
