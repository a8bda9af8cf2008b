#include "generator/ir/choices.hpp"

#include <llvm/IR/IRBuilder.h>
#include <llvm/IR/InstIterator.h>
#include <llvm/IR/Instructions.h>

namespace hlsgen {
namespace {

using llvm::dyn_cast;
using llvm::isa;

// (c ? &a : &b) + offset  ->  c ? &a + offset : &b + offset
void move_into(llvm::GetElementPtrInst& address, llvm::SelectInst& choice) {
  auto* yes = address.clone();
  auto* no = address.clone();
  yes->setOperand(0, choice.getTrueValue());
  no->setOperand(0, choice.getFalseValue());
  yes->insertBefore(&address);
  no->insertBefore(&address);
  llvm::IRBuilder<> builder(&address);
  address.replaceAllUsesWith(builder.CreateSelect(choice.getCondition(), yes, no));
  address.eraseFromParent();
}

void load(llvm::LoadInst& at, llvm::SelectInst& choice) {
  llvm::IRBuilder<> builder(&at);
  auto* yes = builder.CreateLoad(at.getType(), choice.getTrueValue());
  auto* no = builder.CreateLoad(at.getType(), choice.getFalseValue());
  at.replaceAllUsesWith(builder.CreateSelect(choice.getCondition(), yes, no));
  at.eraseFromParent();
}

void store(llvm::StoreInst& at, llvm::SelectInst& choice) {
  llvm::IRBuilder<> builder(&at);
  auto* value = at.getValueOperand();
  for (const bool is_true : {true, false}) {
    auto* place = is_true ? choice.getTrueValue() : choice.getFalseValue();
    auto* old = builder.CreateLoad(value->getType(), place);
    auto* next =
        builder.CreateSelect(choice.getCondition(), is_true ? value : old, is_true ? old : value);
    builder.CreateStore(next, place);
  }
  at.eraseFromParent();
}

}  // namespace

bool choose_values(llvm::Function& function) {
  std::vector<llvm::SelectInst*> choices;
  for (auto& instruction : llvm::instructions(function)) {
    auto* choice = dyn_cast<llvm::SelectInst>(&instruction);
    if (choice != nullptr && choice->getType()->isPointerTy()) choices.push_back(choice);
  }
  bool changed = false;
  for (auto* choice : choices) {
    const std::vector<llvm::User*> users(choice->user_begin(), choice->user_end());
    for (auto* user : users) {
      if (auto* address = dyn_cast<llvm::GetElementPtrInst>(user)) {
        move_into(*address, *choice);
      } else if (auto* read = dyn_cast<llvm::LoadInst>(user)) {
        load(*read, *choice);
      } else if (auto* write = dyn_cast<llvm::StoreInst>(user);
                 write != nullptr && write->getPointerOperand() == choice &&
                 write->getValueOperand() != choice) {
        store(*write, *choice);
      } else {
        continue;
      }
      changed = true;
    }
    if (choice->use_empty()) choice->eraseFromParent();
  }
  return changed;
}

}  // namespace hlsgen
