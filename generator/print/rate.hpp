// What a decision is worth: the operators that a clock saves, on the average over the branches,
// once the condition is known.
//
//     a <= c ? x * y : a   on c:   all that x * y takes, half of the clocks
//
// The decider asks for one selector after the other and takes the best (decide.hpp).
//
// Test: tests/generator/clocked_print_test.cpp

#pragma once

#include "generator/print/restrict.hpp"

#include <llvm/ADT/DenseMap.h>
#include <llvm/ADT/DenseSet.h>

namespace hlsgen {

struct Update {
  unsigned reg;
  NodeId value;
};
using Updates = std::vector<Update>;

struct Split {
  NodeId selector = kNone;
  std::vector<std::vector<llvm::APInt>> labels;  // per arm; none: default
  std::vector<Facts> facts;                      // per arm
  std::vector<llvm::APInt> rest;                 // what the default stands for
  std::vector<bool> joined;                      // per update
  double gain = 0;
};

class Rater {
 public:
  static constexpr double kLeastGain = 1;  // operators that a branch saves

  // The restrictor's module, which it may append to.
  Rater(const Module& module, Restrictor& restrictor);

  const Node& node(NodeId id) const { return m_.nodes[id]; }
  NodeId without_not(NodeId id) const { return node(id).op == Op::kNot ? node(id).in[0] : id; }
  bool is_choice(NodeId id) const { return node(id).op == Op::kMux; }
  bool is_free(NodeId id) const { return free_.count(id) != 0; }  // computed in any case
  bool holds(const Update& u) const {
    const auto found = present_.find(u.value);
    return found != present_.end() && found->second == u.reg;
  }

  // Who joins, and how many operators fewer a clock needs if all arms are as likely.  `own` is what
  // each update gains from its own condition.
  Split rate(Split s, const Updates& updates, const std::vector<double>& own);
  // What one update alone gains, the condition being there already as far as others made it.
  double gain(const Update& u, const Split& s);

 private:
  using Cone = llvm::DenseSet<NodeId>;

  using Ways = llvm::DenseMap<NodeId, unsigned>;

  void add_cone(NodeId id, Cone& cone) const;
  bool is_simple(NodeId id) const;
  std::vector<NodeId> restricted(const Update& u, const Split& s);
  static double cost(const std::vector<Cone>& cones, const Cone& condition);
  unsigned count_values(const Update& u) const;
  unsigned count_choices(NodeId id) const;
  template <class Count>
  unsigned count_ways(NodeId id, const Count& at_end, unsigned at_choice, Ways& known) const;
  bool joins(const Update& u, const std::vector<NodeId>& values, const Split& s, double own);

  const Module& m_;
  Restrictor& restrictor_;
  llvm::DenseMap<NodeId, unsigned> present_;  // a register's present value
  Cone free_;                           // what outputs and instances need
};

}  // namespace hlsgen
