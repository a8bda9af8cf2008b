#include "generator/ir/numbers.hpp"

namespace hlsgen {
namespace {

void append(llvm::Type* type, const llvm::DataLayout& data, std::uint64_t offset,
            std::vector<Number>& numbers) {
  if (type->isIntegerTy() || type->isPointerTy()) {
    numbers.push_back({offset, type});
  } else if (auto* structure = llvm::dyn_cast<llvm::StructType>(type)) {
    const auto* layout = data.getStructLayout(structure);
    for (unsigned i = 0; i < structure->getNumElements(); ++i) {
      append(structure->getElementType(i), data, offset + layout->getElementOffset(i), numbers);
    }
  } else if (auto* array = llvm::dyn_cast<llvm::ArrayType>(type)) {
    const auto stride = data.getTypeAllocSize(array->getElementType());
    for (std::uint64_t i = 0; i < array->getNumElements(); ++i) {
      append(array->getElementType(), data, offset + i * stride, numbers);
    }
  }
}

}  // namespace

std::vector<Number> numbers_in(llvm::Type* type, const llvm::DataLayout& data) {
  std::vector<Number> numbers;
  append(type, data, 0, numbers);
  return numbers;
}

}  // namespace hlsgen
