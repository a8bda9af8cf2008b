// Where each number of a C++ class lies in memory, from the debug information.
//
//     struct In { bool enable; Config config; UInt<3> history[2]; };
//         ->  enable  config.kp  config.ki  history[0]  history[1]
//
// Nested structs flatten with '.', arrays give one leaf per element.  A class with one private
// member of a _BitInt type is a number (as Bits<W, S>) and gives one leaf.  Members that have a
// `tick` are blocks: they become instances and their own members do not appear.
//
// Refuses what is not a number: pointers, references, floating point, unions, bit-fields, virtual
// functions.
//
// Doc: docs/generator.md   Test: tests/generator/frontend/layout_test.cpp

#pragma once

#include <llvm/IR/DebugInfoMetadata.h>

#include <vector>

#include "generator/netlist.hpp"

namespace hlsgen {

struct LeafPlace {
  Leaf leaf;                  // leaf.enumeration is filled in when the module is made
  std::uint64_t offset = 0;   // bytes
  unsigned storage_bits = 8;  // width of the integer that clang loads and stores
  const llvm::DICompositeType* enumeration = nullptr;
  const llvm::DICompositeType* set_of = nullptr;  // the enumeration of a OneHot
  SourceLine source;
};

struct InstancePlace {
  std::string name;
  std::uint64_t offset = 0;
  std::uint64_t size = 0;
  const llvm::DICompositeType* type = nullptr;
  SourceLine source;
};

struct Layout {
  std::uint64_t size = 0;
  std::vector<LeafPlace> leaves;
  std::vector<InstancePlace> instances;
};

Layout lay_out(const llvm::DICompositeType* type);

// The class behind typedefs; null when the type is no class.
const llvm::DICompositeType* class_of(const llvm::DIType* type);

// The declaration of the member function `tick`, null when the class has none.
const llvm::DISubprogram* tick_of(const llvm::DICompositeType* type);

Enumeration enumeration_of(const llvm::DICompositeType* type);

}  // namespace hlsgen
