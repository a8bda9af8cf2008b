// The blocks of a program: which class is the top, which classes it is made of, and which functions
// are their clocks.
//
// The top is the class that the source names in `template struct Synthesize<Class>;`; its members
// with a `tick` are blocks again, and so on down.
//
// Doc: docs/generator.md   Test: tests/generator/frontend/design_test.cpp

#pragma once

#include <llvm/IR/Module.h>

#include <map>
#include <string>
#include <vector>

#include "generator/cpp/layout.hpp"
#include "generator/machine/budget.hpp"

namespace hlsgen {

struct Block {
  std::string module;     // snake_case of the class, with the template arguments that matter
  std::string cpp_class;  // with namespaces
  SourceLine source;
  const llvm::DICompositeType* type = nullptr;
  llvm::Function* tick = nullptr;
  Layout state, in, out;
  std::vector<llvm::APInt> reset;  // one per leaf of the state, from the constructor
  // Of a schedule: the block that it works through, which has a place in `order` but no module.
  const llvm::DICompositeType* sample = nullptr;
  Budget budget;
  bool has_module = false;
};

struct Blocks {
  std::vector<Block> order;         // children before parents; the top is last
  llvm::Function* reset = nullptr;  // returns the top in its reset state
  std::map<const llvm::DICompositeType*, std::size_t> index;

  const Block& of(const llvm::DICompositeType* type) const { return order[index.at(type)]; }
  bool is_tick(const llvm::Function* function) const;
};

// `name` chooses among several tops by class or module name; empty when there is only one.
Blocks find_blocks(llvm::Module& module, const std::string& source, const std::string& name);

}  // namespace hlsgen
