// LLVM's integer intrinsics in terms of netlist operators.
//
//     smax(a, b)      ->  mux(a < b, b, a)
//     sadd.sat(a, b)  ->  the sum in one bit more, and its ends where that bit and the sign differ
//     ctlz(x)         ->  a tree: count of the upper half, or half plus the count of the lower
//
// Doc: docs/generator.md   Test: tests/generator/frontend/design_test.cpp

#pragma once

#include <llvm/IR/Intrinsics.h>

#include "generator/dataflow/nodes.hpp"

namespace hlsgen {

// kNone when the intrinsic is none of those.
NodeId intrinsic(NodeBuilder& nodes, llvm::Intrinsic::ID id, const std::vector<NodeId>& in);

}  // namespace hlsgen
