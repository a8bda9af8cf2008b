// What follows from conditions that are taken to hold.
//
//     !(a || b)        ->  !a, !b                   a && b fails, a holds  ->  !b
//     s == 2           ->  s != 3                   a, b hold              ->  a && b holds
//
// Follows from, step by step: each step looks at one operator and what is known around it.  All that
// is said to follow does; not all that follows is found.
//
// Doc: docs/generator.md   Test: tests/generator/frontend/reach_test.cpp

#pragma once

#include "generator/netlist.hpp"

#include <vector>

namespace hlsgen {

class Conditions {
 public:
  explicit Conditions(const Module& module);

  // False when it contradicts what is known already; then only back_to makes sense.
  bool assume(NodeId condition, bool holds);

  // Before an assumption, and back to what was known there.
  std::size_t mark() const { return trail_.size(); }
  void back_to(std::size_t mark);

 private:
  enum class Known : std::uint8_t { kNo, kFalse, kTrue };
  struct Fact {
    NodeId id;
    bool holds;
  };

  bool knows(NodeId id, bool holds) const {
    return known_[id] == (holds ? Known::kTrue : Known::kFalse);
  }
  void infer(NodeId id);
  void infer_logic(NodeId id, bool absorbing);
  void infer_choice(NodeId id);
  void exclude_others(NodeId equality);

  const Module& module_;
  std::vector<std::vector<NodeId>> users_;  // where a step can be made: logic, choices, equalities
  std::vector<Known> known_;                // of nodes of one bit
  std::vector<NodeId> trail_;               // in the order in which they became known
  std::vector<Fact> found_;                 // not yet taken in
};

}  // namespace hlsgen
