// LLVM's integer intrinsics in terms of netlist operators.
//
//     smax(a, b)      ->  mux(a < b, b, a)
//     sadd.sat(a, b)  ->  the sum in one bit more, and its ends where that bit and the sign differ
//     umul.with.overflow(a, b)  ->  the product in twice the width, and whether it needs that
//     ctlz(x)         ->  a tree: count of the upper half, or half plus the count of the lower
//
// Doc: docs/generator.md   Test: tests/generator/frontend/design_test.cpp

#pragma once

#include <llvm/IR/IntrinsicInst.h>

#include "generator/dataflow/nodes.hpp"

namespace hlsgen {

// kNone when the intrinsic is none of those.
NodeId intrinsic(NodeBuilder& nodes, llvm::Intrinsic::ID id, const std::vector<NodeId>& in);

// One part of the pair that it gives: the result, or whether it did not fit.
NodeId with_overflow(NodeBuilder& nodes, const llvm::WithOverflowInst& at, bool flag, NodeId a,
                     NodeId b);

}  // namespace hlsgen
