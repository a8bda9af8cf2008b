// One LLVM instruction -> nodes.
//
//     %s = add i24 %a, %b     ->     add(a, b)          icmp sgt a, b     ->     b < a
//
// Doc: docs/generator.md   Test: tests/generator/frontend/design_test.cpp

#pragma once

#include <llvm/IR/Instructions.h>

#include "generator/dataflow/nodes.hpp"

namespace hlsgen {

// Everything that has operands only; phis, loads and the generator's own calls are not for here.
// `in` are the operands' nodes, in order.
NodeId instruction(NodeBuilder& nodes, const llvm::Instruction& at, const std::vector<NodeId>& in);

}  // namespace hlsgen
