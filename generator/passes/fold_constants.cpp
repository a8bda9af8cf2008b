#include "generator/passes/fold_constants.hpp"

#include "generator/passes/evaluate.hpp"
#include "generator/passes/rebuild.hpp"

#include <algorithm>

namespace hlsgen {
namespace {

using llvm::APInt;

bool is_source(Op op) { return op <= Op::kInstanceOutput; }
bool commutes(Op op) {
  return op == Op::kAdd || op == Op::kMul || op == Op::kAnd || op == Op::kOr || op == Op::kXor ||
         op == Op::kEq || op == Op::kNe;
}
bool inverse_of(const Rebuild& b, NodeId a, NodeId c) {
  return (b.is(a, Op::kNot) && b.node(a).in[0] == c) || (b.is(c, Op::kNot) && b.node(c).in[0] == a);
}

// x op constant, for operators that commute.
NodeId with_constant(Rebuild& b, const Node& n, NodeId x, const APInt& c) {
  switch (n.op) {
    case Op::kAdd:
      if (c.isZero()) return x;
      break;
    case Op::kMul:
      if (c.isZero()) return b.value(c);
      if (c.isOne()) return x;
      if (c.isPowerOf2()) return b.binary(Op::kShl, x, b.value(APInt(32, c.logBase2())));
      return kNone;
    case Op::kAnd:
      if (c.isZero()) return b.value(c);
      if (c.isAllOnes()) return x;
      break;
    case Op::kOr:
      if (c.isZero()) return x;
      if (c.isAllOnes()) return b.value(c);
      break;
    case Op::kXor:
      if (c.isZero()) return x;
      if (c.isAllOnes()) return b.inverse(x);
      break;
    default: return kNone;
  }
  // (x op c1) op c2
  const Node inner = b.node(x);
  if (inner.op == n.op)
    if (const APInt* d = b.constant(inner.in[1]))
      return b.binary(n.op, inner.in[0], b.value(evaluate(b.module(), n, {*d, c})));
  return kNone;
}

NodeId same_operand(Rebuild& b, const Node& n) {
  const NodeId x = n.in[0];
  switch (n.op) {
    case Op::kAnd: case Op::kOr: return x;
    case Op::kSub: case Op::kXor: return b.zero(n.width);
    case Op::kEq: case Op::kUle: case Op::kSle: return b.value(APInt(1, 1));
    case Op::kNe: case Op::kUlt: case Op::kSlt: return b.zero(1);
    default: return kNone;
  }
}

NodeId shift_by_constant(Rebuild& b, const Node& n, const APInt& by) {
  const NodeId x = n.in[0];
  const auto amount = static_cast<unsigned>(by.getLimitedValue(n.width));
  if (amount == 0) return x;
  if (n.op == Op::kAshr) {
    const unsigned low = std::min(amount, n.width - 1);
    return b.sext(b.slice(x, low, n.width - low), n.width);
  }
  if (amount == n.width) return b.zero(n.width);
  if (n.op == Op::kLshr) return b.zext(b.slice(x, amount, n.width - amount), n.width);
  return b.concat({b.slice(x, 0, n.width - amount), b.zero(amount)});
}

NodeId one_bit(Rebuild& b, const Node& n) {
  switch (n.op) {
    case Op::kAdd: case Op::kSub: case Op::kNe: return b.binary(Op::kXor, n.in[0], n.in[1]);
    case Op::kMul: return b.binary(Op::kAnd, n.in[0], n.in[1]);
    case Op::kUlt: return b.binary(Op::kAnd, b.inverse(n.in[0]), n.in[1]);
    case Op::kUle: return b.binary(Op::kOr, b.inverse(n.in[0]), n.in[1]);
    case Op::kSlt: return b.binary(Op::kAnd, n.in[0], b.inverse(n.in[1]));
    case Op::kSle: return b.binary(Op::kOr, n.in[0], b.inverse(n.in[1]));
    default: return kNone;
  }
}

// x & (x & y), x & ~x and their duals.
NodeId absorb(Rebuild& b, const Node& n) {
  if (n.op != Op::kAnd && n.op != Op::kOr) return kNone;
  if (inverse_of(b, n.in[0], n.in[1]))
    return b.value(n.op == Op::kAnd ? APInt::getZero(n.width) : APInt::getAllOnes(n.width));
  const Op dual = n.op == Op::kAnd ? Op::kOr : Op::kAnd;
  for (int side = 0; side < 2; ++side) {
    const NodeId x = n.in[side], other = n.in[1 - side];
    const Node inner = b.node(other);
    if (inner.op != n.op && inner.op != dual) continue;
    for (int i = 0; i < 2; ++i) {
      if (inner.in[i] == x) return inner.op == n.op ? other : x;
      if (inverse_of(b, inner.in[i], x)) {
        if (inner.op == dual) return b.binary(n.op, x, inner.in[1 - i]);
        return b.value(n.op == Op::kAnd ? APInt::getZero(n.width) : APInt::getAllOnes(n.width));
      }
    }
  }
  return kNone;
}

NodeId fold(Rebuild& b, const Node& n) {
  if (is_source(n.op)) return kNone;
  std::vector<APInt> values;
  for (const NodeId operand : n.in)
    if (const APInt* c = b.constant(operand)) values.push_back(*c);
  if (values.size() == n.in.size()) return b.value(evaluate(b.module(), n, values));

  if (n.op == Op::kNot)
    return b.is(n.in[0], Op::kNot) ? b.node(n.in[0]).in[0] : kNone;
  if (n.op == Op::kTable || n.in.size() != 2 || n.op == Op::kConcat) return kNone;

  const APInt* right = b.constant(n.in[1]);
  if (n.op == Op::kShl || n.op == Op::kLshr || n.op == Op::kAshr)
    return right != nullptr ? shift_by_constant(b, n, *right) : kNone;
  if (commutes(n.op) && b.constant(n.in[0]) != nullptr) return b.binary(n.op, n.in[1], n.in[0]);
  if (n.in[0] == n.in[1])
    if (const NodeId r = same_operand(b, n); r != kNone) return r;
  if (n.width == 1 && b.width(n.in[0]) == 1)
    if (const NodeId r = one_bit(b, n); r != kNone) return r;
  if (const NodeId r = absorb(b, n); r != kNone) return r;
  if (right == nullptr) return kNone;
  const APInt c = *right;
  if (n.op == Op::kSub)
    return c.isZero() ? n.in[0] : b.binary(Op::kAdd, n.in[0], b.value(-c));
  return with_constant(b, n, n.in[0], c);
}

}  // namespace

bool fold_constants(Module& module) { return rewrite(module, fold); }

}  // namespace hlsgen
