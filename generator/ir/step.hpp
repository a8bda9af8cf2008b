// A block's tick as a function of named globals, one per number:
//
//     Out Vco::tick(const In&)     ->     void step() {
//                                           state.phase = @reg.phase;  in.step = @in.step; ...
//                                           out = tick(state, in);
//                                           @next.phase = state.phase;  @out.wrap = out.wrap; ...
//                                         }
//
// After inlining and promotion to registers nothing is left of the structs, and every port and
// register is known by name.  The same is done to the constructor for the reset values.
//
// Doc: docs/generator.md   Test: tests/generator/frontend/design_test.cpp

#pragma once

#include <llvm/IR/Instructions.h>

#include <map>
#include <string>
#include <vector>

#include "generator/cpp/blocks.hpp"
#include "generator/ir/opaque.hpp"

namespace hlsgen {

struct StepInstance {
  const InstancePlace* place = nullptr;
  const Block* block = nullptr;
  std::vector<llvm::GlobalVariable*> inputs, outputs;
  // Witness that the parent leaves the child's registers alone: what they hold after the clock, and
  // the mark they held before.
  std::vector<llvm::GlobalVariable*> kept;
  std::vector<unsigned> marks;
};

struct Step {
  llvm::Function* function = nullptr;
  llvm::AllocaInst* state = nullptr;
  std::vector<llvm::GlobalVariable*> inputs, registers;  // in the order of the leaves
  std::vector<llvm::GlobalVariable*> outputs, nexts;
  std::vector<StepInstance> instances;  // by place; in order of call once they are cut out
};

// Registers of an enumeration are taken to hold one of its enumerators, unless they are in `wide`;
// what is stored into them has to prove the same (Opaque::index).
Step build_step(llvm::Module& module, const Block& block, const Blocks& blocks,
                const std::vector<bool>& wide, Opaque& opaque);

// Stores each leaf of the top, children's included, to a global of its own: `nexts`.
Step build_reset(llvm::Module& module, const Blocks& blocks, const Layout& all, Opaque& opaque);

// The leaves of a block and of all blocks within it, names prefixed by the instance's.
Layout whole_state(const Block& block, const Blocks& blocks);

// How a leaf crosses between memory (as clang stores it) and its exact width.
void store_leaf(llvm::IRBuilder<>& builder, const LeafPlace& place, llvm::Value* base,
                llvm::Value* exact);
llvm::Value* load_leaf(llvm::IRBuilder<>& builder, const LeafPlace& place, llvm::Value* base,
                       std::uint64_t enumerators, Opaque& opaque);

}  // namespace hlsgen
