// The values that a number can take where it is used.
//
//     if (i < 6) use(table[i]);              at the use, i is in [0, 6)
//     s == 5 ? 0 : s + 1, s in [0, 6)        is in [0, 6) again
//
// LLVM's own analysis asks what holds on entry to a block; this one also follows what a condition
// says about the operands of a value, into both arms of a select.  That takes a walk for each
// question; beyond its budget, values count with what holds of them everywhere, found once.
//
// Doc: docs/generator.md   Test: tests/generator/frontend/design_test.cpp

#pragma once

#include <llvm/IR/ConstantRange.h>
#include <llvm/IR/Dominators.h>
#include <llvm/IR/Instructions.h>
#include <llvm/IR/Module.h>

#include <map>
#include <vector>

namespace hlsgen {

class Ranges {
 public:
  explicit Ranges(llvm::Function& function)
      : data_(function.getParent()->getDataLayout()), dominators_(function) {}

  // Never too small; the whole range when nothing is known.
  llvm::ConstantRange of(const llvm::Value* value, const llvm::Instruction& at);

 private:
  struct Fact {
    const llvm::Value* value;
    llvm::ConstantRange range;  // narrower than the value: of its lower bits
  };

  void learn_block(const llvm::BasicBlock* block);
  void learn_edge(const llvm::BasicBlock* from, const llvm::BasicBlock* to);
  void learn(const llvm::Value* condition, bool holds);
  void learn(const llvm::Value* value, const llvm::ConstantRange& range);
  void learn_masked(const llvm::ICmpInst& compare, bool equal);

  llvm::ConstantRange range(const llvm::Value* value);
  llvm::ConstantRange everywhere(const llvm::Value* value);
  llvm::ConstantRange by_bits(const llvm::Value* value);
  llvm::ConstantRange by_operands(const llvm::Value* value);
  llvm::ConstantRange select(const llvm::SelectInst& choice);
  llvm::ConstantRange phi(const llvm::PHINode& phi);

  const llvm::DataLayout& data_;
  llvm::DominatorTree dominators_;
  std::vector<Fact> facts_;
  unsigned budget_ = 0;
  bool is_everywhere_ = false;  // the walk asks for what holds without any fact
  std::map<const llvm::Value*, llvm::ConstantRange> everywhere_;
};

}  // namespace hlsgen
