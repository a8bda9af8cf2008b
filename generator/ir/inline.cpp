#include "generator/ir/inline.hpp"

#include <llvm/Analysis/InlineCost.h>
#include <llvm/IR/Dominators.h>
#include <llvm/IR/InstIterator.h>
#include <llvm/IR/Instructions.h>
#include <llvm/IR/IntrinsicInst.h>
#include <llvm/Transforms/Utils/Cloning.h>
#include <llvm/Transforms/Utils/PromoteMemToReg.h>

#include "generator/refusal.hpp"

namespace hlsgen {
namespace {

using llvm::dyn_cast;
using llvm::isa;

bool stands(const llvm::Function* callee, const llvm::Function* own, const Blocks& blocks) {
  return callee == nullptr || callee->isDeclaration() || (callee != own && blocks.is_tick(callee));
}

void promote_pointers(llvm::Function& function) {
  std::vector<llvm::AllocaInst*> pointers;
  for (auto& instruction : llvm::instructions(function)) {
    auto* variable = dyn_cast<llvm::AllocaInst>(&instruction);
    if (variable != nullptr && variable->getAllocatedType()->isPointerTy() &&
        llvm::isAllocaPromotable(variable)) {
      pointers.push_back(variable);
    }
  }
  llvm::DominatorTree dominators(function);
  llvm::PromoteMemToReg(pointers, dominators);
}

// The copy that gives the variable its only value, null when there are other writes.
struct Uses {
  llvm::MemCpyInst* copy = nullptr;
  bool only_read = true;
};

void collect(llvm::Value* pointer, Uses& uses) {
  for (auto* user : pointer->users()) {
    if (isa<llvm::GetElementPtrInst>(user)) {
      collect(user, uses);
    } else if (auto* copy = dyn_cast<llvm::MemCpyInst>(user)) {
      if (copy->getRawDest() != pointer) continue;  // a source
      if (uses.copy != nullptr) uses.only_read = false;
      uses.copy = copy;
    } else if (auto* intrinsic = dyn_cast<llvm::IntrinsicInst>(user)) {
      if (!intrinsic->isLifetimeStartOrEnd()) uses.only_read = false;
    } else if (!isa<llvm::LoadInst>(user)) {
      uses.only_read = false;
    }
  }
}

void replace_constant_copies(llvm::Function& function) {
  const auto& data = function.getParent()->getDataLayout();
  std::vector<std::pair<llvm::AllocaInst*, llvm::MemCpyInst*>> copies;
  for (auto& instruction : llvm::instructions(function)) {
    auto* variable = dyn_cast<llvm::AllocaInst>(&instruction);
    if (variable == nullptr) continue;
    Uses uses;
    collect(variable, uses);
    if (uses.copy == nullptr || !uses.only_read || uses.copy->getRawDest() != variable) continue;
    const auto* source = dyn_cast<llvm::GlobalVariable>(uses.copy->getRawSource());
    const auto* length = dyn_cast<llvm::ConstantInt>(uses.copy->getLength());
    if (source != nullptr && source->isConstant() && length != nullptr &&
        length->equalsInt(data.getTypeAllocSize(variable->getAllocatedType()))) {
      copies.emplace_back(variable, uses.copy);
    }
  }
  for (const auto& [variable, copy] : copies) {
    llvm::Value* source = copy->getRawSource();
    copy->eraseFromParent();
    const std::vector<llvm::User*> users(variable->user_begin(), variable->user_end());
    for (auto* user : users) {
      auto* marker = dyn_cast<llvm::IntrinsicInst>(user);
      if (marker != nullptr && marker->isLifetimeStartOrEnd()) marker->eraseFromParent();
    }
    variable->replaceAllUsesWith(source);
    variable->eraseFromParent();
  }
}

}  // namespace

void inline_calls(llvm::Function& function, const llvm::Function* own, const Blocks& blocks) {
  std::vector<llvm::CallBase*> calls;  // the first in the function is the last here
  for (auto& instruction : llvm::instructions(function)) {
    if (auto* call = dyn_cast<llvm::CallBase>(&instruction)) calls.insert(calls.begin(), call);
  }
  while (!calls.empty()) {
    auto* call = calls.back();
    calls.pop_back();
    if (stands(call->getCalledFunction(), own, blocks)) continue;
    const auto where = source_of(*call);
    llvm::InlineFunctionInfo info;
    const auto result = llvm::InlineFunction(*call, info);
    if (!result.isSuccess()) {
      throw Refusal(where, std::string("the call cannot be taken in: ") + result.getFailureReason(),
                    "write it more simply");
    }
    calls.insert(calls.end(), info.InlinedCallSites.rbegin(), info.InlinedCallSites.rend());
  }
  promote_pointers(function);
  replace_constant_copies(function);
}

}  // namespace hlsgen
