#include "generator/dataflow/intrinsics.hpp"

#include <llvm/Support/MathExtras.h>

#include <algorithm>

namespace hlsgen {
namespace {

// Number of zeros above the highest one, for widths that are powers of two: log2(width) + 1 bits,
// the topmost of which says that there is no one at all.
NodeId leading_zeros(NodeBuilder& nodes, NodeId a) {
  const unsigned width = nodes.width(a);
  if (width == 1) return nodes.unary_not(a);
  const NodeId upper = leading_zeros(nodes, nodes.slice(a, width / 2, width / 2));
  const NodeId lower = leading_zeros(nodes, nodes.slice(a, width / 2, 0));
  const unsigned bits = nodes.width(upper);
  const NodeId no_upper = nodes.bit(upper, bits - 1);
  const NodeId no_lower = nodes.bit(lower, bits - 1);
  std::vector<NodeId> parts = {nodes.binary(Op::kAnd, no_upper, no_lower),
                               nodes.binary(Op::kAnd, no_upper, nodes.unary_not(no_lower))};
  if (bits > 1) {
    parts.push_back(
        nodes.mux(no_upper, nodes.slice(lower, bits - 1, 0), nodes.slice(upper, bits - 1, 0)));
  }
  return nodes.concat(parts);
}

NodeId reversed(NodeBuilder& nodes, NodeId a, unsigned group) {
  std::vector<NodeId> parts;
  for (unsigned i = 0; i < nodes.width(a); i += group) parts.push_back(nodes.slice(a, group, i));
  return nodes.concat(parts);
}

NodeId count_leading(NodeBuilder& nodes, NodeId a) {
  const unsigned width = nodes.width(a);
  const unsigned padded = 1U << llvm::Log2_32_Ceil(width);
  // Ones below stop the count at the width.
  const NodeId whole =
      padded == width ? a
                      : nodes.concat({a, nodes.constant(llvm::APInt::getAllOnes(padded - width))});
  const NodeId count = leading_zeros(nodes, whole);
  return nodes.width(count) > width ? nodes.slice(count, width, 0) : nodes.zext(count, width);
}

NodeId population(NodeBuilder& nodes, NodeId a) {
  std::vector<NodeId> terms;
  for (unsigned i = 0; i < nodes.width(a); ++i) terms.push_back(nodes.bit(a, i));
  while (terms.size() > 1) {  // a balanced tree, one bit wider per level
    std::vector<NodeId> sums;
    for (std::size_t i = 0; i + 1 < terms.size(); i += 2) {
      const unsigned width = std::max(nodes.width(terms[i]), nodes.width(terms[i + 1])) + 1;
      sums.push_back(
          nodes.binary(Op::kAdd, nodes.zext(terms[i], width), nodes.zext(terms[i + 1], width)));
    }
    if (terms.size() % 2 != 0) sums.push_back(terms.back());
    terms = std::move(sums);
  }
  const unsigned width = nodes.width(a);
  return nodes.width(terms[0]) > width ? nodes.slice(terms[0], width, 0)
                                       : nodes.zext(terms[0], width);
}

NodeId signed_saturation(NodeBuilder& nodes, Op op, NodeId a, NodeId b) {
  const unsigned width = nodes.width(a);
  const NodeId sum = nodes.binary(op, nodes.sext(a, width + 1), nodes.sext(b, width + 1));
  const NodeId sign = nodes.bit(sum, width);
  const NodeId leaves = nodes.binary(Op::kXor, sign, nodes.bit(sum, width - 1));
  const NodeId end = nodes.mux(sign, nodes.constant(llvm::APInt::getSignedMinValue(width)),
                               nodes.constant(llvm::APInt::getSignedMaxValue(width)));
  return nodes.mux(leaves, end, nodes.slice(sum, width, 0));
}

NodeId unsigned_saturation(NodeBuilder& nodes, NodeId a, NodeId b) {
  const unsigned width = nodes.width(a);
  const NodeId sum = nodes.binary(Op::kAdd, nodes.zext(a, width + 1), nodes.zext(b, width + 1));
  return nodes.mux(nodes.bit(sum, width), nodes.constant(llvm::APInt::getAllOnes(width)),
                   nodes.slice(sum, width, 0));
}

// LLVM takes the amount of a rotation modulo the width.
NodeId rotation(NodeBuilder& nodes, NodeId amount, unsigned width) {
  if (nodes.is_constant(amount)) return nodes.constant(32, nodes.value(amount) % width);
  if (llvm::isPowerOf2_32(width)) {
    return width == 1 ? nodes.constant(1, 0) : nodes.slice(amount, llvm::Log2_32(width), 0);
  }
  const NodeId limit = nodes.constant(nodes.width(amount), width);
  const unsigned bits = nodes.significant(amount);
  if (bits >= 32 || (1U << bits) > 2 * width) return kNone;
  return nodes.mux(nodes.compare(Op::kUlt, amount, limit), amount,
                   nodes.binary(Op::kSub, amount, limit));
}

NodeId funnel(NodeBuilder& nodes, bool left, const std::vector<NodeId>& in) {
  const unsigned width = nodes.width(in[0]);
  const NodeId amount = rotation(nodes, in[2], width);
  if (amount == kNone) return kNone;
  const NodeId both = nodes.concat({in[0], in[1]});
  const NodeId shifted = nodes.shift(left ? Op::kShl : Op::kLshr, both, amount);
  return nodes.slice(shifted, width, left ? width : 0);
}

}  // namespace

NodeId with_overflow(NodeBuilder& nodes, const llvm::WithOverflowInst& at, bool flag, NodeId a,
                     NodeId b) {
  const auto operation = at.getBinaryOp();
  const bool is_product = operation == llvm::Instruction::Mul;
  const Op op = is_product                             ? Op::kMul
                : operation == llvm::Instruction::Add ? Op::kAdd
                                                      : Op::kSub;
  const unsigned width = nodes.width(a);
  if (!flag) return nodes.binary(op, a, b);
  const unsigned exact = is_product ? 2 * width : width + 1;
  const auto widened = [&](NodeId x) {
    return at.isSigned() ? nodes.sext(x, exact) : nodes.zext(x, exact);
  };
  const NodeId whole = nodes.binary(op, widened(a), widened(b));
  return nodes.compare(Op::kNe, whole, widened(nodes.slice(whole, width, 0)));
}

NodeId intrinsic(NodeBuilder& nodes, llvm::Intrinsic::ID id, const std::vector<NodeId>& in) {
  const auto a = [&] { return in[0]; };
  const auto b = [&] { return in[1]; };
  const auto zero = [&] { return nodes.constant(nodes.width(in[0]), 0); };
  switch (id) {
    case llvm::Intrinsic::smax:
      return nodes.mux(nodes.compare(Op::kSlt, a(), b()), b(), a());
    case llvm::Intrinsic::smin:
      return nodes.mux(nodes.compare(Op::kSlt, a(), b()), a(), b());
    case llvm::Intrinsic::umax:
      return nodes.mux(nodes.compare(Op::kUlt, a(), b()), b(), a());
    case llvm::Intrinsic::umin:
      return nodes.mux(nodes.compare(Op::kUlt, a(), b()), a(), b());
    case llvm::Intrinsic::abs:
      return nodes.mux(nodes.compare(Op::kSlt, a(), zero()), nodes.binary(Op::kSub, zero(), a()),
                       a());
    case llvm::Intrinsic::uadd_sat:
      return unsigned_saturation(nodes, a(), b());
    case llvm::Intrinsic::usub_sat:
      return nodes.mux(nodes.compare(Op::kUlt, a(), b()), zero(), nodes.binary(Op::kSub, a(), b()));
    case llvm::Intrinsic::sadd_sat:
      return signed_saturation(nodes, Op::kAdd, a(), b());
    case llvm::Intrinsic::ssub_sat:
      return signed_saturation(nodes, Op::kSub, a(), b());
    case llvm::Intrinsic::fshl:
      return funnel(nodes, true, in);
    case llvm::Intrinsic::fshr:
      return funnel(nodes, false, in);
    case llvm::Intrinsic::ctpop:
      return population(nodes, a());
    case llvm::Intrinsic::ctlz:
      return count_leading(nodes, a());
    case llvm::Intrinsic::cttz:
      return count_leading(nodes, reversed(nodes, a(), 1));
    case llvm::Intrinsic::bswap:
      return reversed(nodes, a(), 8);
    case llvm::Intrinsic::bitreverse:
      return reversed(nodes, a(), 1);
    default:
      return kNone;
  }
}

}  // namespace hlsgen
