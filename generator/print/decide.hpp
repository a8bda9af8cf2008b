// What the registers do at a clock edge, as nested decisions.
//
//     a <= c ? x : a;  b <= c && y;     ->   if (c) begin a <= x; b <= y; end else b <= 0;
//     chains over s in several registers ->   case (s), each arm with what it changes
//
// Every decision takes the registers that get simpler by it, and then holds for all of its branches
// (restrict.hpp).  The one that leaves least to compute comes first: what an idle clock does not need
// then stands in a branch that is not entered, in the text as in a simulation.
//
// Test: tests/generator/clocked_print_test.cpp

#pragma once

#include "generator/netlist.hpp"

#include <vector>

namespace hlsgen {

struct Decision;

struct Branch {
  std::vector<Decision> steps;
  std::vector<NodeId> wires;  // computed in here, as nothing outside reads them (place.hpp)
};

struct Decision {
  struct Arm {
    std::vector<llvm::APInt> labels;  // of a case; none: default
    Branch block;
    std::vector<llvm::APInt> rest;    // what the default stands for, if that is worth saying
  };
  unsigned reg = 0;            // reg <= value, if there are no arms
  NodeId value = kNone;
  NodeId selector = kNone;     // one bit: if, with two arms; else a case
  std::vector<Arm> arms;
};

// Appends restricted values to the module.
Branch decide(Module& module);

// Calls visit(node, block) for every selector and value, `block` being the one they stand in.
template <class Branch, class Visit>
void for_each_read(Branch& block, const Visit& visit) {
  for (auto& step : block.steps) {
    visit(step.arms.empty() ? step.value : step.selector, block);
    for (auto& arm : step.arms) for_each_read(arm.block, visit);
  }
}

}  // namespace hlsgen
