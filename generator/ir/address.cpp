#include "generator/ir/address.hpp"

#include <llvm/ADT/MapVector.h>
#include <llvm/Analysis/ValueTracking.h>
#include <llvm/IR/GlobalVariable.h>
#include <llvm/IR/Operator.h>

#include "generator/ir/opaque.hpp"
#include "generator/refusal.hpp"

namespace hlsgen {

std::uint64_t Address::combinations() const {
  std::uint64_t product = 1;
  for (const auto& part : parts) product *= part.count;
  return product;
}

std::uint64_t Address::offset_of(std::uint64_t combination) const {
  std::uint64_t place = offset;
  for (const auto& part : parts) {
    place += combination % part.count * part.stride;
    combination /= part.count;
  }
  return place;
}

namespace {

// Of a line of a constant table, `kGrid[1]`, there is no instruction: it stands where the table does.
const llvm::Module* module_of(const llvm::GEPOperator& step) {
  if (const auto* instruction = llvm::dyn_cast<llvm::Instruction>(&step)) {
    return instruction->getModule();
  }
  const auto* table = llvm::dyn_cast<llvm::GlobalVariable>(llvm::getUnderlyingObject(&step));
  return table == nullptr ? nullptr : table->getParent();
}

}  // namespace

Address address_of(llvm::Value* pointer) {
  Address address;
  llvm::APInt offset(64, 0);
  while (auto* step = llvm::dyn_cast<llvm::GEPOperator>(pointer)) {
    llvm::MapVector<llvm::Value*, llvm::APInt> variables;
    const auto* module = module_of(*step);
    if (module == nullptr || !step->collectOffset(module->getDataLayout(), 64, variables, offset)) {
      break;
    }
    for (const auto& [index, stride] : variables) {
      const auto* guard = llvm::dyn_cast<llvm::CallInst>(index);
      if (guard == nullptr || opaque_kind(guard) != OpaqueKind::kIndex || stride.isNegative() ||
          count_of(guard) == 0) {
        address.by_unknown = index;
      } else {
        address.parts.push_back({index, stride.getZExtValue(), count_of(guard)});
      }
    }
    pointer = step->getPointerOperand();
  }
  address.object = pointer;
  address.offset = offset.getZExtValue();
  return address;
}

void refuse_address(const Address& address, const llvm::Instruction& user) {
  const auto* guard = llvm::dyn_cast<llvm::CallInst>(address.by_unknown);
  const bool leaves = guard != nullptr && opaque_kind(guard) == OpaqueKind::kIndex &&
                      llvm::isa<llvm::ConstantInt>(guard->getArgOperand(0));
  throw Refusal(source_of(user),
                leaves ? "a pointer leaves its array"
                       : "a pointer is moved by what is only known at run time",
                "index the array itself");
}

}  // namespace hlsgen
