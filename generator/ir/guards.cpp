#include "generator/ir/guards.hpp"

#include <llvm/Analysis/AssumptionCache.h>
#include <llvm/Analysis/ValueTracking.h>
#include <llvm/IR/Constants.h>
#include <llvm/IR/Dominators.h>
#include <llvm/IR/InstIterator.h>
#include <llvm/IR/Instructions.h>
#include <llvm/Support/KnownBits.h>

#include "generator/ir/ranges.hpp"
#include "generator/refusal.hpp"

namespace hlsgen {
namespace {

using llvm::dyn_cast;

std::vector<llvm::CallInst*> guards_in(llvm::Function& function) {
  std::vector<llvm::CallInst*> guards;
  for (auto& instruction : llvm::instructions(function)) {
    if (opaque_kind(&instruction) == OpaqueKind::kIndex) {
      guards.push_back(llvm::cast<llvm::CallInst>(&instruction));
    }
  }
  return guards;
}

// `count` is the number of elements, 0 for a pointer whose array is not known.
void guard_index(llvm::GetElementPtrInst& address, unsigned operand, std::uint64_t count,
                 Opaque& opaque) {
  auto* index = address.getOperand(operand);
  const auto* constant = dyn_cast<llvm::ConstantInt>(index);
  if (constant != nullptr && (count == 0 || constant->getValue().ult(count))) return;
  Site site{source_of(address), "a pointer is moved by what is only known at run time",
            "index the array itself"};
  if (count != 0) {
    site.what = "the index may leave the array of " + std::to_string(count);
    site.mend = "limit it by its width or by an if around the access";
  }
  llvm::IRBuilder<> builder(&address);
  address.setOperand(operand, opaque.index(builder, index, count, site));
}

void guard_indices(llvm::GetElementPtrInst& address, Opaque& opaque) {
  guard_index(address, 1, 0, opaque);
  llvm::Type* type = address.getSourceElementType();
  for (unsigned i = 2; i < address.getNumOperands(); ++i) {
    if (auto* array = dyn_cast<llvm::ArrayType>(type)) {
      guard_index(address, i, array->getNumElements(), opaque);
      type = array->getElementType();
    } else {
      type = llvm::cast<llvm::StructType>(type)->getTypeAtIndex(address.getOperand(i));
    }
  }
}

// Whether a pointer moved by a constant still points into its object, or to its end.
bool stays_inside(const llvm::CallInst& guard, const llvm::ConstantInt& index) {
  const auto& data = guard.getModule()->getDataLayout();
  for (const auto* user : guard.users()) {
    const auto* address = dyn_cast<llvm::GetElementPtrInst>(user);
    if (address == nullptr || address->getNumIndices() != 1) return false;
    llvm::APInt offset(64, 0);
    const auto* base = address->getPointerOperand()->stripAndAccumulateConstantOffsets(
        data, offset, /*AllowNonInbounds=*/true);
    offset += index.getValue().sextOrTrunc(64) *
              data.getTypeAllocSize(address->getSourceElementType()).getFixedValue();
    std::uint64_t size = 0;
    if (const auto* variable = dyn_cast<llvm::AllocaInst>(base)) {
      size = data.getTypeAllocSize(variable->getAllocatedType());
    } else if (const auto* global = dyn_cast<llvm::GlobalVariable>(base)) {
      size = data.getTypeAllocSize(global->getValueType());
    }
    if (offset.isNegative() || offset.ugt(size)) return false;
  }
  return true;
}

bool is_below(const llvm::APInt& largest, std::uint64_t count) {
  return largest.getActiveBits() <= 64 && largest.getZExtValue() < count;
}

}  // namespace

void insert_guards(llvm::Function& function, Opaque& opaque) {
  std::vector<llvm::GetElementPtrInst*> addresses;
  for (auto& instruction : llvm::instructions(function)) {
    auto* address = dyn_cast<llvm::GetElementPtrInst>(&instruction);
    if (address != nullptr) addresses.push_back(address);
  }
  for (auto* address : addresses) guard_indices(*address, opaque);
}

bool fold_guards(llvm::Function& function) {
  bool changed = false;
  for (auto* guard : guards_in(function)) {
    auto* index = dyn_cast<llvm::ConstantInt>(guard->getArgOperand(0));
    if (index == nullptr) continue;
    const auto count = count_of(guard);
    const bool valid = count == 0 ? stays_inside(*guard, *index) : index->getValue().ult(count);
    if (!valid) continue;
    guard->replaceAllUsesWith(index);
    guard->eraseFromParent();
    changed = true;
  }
  return changed;
}

std::vector<unsigned> prove_guards(llvm::Function& function) {
  llvm::DominatorTree dominators(function);
  llvm::AssumptionCache assumptions(function);
  const auto& data = function.getParent()->getDataLayout();
  Ranges ranges(function);

  // All questions first: answers may lean on conditions over other indices.
  std::vector<unsigned> failed;
  std::vector<llvm::CallInst*> proved;
  for (auto* guard : guards_in(function)) {
    auto* index = guard->getArgOperand(0);
    const auto count = count_of(guard);
    const auto bits = llvm::computeKnownBits(index, data, 0, &assumptions, guard, &dominators);
    const bool below = is_below(bits.getMaxValue(), count) ||
                       is_below(ranges.of(index, *guard).getUnsignedMax(), count);
    if (guard->use_empty() || below) {
      proved.push_back(guard);
    } else {
      failed.push_back(site_of(guard));
    }
  }
  for (auto* guard : proved) {
    guard->replaceAllUsesWith(guard->getArgOperand(0));
    guard->eraseFromParent();
  }
  return failed;
}

}  // namespace hlsgen
