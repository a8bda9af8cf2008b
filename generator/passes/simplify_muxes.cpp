#include "generator/passes/simplify_muxes.hpp"

#include "generator/passes/rebuild.hpp"

namespace hlsgen {
namespace {

using llvm::APInt;

bool is_inverse(const Rebuild& b, NodeId a, NodeId c) {
  return (b.is(a, Op::kNot) && b.node(a).in[0] == c) || (b.is(c, Op::kNot) && b.node(c).in[0] == a);
}

// The value of x where `condition` is known, or kNone if it is no simpler.
NodeId given(Rebuild& b, NodeId x, NodeId condition, bool holds, int depth) {
  if (x == condition) return b.value(APInt(1, holds ? 1 : 0));
  if (b.width(x) == 1 && is_inverse(b, x, condition)) return b.value(APInt(1, holds ? 0 : 1));
  // a && c holds: so do a and c.
  const Node c = b.node(condition);
  if (c.width == 1 && depth > 0 && (holds ? c.op == Op::kAnd : c.op == Op::kOr))
    for (const NodeId part : c.in)
      if (const NodeId r = given(b, x, part, holds, depth - 1); r != kNone) return r;
  if (c.op == Op::kNot)
    if (const NodeId r = given(b, x, c.in[0], !holds, depth); r != kNone) return r;
  const Node n = b.node(x);
  if (n.op == Op::kMux && depth > 0) {
    if (const NodeId t = given(b, n.in[0], condition, holds, depth - 1); t != kNone)
      if (const APInt* v = b.constant(t)) return v->isZero() ? n.in[2] : n.in[1];
    return kNone;
  }
  if (n.width != 1 || depth == 0 || (n.op != Op::kAnd && n.op != Op::kOr)) return kNone;
  for (int i = 0; i < 2; ++i) {
    const NodeId side = given(b, n.in[i], condition, holds, depth - 1);
    if (side == kNone) continue;
    const APInt* v = b.constant(side);
    if (v == nullptr) return b.binary(n.op, side, n.in[1 - i]);
    return v->isZero() == (n.op == Op::kAnd) ? side : n.in[1 - i];
  }
  return kNone;
}

NodeId one_bit(Rebuild& b, NodeId c, NodeId then, NodeId otherwise) {
  if (const APInt* v = b.constant(then)) {
    const bool one = !v->isZero();
    return one ? b.binary(Op::kOr, c, otherwise) : b.binary(Op::kAnd, b.inverse(c), otherwise);
  }
  if (const APInt* v = b.constant(otherwise)) {
    const bool one = !v->isZero();
    return one ? b.binary(Op::kOr, b.inverse(c), then) : b.binary(Op::kAnd, c, then);
  }
  if (then == c) return b.binary(Op::kOr, c, otherwise);
  if (otherwise == c) return b.binary(Op::kAnd, c, then);
  if (is_inverse(b, then, otherwise)) return b.inverse(b.binary(Op::kXor, c, then));
  return kNone;
}

// Two arms that do the same to different operands: one operator behind a choice of operands.
NodeId shared_operator(Rebuild& b, NodeId condition, NodeId then, NodeId otherwise) {
  const Node t = b.node(then), o = b.node(otherwise);
  if (t.op != o.op || !b.used_once(then) || !b.used_once(otherwise)) return kNone;
  switch (t.op) {
    case Op::kAdd: case Op::kMul: case Op::kSub: case Op::kShl: case Op::kLshr: case Op::kAshr:
    case Op::kUlt: case Op::kUle: case Op::kSlt: case Op::kSle: break;
    case Op::kTable:
      if (t.index != o.index) return kNone;
      break;
    case Op::kZext: case Op::kSext: break;
    default: return kNone;
  }
  Node shared = t;
  shared.name.clear();
  if (t.in.size() == 1) {
    if (b.width(t.in[0]) != b.width(o.in[0])) return kNone;
    shared.in[0] = b.mux(condition, t.in[0], o.in[0]);
    return b.add(std::move(shared));
  }
  const bool commutes = t.op == Op::kAdd || t.op == Op::kMul;
  for (int i = 0; i < 2; ++i) {
    for (int k = 0; k < 2; ++k) {
      if (t.in[i] != o.in[k] || (!commutes && i != k)) continue;
      if (b.width(t.in[1 - i]) != b.width(o.in[1 - k])) continue;
      shared.in[i] = t.in[i];
      shared.in[1 - i] = b.mux(condition, t.in[1 - i], o.in[1 - k]);
      return b.add(std::move(shared));
    }
  }
  // Two multipliers cost more than two rows of muxes; two adders do not.
  if (t.op != Op::kMul) return kNone;
  shared.in[0] = b.mux(condition, t.in[0], o.in[0]);
  shared.in[1] = b.mux(condition, t.in[1], o.in[1]);
  return b.add(std::move(shared));
}

// Saturation: at the limit both arms are the same, so x < limit and x <= limit do equally well.
// simplify_compares drops the lower zeros of the bound of x < c, and the lower ones of c < x: an even
// limit belongs to the right of the comparison, an odd one to the left.
NodeId saturated(Rebuild& b, const Node& n) {
  const Node c = b.node(n.in[0]);
  if (c.op != Op::kUlt && c.op != Op::kSlt) return kNone;
  const APInt* limit = b.constant(n.in[2]);
  const Node kept = b.node(n.in[1]);
  const bool part = kept.op == Op::kSlice && kept.low == 0;
  for (int i = 0; i < 2 && limit != nullptr; ++i) {
    const APInt* bound = b.constant(c.in[i]);
    const NodeId x = c.in[1 - i];
    if (bound == nullptr || (n.in[1] != x && !(part && kept.in[0] == x))) continue;
    const bool on_right = i == 1;
    if ((*bound)[0] != on_right || bound->trunc(n.width) != *limit) continue;
    return b.mux(b.binary(c.op, c.in[1], c.in[0]), n.in[2], n.in[1]);
  }
  return kNone;
}

// Conditions that were joined, and are told apart again by an arm.
NodeId ordered(Rebuild& b, const Node& n) {
  const Node c = b.node(n.in[0]);
  const bool either = c.op == Op::kOr;
  if (!either && c.op != Op::kAnd) return kNone;
  const NodeId arm = n.in[either ? 1 : 2], rest = n.in[either ? 2 : 1];
  const Node inner = b.node(arm);
  if (inner.op != Op::kMux || !b.used_once(arm)) return kNone;
  for (int i = 0; i < 2; ++i) {
    if (c.in[i] != inner.in[0]) continue;
    const NodeId other = c.in[1 - i];
    if (either) return b.mux(c.in[i], inner.in[1], b.mux(other, inner.in[2], rest));
    return b.mux(c.in[i], b.mux(other, rest, inner.in[1]), inner.in[2]);
  }
  return kNone;
}

NodeId mux(Rebuild& b, const Node& n) {
  if (n.op != Op::kMux) return kNone;
  const NodeId c = n.in[0], then = n.in[1], otherwise = n.in[2];
  if (then == otherwise) return then;
  const Node condition = b.node(c);
  if (condition.op == Op::kConstant) return condition.value.isZero() ? otherwise : then;
  if (condition.op == Op::kNot) return b.mux(condition.in[0], otherwise, then);
  if (condition.op == Op::kNe)
    return b.mux(b.binary(Op::kEq, condition.in[0], condition.in[1]), otherwise, then);
  const APInt *t = b.constant(then), *o = b.constant(otherwise);
  if (t != nullptr && o != nullptr && *t == *o) return then;
  if (n.width == 1)
    if (const NodeId r = one_bit(b, c, then, otherwise); r != kNone) return r;
  if (const NodeId r = given(b, then, c, true, 3); r != kNone) return b.mux(c, r, otherwise);
  if (const NodeId r = given(b, otherwise, c, false, 3); r != kNone) return b.mux(c, then, r);
  const Node inner_then = b.node(then), inner_else = b.node(otherwise);
  if (inner_else.op == Op::kMux) {
    if (const NodeId r = given(b, inner_else.in[0], c, false, 3); r != kNone)
      return b.mux(c, then, b.mux(r, inner_else.in[1], inner_else.in[2]));
    if (inner_else.in[1] == then)
      return b.mux(b.binary(Op::kOr, c, inner_else.in[0]), then, inner_else.in[2]);
  }
  if (inner_then.op == Op::kMux) {
    if (const NodeId r = given(b, inner_then.in[0], c, true, 3); r != kNone)
      return b.mux(c, b.mux(r, inner_then.in[1], inner_then.in[2]), otherwise);
    if (inner_then.in[2] == otherwise)
      return b.mux(b.binary(Op::kAnd, c, inner_then.in[0]), inner_then.in[1], otherwise);
    if (inner_then.in[1] == otherwise)
      return b.mux(b.binary(Op::kAnd, c, b.inverse(inner_then.in[0])), inner_then.in[2], otherwise);
  }
  if (const NodeId r = saturated(b, n); r != kNone) return r;
  if (const NodeId r = ordered(b, n); r != kNone) return r;
  return shared_operator(b, c, then, otherwise);
}

}  // namespace

bool simplify_muxes(Module& module) { return rewrite(module, mux); }

}  // namespace hlsgen
