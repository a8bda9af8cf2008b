#include "generator/ir/split.hpp"

#include <llvm/IR/DIBuilder.h>
#include <llvm/IR/DebugInfo.h>
#include <llvm/IR/Dominators.h>
#include <llvm/IR/IRBuilder.h>
#include <llvm/IR/InstIterator.h>
#include <llvm/IR/IntrinsicInst.h>
#include <llvm/Transforms/Utils/PromoteMemToReg.h>

#include <map>

#include "generator/ir/numbers.hpp"

namespace hlsgen {
namespace {

using llvm::dyn_cast;

struct Access {
  llvm::Instruction* at = nullptr;  // a load or a store
  std::uint64_t offset = 0;
};

struct Uses {
  std::vector<Access> accesses;
  std::vector<llvm::GetElementPtrInst*> addresses;
};

llvm::Type* type_of_access(llvm::Instruction* at) { return llvm::getLoadStoreType(at); }

// False when some use is not a load or store of a known place.
bool collect(llvm::Value* pointer, std::uint64_t offset, const llvm::DataLayout& data, Uses& uses) {
  for (auto* user : pointer->users()) {
    if (auto* load = dyn_cast<llvm::LoadInst>(user)) {
      uses.accesses.push_back({load, offset});
    } else if (auto* store = dyn_cast<llvm::StoreInst>(user)) {
      if (store->getValueOperand() == pointer) return false;
      uses.accesses.push_back({store, offset});
    } else if (auto* address = dyn_cast<llvm::GetElementPtrInst>(user)) {
      llvm::APInt more(64, 0);
      if (!address->accumulateConstantOffset(data, more)) return false;
      uses.addresses.push_back(address);
      if (!collect(address, offset + more.getZExtValue(), data, uses)) return false;
    } else {
      return false;
    }
  }
  return true;
}

void describe(llvm::AllocaInst& whole, llvm::AllocaInst& part, std::uint64_t offset) {
  const auto& data = whole.getModule()->getDataLayout();
  const auto width = data.getTypeSizeInBits(part.getAllocatedType()).getFixedValue();
  llvm::DIBuilder builder(*whole.getModule(), /*AllowUnresolved=*/false);
  for (auto* declaration : llvm::FindDbgDeclareUses(&whole)) {
    auto* variable = declaration->getVariable();
    llvm::DIExpression* expression = declaration->getExpression();
    if (variable->getSizeInBits().value_or(0) != width) {
      const auto fragment =
          llvm::DIExpression::createFragmentExpression(expression, offset * 8, width);
      if (!fragment) continue;
      expression = *fragment;
    }
    builder.insertDeclare(&part, variable, expression, declaration->getDebugLoc(), declaration);
  }
}

// Out of the object, or across its numbers: nothing to split by.
bool fits(const Uses& uses, const std::map<std::uint64_t, llvm::Type*>& numbers) {
  for (const auto& access : uses.accesses) {
    const auto number = numbers.find(access.offset);
    if (number == numbers.end() || number->second != type_of_access(access.at)) return false;
  }
  return true;
}

bool split(llvm::AllocaInst& variable, std::vector<llvm::AllocaInst*>& parts) {
  const auto& data = variable.getModule()->getDataLayout();
  Uses uses;
  if (!collect(&variable, 0, data, uses)) return false;
  std::map<std::uint64_t, llvm::Type*> numbers;
  for (const auto& number : numbers_in(variable.getAllocatedType(), data)) {
    numbers[number.offset] = number.type;
  }
  if (!fits(uses, numbers)) return false;

  std::map<std::uint64_t, llvm::AllocaInst*> part_at;
  llvm::IRBuilder<> builder(&variable);
  for (const auto& access : uses.accesses) {
    auto& part = part_at[access.offset];
    if (part == nullptr) {
      part = builder.CreateAlloca(numbers[access.offset], nullptr, variable.getName());
      describe(variable, *part, access.offset);
      parts.push_back(part);
    }
    const unsigned operand = llvm::isa<llvm::LoadInst>(access.at) ? 0 : 1;
    access.at->setOperand(operand, part);
  }
  for (auto address = uses.addresses.rbegin(); address != uses.addresses.rend(); ++address) {
    (*address)->replaceAllUsesWith(llvm::PoisonValue::get((*address)->getType()));  // debug info
    (*address)->eraseFromParent();
  }
  for (auto* declaration : llvm::FindDbgDeclareUses(&variable)) declaration->eraseFromParent();
  variable.replaceAllUsesWith(llvm::PoisonValue::get(variable.getType()));
  variable.eraseFromParent();
  return true;
}

}  // namespace

bool split_variables(llvm::Function& function) {
  std::vector<llvm::AllocaInst*> variables;
  std::vector<llvm::AllocaInst*> parts;
  for (auto& instruction : llvm::instructions(function)) {
    auto* variable = dyn_cast<llvm::AllocaInst>(&instruction);
    if (variable == nullptr) continue;
    // Pointers held in memory: what they point to is split in a later round.
    if (variable->getAllocatedType()->isPointerTy()) {
      if (llvm::isAllocaPromotable(variable)) parts.push_back(variable);
    } else {
      variables.push_back(variable);
    }
  }
  for (auto* variable : variables) split(*variable, parts);
  llvm::DominatorTree dominators(function);
  llvm::PromoteMemToReg(parts, dominators);
  return !parts.empty();
}

}  // namespace hlsgen
