#include "generator/ir/expand.hpp"

#include <llvm/Analysis/ConstantFolding.h>
#include <llvm/IR/DebugInfoMetadata.h>
#include <llvm/IR/InstIterator.h>
#include <llvm/IR/Instructions.h>
#include <llvm/Support/MathExtras.h>

#include "generator/ir/address.hpp"
#include "generator/refusal.hpp"

namespace hlsgen {
namespace {

using llvm::dyn_cast;

bool varies(llvm::Value* pointer, const llvm::Instruction& user) {
  const auto address = address_of(pointer);
  if (address.by_unknown != nullptr) refuse_address(address, user);
  return !address.parts.empty();
}

llvm::Value* element(llvm::IRBuilder<>& builder, const Address& address,
                     std::uint64_t combination) {
  return builder.CreateConstInBoundsGEP1_64(builder.getInt8Ty(), address.object,
                                            address.offset_of(combination));
}

class Expander {
 public:
  Expander(llvm::Instruction& at, llvm::Value* pointer)
      : at_(at), builder_(&at), address_(address_of(pointer)) {
    if (address_.combinations() > kMaxElements) {
      throw Refusal(
          source_of(at),
          "an array of " + std::to_string(address_.combinations()) + " elements as registers",
          "keep it below " + std::to_string(kMaxElements));
    }
  }

  llvm::Value* load(llvm::Type* type) {
    std::vector<llvm::Value*> values;
    for (std::uint64_t i = 0; i < address_.combinations(); ++i) {
      values.push_back(builder_.CreateLoad(type, element(builder_, address_, i)));
    }
    for (const auto& part : address_.parts) {  // fastest first: each round leaves one per group
      std::vector<llvm::Value*> chosen;
      for (std::size_t first = 0; first < values.size(); first += part.count) {
        chosen.push_back(choose(part, llvm::ArrayRef(values).slice(first, part.count)));
      }
      values = std::move(chosen);
    }
    return values[0];
  }

  void store(llvm::Value* value) {
    for (std::uint64_t i = 0; i < address_.combinations(); ++i) {
      auto* place = element(builder_, address_, i);
      auto* old = builder_.CreateLoad(value->getType(), place);
      builder_.CreateStore(builder_.CreateSelect(is_chosen(i), value, old), place);
    }
  }

  llvm::Value* table(const llvm::GlobalVariable& global, llvm::Type* type, Opaque& opaque) {
    const auto& data = at_.getModule()->getDataLayout();
    unsigned bits = 0;
    for (const auto& part : address_.parts) bits += width_of(part);
    Table table;
    table.width = type->getIntegerBitWidth();
    table.name = name_of(global);
    llvm::Value* address = nullptr;
    for (auto part = address_.parts.rbegin(); part != address_.parts.rend(); ++part) {
      auto* index = builder_.CreateZExtOrTrunc(part->index, builder_.getIntNTy(width_of(*part)));
      index = builder_.CreateZExt(index, builder_.getIntNTy(bits));
      address = address == nullptr
                    ? index
                    : builder_.CreateOr(builder_.CreateShl(address, width_of(*part)), index);
    }
    for (std::uint64_t i = 0; i < std::uint64_t{1} << bits; ++i) {
      const auto place = llvm::APInt(64, offset_at(i));
      auto* entry = llvm::ConstantFoldLoadFromConst(
          const_cast<llvm::Constant*>(global.getInitializer()), type, place, data);
      const auto* number = llvm::dyn_cast_or_null<llvm::ConstantInt>(entry);
      // Beyond the last element nothing is ever read; zero is as good as anything.
      table.entries.push_back(number == nullptr ? llvm::APInt(table.width, 0) : number->getValue());
    }
    return opaque.table(builder_, address, std::move(table));
  }

  const Address& address() const { return address_; }

 private:
  static unsigned width_of(const Address::Part& part) {
    return std::max(1U, llvm::Log2_64_Ceil(part.count));
  }

  std::uint64_t offset_at(std::uint64_t bits) const {
    std::uint64_t place = address_.offset;
    for (const auto& part : address_.parts) {
      place += (bits & ((std::uint64_t{1} << width_of(part)) - 1)) * part.stride;
      bits >>= width_of(part);
    }
    return place;
  }

  static std::string name_of(const llvm::GlobalVariable& global) {
    llvm::SmallVector<llvm::DIGlobalVariableExpression*> described;
    global.getDebugInfo(described);
    if (!described.empty()) return described[0]->getVariable()->getName().str();
    return global.getName().rsplit('.').second.str();  // __const.<function>.<variable>
  }

  // A tree over the bits of the index, so that each level halves what is left.
  llvm::Value* choose(const Address::Part& part, llvm::ArrayRef<llvm::Value*> values) {
    if (values.size() == 1) return values[0];
    const unsigned bit = llvm::Log2_64_Ceil(values.size()) - 1;
    const std::size_t half = std::size_t{1} << bit;
    auto* is_upper =
        builder_.CreateTrunc(builder_.CreateLShr(part.index, bit), builder_.getInt1Ty());
    return builder_.CreateSelect(is_upper, choose(part, values.drop_front(half)),
                                 choose(part, values.take_front(half)));
  }

  llvm::Value* is_chosen(std::uint64_t combination) {
    llvm::Value* all = nullptr;
    for (const auto& part : address_.parts) {
      auto* here = builder_.CreateICmpEQ(
          part.index, llvm::ConstantInt::get(part.index->getType(), combination % part.count));
      all = all == nullptr ? here : builder_.CreateAnd(all, here);
      combination /= part.count;
    }
    return all;
  }

  llvm::Instruction& at_;
  llvm::IRBuilder<> builder_;
  Address address_;
};

}  // namespace

void expand_accesses(llvm::Function& function, Opaque& opaque) {
  std::vector<llvm::Instruction*> accesses;
  for (auto& instruction : llvm::instructions(function)) {
    auto* pointer = llvm::getLoadStorePointerOperand(&instruction);
    if (pointer != nullptr && varies(const_cast<llvm::Value*>(pointer), instruction)) {
      accesses.push_back(&instruction);
    }
  }
  for (auto* access : accesses) {
    auto* pointer = const_cast<llvm::Value*>(llvm::getLoadStorePointerOperand(access));
    Expander expander(*access, pointer);
    const auto* global = dyn_cast<llvm::GlobalVariable>(expander.address().object);
    if (global == nullptr && !llvm::isa<llvm::AllocaInst>(expander.address().object)) {
      throw Refusal(source_of(*access), "it is not known at compile time which array is meant",
                    "choose between the elements instead of between the arrays");
    }
    if (auto* store = dyn_cast<llvm::StoreInst>(access)) {
      expander.store(store->getValueOperand());
    } else {
      auto* value = global == nullptr ? expander.load(access->getType())
                                      : expander.table(*global, access->getType(), opaque);
      access->replaceAllUsesWith(value);
    }
    access->eraseFromParent();
  }
}

}  // namespace hlsgen
