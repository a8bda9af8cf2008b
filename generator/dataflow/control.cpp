#include "generator/dataflow/control.hpp"

#include <llvm/IR/Constants.h>

#include <algorithm>

namespace hlsgen {

NodeId Control::phi(const llvm::PHINode& phi) {
  Memory memory;
  const auto* above = dominators_.getNode(phi.getParent())->getIDom()->getBlock();
  return within(above, phi, memory);
}

// The value that the phi takes when control passes along an edge.
NodeId Control::along(const llvm::BasicBlock* from, const llvm::BasicBlock* to,
                      const llvm::PHINode& phi, Memory& memory) {
  if (to == phi.getParent()) return convert_(phi.getIncomingValueForBlock(from));
  return within(to, phi, memory);
}

// The value that the phi takes when control has come to a block; kNone if it never gets there.
NodeId Control::within(const llvm::BasicBlock* block, const llvm::PHINode& phi, Memory& memory) {
  const auto known = memory.find(block);
  if (known != memory.end()) return known->second;
  NodeId result = kNone;
  if (const auto* branch = llvm::dyn_cast<llvm::BranchInst>(block->getTerminator())) {
    result = at_branch(*branch, phi, memory);
  } else if (const auto* choice = llvm::dyn_cast<llvm::SwitchInst>(block->getTerminator())) {
    result = at_switch(*choice, phi, memory);
  }
  return memory[block] = result;
}

NodeId Control::at_branch(const llvm::BranchInst& branch, const llvm::PHINode& phi,
                          Memory& memory) {
  const auto* block = branch.getParent();
  const NodeId yes = along(block, branch.getSuccessor(0), phi, memory);
  if (branch.isUnconditional()) return yes;
  const NodeId no = along(block, branch.getSuccessor(1), phi, memory);
  if (yes == kNone || no == kNone || yes == no) return yes == kNone ? no : yes;
  const NodeId condition = convert_(branch.getCondition());
  return condition == kNone ? yes : nodes_.mux(condition, yes, no);
}

NodeId Control::at_switch(const llvm::SwitchInst& choice, const llvm::PHINode& phi,
                          Memory& memory) {
  struct Group {
    NodeId value;
    std::vector<llvm::APInt> cases;
  };
  std::vector<Group> groups;
  for (const auto& entry : choice.cases()) {
    const NodeId value = along(choice.getParent(), entry.getCaseSuccessor(), phi, memory);
    if (value == kNone) continue;
    auto group = std::find_if(groups.begin(), groups.end(),
                              [&](const Group& g) { return g.value == value; });
    if (group == groups.end()) group = groups.insert(group, {value, {}});
    group->cases.push_back(entry.getCaseValue()->getValue());
  }
  NodeId otherwise = along(choice.getParent(), choice.getDefaultDest(), phi, memory);
  if (otherwise == kNone && !groups.empty()) {
    // Every value of interest has its case: the most frequent result needs no comparison.
    otherwise = std::max_element(groups.begin(), groups.end(), [](const auto& a, const auto& b) {
                  return a.cases.size() < b.cases.size();
                })->value;
  }
  // Nothing to choose: control never gets there, or it does not matter how.  The selector may stand
  // behind the phi then, and even depend on it.
  const bool is_same = std::all_of(groups.begin(), groups.end(),
                                   [&](const Group& group) { return group.value == otherwise; });
  if (is_same) return otherwise;
  const NodeId selector = convert_(choice.getCondition());
  if (selector == kNone) return otherwise;
  NodeId result = otherwise;
  for (auto group = groups.rbegin(); group != groups.rend(); ++group) {
    if (group->value == otherwise) continue;
    NodeId condition = kNone;
    for (const auto& value : group->cases) {
      const NodeId here = nodes_.compare(Op::kEq, selector, nodes_.constant(value));
      condition = condition == kNone ? here : nodes_.binary(Op::kOr, condition, here);
    }
    result = nodes_.mux(condition, group->value, result);
  }
  return result;
}

}  // namespace hlsgen
