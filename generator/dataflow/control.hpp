// Control flow -> choices.
//
//     if (a) x = 1; else if (b) x = 2; else x = 3;     ->     x = mux(a, 1, mux(b, 2, 3))
//     switch (s) { case 0: case 2: x = 1; ... }        ->     x = mux(s == 0 | s == 2, 1, ...)
//
// A phi is decided by the branches between its block's immediate dominator and its block, and by
// nothing above.  Each block on the way is looked at once, so the result is as large as the source.
//
// Doc: docs/generator.md   Test: tests/generator/frontend/design_test.cpp

#pragma once

#include <llvm/IR/Dominators.h>
#include <llvm/IR/Instructions.h>

#include <functional>

#include "generator/dataflow/nodes.hpp"

namespace hlsgen {

class Control {
 public:
  // `convert` gives the node of a value, kNone for a value that does not matter.
  using Convert = std::function<NodeId(const llvm::Value*)>;

  Control(llvm::Function& function, NodeBuilder& nodes, Convert convert)
      : dominators_(function), nodes_(nodes), convert_(std::move(convert)) {}

  NodeId phi(const llvm::PHINode& phi);

 private:
  using Memory = std::map<const llvm::BasicBlock*, NodeId>;

  NodeId along(const llvm::BasicBlock* from, const llvm::BasicBlock* to, const llvm::PHINode& phi,
               Memory& memory);
  NodeId within(const llvm::BasicBlock* block, const llvm::PHINode& phi, Memory& memory);
  NodeId at_branch(const llvm::BranchInst& branch, const llvm::PHINode& phi, Memory& memory);
  NodeId at_switch(const llvm::SwitchInst& choice, const llvm::PHINode& phi, Memory& memory);

  llvm::DominatorTree dominators_;
  NodeBuilder& nodes_;
  Convert convert_;
};

}  // namespace hlsgen
