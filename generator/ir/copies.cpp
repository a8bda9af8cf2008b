#include "generator/ir/copies.hpp"

#include <llvm/IR/Constants.h>
#include <llvm/IR/IRBuilder.h>
#include <llvm/IR/InstIterator.h>
#include <llvm/IR/IntrinsicInst.h>

#include <optional>

#include "generator/ir/address.hpp"
#include "generator/ir/numbers.hpp"

namespace hlsgen {
namespace {

using llvm::dyn_cast;

llvm::Type* type_of(const llvm::Value* object) {
  if (const auto* variable = dyn_cast<llvm::AllocaInst>(object)) {
    return variable->getAllocatedType();
  }
  if (const auto* global = dyn_cast<llvm::GlobalVariable>(object)) return global->getValueType();
  return nullptr;
}

// The numbers that the copy covers, by offset from its start; none when neither side is known.
std::vector<Number> numbers_of(const llvm::MemIntrinsic& copy) {
  const auto& data = copy.getModule()->getDataLayout();
  const auto* length = dyn_cast<llvm::ConstantInt>(copy.getLength());
  if (length == nullptr) return {};
  std::vector<llvm::Value*> sides = {copy.getRawDest()};
  if (const auto* transfer = dyn_cast<llvm::MemTransferInst>(&copy)) {
    sides.push_back(transfer->getRawSource());
  }
  for (auto* side : sides) {
    const auto address = address_of(side);
    auto* type = type_of(address.object);
    if (type == nullptr) continue;
    std::vector<Number> covered;
    for (auto number : numbers_in(type, data)) {
      const auto end = number.offset + data.getTypeStoreSize(number.type).getFixedValue();
      if (number.offset < address.offset || end > address.offset + length->getZExtValue()) continue;
      number.offset -= address.offset;
      covered.push_back(number);
    }
    return covered;
  }
  return {};
}

llvm::Constant* fill_value(const llvm::MemSetInst& fill, llvm::Type* type) {
  const auto* byte = dyn_cast<llvm::ConstantInt>(fill.getValue());
  if (byte == nullptr) return nullptr;
  if (type->isPointerTy()) {
    if (!byte->isZero()) return nullptr;
    return llvm::ConstantPointerNull::get(llvm::cast<llvm::PointerType>(type));
  }
  const unsigned width = type->getIntegerBitWidth();
  const auto whole = llvm::APInt::getSplat((width + 7) / 8 * 8, byte->getValue());
  return llvm::ConstantInt::get(type, whole.trunc(width));
}

void split(llvm::MemIntrinsic& copy) {
  const auto numbers = numbers_of(copy);
  if (numbers.empty()) return;
  llvm::IRBuilder<> builder(&copy);
  const auto at = [&](llvm::Value* base, std::uint64_t offset) {
    return builder.CreateConstInBoundsGEP1_64(builder.getInt8Ty(), base, offset);
  };
  std::vector<llvm::Value*> values;  // all reads before all writes
  for (const auto& number : numbers) {
    const auto* fill = dyn_cast<llvm::MemSetInst>(&copy);
    if (fill != nullptr) {
      values.push_back(fill_value(*fill, number.type));
      if (values.back() == nullptr) return;
    } else {
      auto* source = llvm::cast<llvm::MemTransferInst>(copy).getRawSource();
      values.push_back(builder.CreateLoad(number.type, at(source, number.offset)));
    }
  }
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    builder.CreateStore(values[i], at(copy.getRawDest(), numbers[i].offset));
  }
  copy.eraseFromParent();
}

}  // namespace

void split_copies(llvm::Function& function) {
  std::vector<llvm::MemIntrinsic*> copies;
  for (auto& instruction : llvm::instructions(function)) {
    if (auto* copy = dyn_cast<llvm::MemIntrinsic>(&instruction)) copies.push_back(copy);
  }
  for (auto* copy : copies) split(*copy);
}

}  // namespace hlsgen
