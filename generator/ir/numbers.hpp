// The integers within a type, by offset, and the pointers (a closure holds some); padding is none.
//
//     { i24, i8, [2 x i3] }   ->   i24 at 0, i8 at 4, i3 at 5, i3 at 6
//
// Doc: docs/generator.md   Test: tests/generator/frontend/layout_test.cpp

#pragma once

#include <llvm/IR/DataLayout.h>
#include <llvm/IR/DerivedTypes.h>

#include <cstdint>
#include <vector>

namespace hlsgen {

struct Number {
  std::uint64_t offset = 0;
  llvm::Type* type = nullptr;
};

std::vector<Number> numbers_in(llvm::Type* type, const llvm::DataLayout& data);

}  // namespace hlsgen
