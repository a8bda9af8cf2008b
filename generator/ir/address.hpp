// A pointer taken apart: object + constant + sum of (index * stride).
//
// Doc: docs/generator.md   Test: tests/generator/frontend/design_test.cpp

#pragma once

#include <llvm/IR/Instructions.h>

#include <cstdint>
#include <vector>

namespace hlsgen {

struct Address {
  struct Part {
    llvm::Value* index = nullptr;
    std::uint64_t stride = 0;
    std::uint64_t count = 0;  // the index lies below
  };
  llvm::Value* object = nullptr;  // an alloca or a constant, or whatever the walk ended at
  std::uint64_t offset = 0;
  std::vector<Part> parts;            // the last one varies slowest
  llvm::Value* by_unknown = nullptr;  // moved by what is no guarded index

  std::uint64_t combinations() const;
  std::uint64_t offset_of(std::uint64_t combination) const;
};

Address address_of(llvm::Value* pointer);

[[noreturn]] void refuse_address(const Address& address, const llvm::Instruction& user);

}  // namespace hlsgen
