#include "generator/passes/simplify_compares.hpp"

#include "generator/passes/rebuild.hpp"

namespace hlsgen {
namespace {

using llvm::APInt;

NodeId truth(Rebuild& b, bool holds) { return b.value(APInt(1, holds ? 1 : 0)); }

NodeId inverted(Rebuild& b, const Node& n) {
  const Node c = b.node(n.in[0]);
  switch (c.op) {
    case Op::kEq: return b.binary(Op::kNe, c.in[0], c.in[1]);
    case Op::kNe: return b.binary(Op::kEq, c.in[0], c.in[1]);
    case Op::kUlt: return b.binary(Op::kUle, c.in[1], c.in[0]);
    case Op::kUle: return b.binary(Op::kUlt, c.in[1], c.in[0]);
    case Op::kSlt: return b.binary(Op::kSle, c.in[1], c.in[0]);
    case Op::kSle: return b.binary(Op::kSlt, c.in[1], c.in[0]);
    default: return kNone;
  }
}

// x == c, for what x may be made of; `equal` is false for !=.
NodeId equal_to_constant(Rebuild& b, NodeId value, const APInt& c, bool equal) {
  const Op op = equal ? Op::kEq : Op::kNe;
  const Node x = b.node(value);
  if (x.width == 1) return c.isZero() == equal ? b.inverse(value) : value;
  switch (x.op) {
    case Op::kAdd:
      if (const APInt* k = b.constant(x.in[1])) return b.binary(op, x.in[0], b.value(c - *k));
      return kNone;
    case Op::kSub: case Op::kXor:
      if (c.isZero()) return b.binary(op, x.in[0], x.in[1]);
      if (const APInt* k = b.constant(x.in[1]); k != nullptr && x.op == Op::kXor)
        return b.binary(op, x.in[0], b.value(c ^ *k));
      return kNone;
    case Op::kNot: return b.binary(op, x.in[0], b.value(~c));
    case Op::kZext: case Op::kSext: {
      const APInt low = c.trunc(b.width(x.in[0]));
      if ((x.op == Op::kZext ? low.zext(x.width) : low.sext(x.width)) != c)
        return truth(b, !equal);
      return b.binary(op, x.in[0], b.value(low));
    }
    case Op::kConcat: {
      if (!equal) return kNone;
      NodeId all = kNone;
      unsigned low = x.width;
      for (const NodeId part : x.in) {
        low -= b.width(part);
        const NodeId same =
            b.binary(Op::kEq, part, b.value(c.extractBits(b.width(part), low)));
        all = all == kNone ? same : b.binary(Op::kAnd, all, same);
      }
      return x.in.size() <= 3 ? all : kNone;
    }
    case Op::kMux: {
      const APInt *t = b.constant(x.in[1]), *o = b.constant(x.in[2]);
      if (t != nullptr && o != nullptr) {
        const bool then = (*t == c) == equal, otherwise = (*o == c) == equal;
        if (then == otherwise) return truth(b, then);
        return then ? x.in[0] : b.inverse(x.in[0]);
      }
      if (t != nullptr) {
        const bool then = (*t == c) == equal;
        const NodeId rest = b.binary(op, x.in[2], b.value(c));
        return then ? b.binary(Op::kOr, x.in[0], rest)
                    : b.binary(Op::kAnd, b.inverse(x.in[0]), rest);
      }
      if (o != nullptr) {
        const bool otherwise = (*o == c) == equal;
        const NodeId rest = b.binary(op, x.in[1], b.value(c));
        return otherwise ? b.binary(Op::kOr, b.inverse(x.in[0]), rest)
                         : b.binary(Op::kAnd, x.in[0], rest);
      }
      return kNone;
    }
    default: return kNone;
  }
}

// Whether x reaches a power of two: no carry chain is needed for that.
NodeId upper_bits(Rebuild& b, Op op, NodeId x, const APInt& power) {
  const unsigned low = power.logBase2();
  const NodeId upper = b.slice(x, low, b.width(x) - low);
  return b.binary(op, upper, b.zero(b.width(upper)));
}

// A comparison with a constant of up to four bits is one look-up table, and reads best whole.
bool needs_carry(const APInt& c) { return c.getBitWidth() > 4; }

// A signed comparison with a negative constant that fits a look-up table is one that Yosys maps wrongly, in all
// versions before August 2026 (its issue 6085, cmp2lut): only unsigned ones may be left.
constexpr unsigned kLargestTable = 6;  // bits; Artix-7's
bool mistaken(const APInt& c) { return c.isNegative() && c.getBitWidth() <= kLargestTable; }
NodeId sign_of(Rebuild& b, NodeId x) { return b.slice(x, b.width(x) - 1, 1); }
NodeId rest_of(Rebuild& b, NodeId x) { return b.slice(x, 0, b.width(x) - 1); }

// x < 2^k and x < -2^k, signed: the sign, and whether the bits above k are copies of it.
NodeId signed_range(Rebuild& b, NodeId x, const APInt& power, bool below) {
  const bool negative = power.isNegative();
  const unsigned low = (negative ? -power : power).logBase2(), width = b.width(x);
  const NodeId sign = sign_of(b, x), upper = b.slice(x, low, width - 1 - low);
  const NodeId copies = b.value(negative ? APInt::getAllOnes(b.width(upper))
                                         : APInt::getZero(b.width(upper)));
  // Not below 2^k: positive, and some bit set.  Below -2^k: negative, and some bit clear.
  if (below == negative)
    return b.binary(Op::kAnd, negative ? sign : b.inverse(sign),
                    b.binary(Op::kNe, upper, copies));
  return b.binary(Op::kOr, negative ? b.inverse(sign) : sign, b.binary(Op::kEq, upper, copies));
}

// x < c or x <= c
NodeId below_constant(Rebuild& b, const Node& n, NodeId x, const APInt& c) {
  const bool is_signed = n.op == Op::kSlt || n.op == Op::kSle;
  const bool strict = n.op == Op::kUlt || n.op == Op::kSlt;
  const APInt least = is_signed ? APInt::getSignedMinValue(c.getBitWidth())
                                : APInt::getMinValue(c.getBitWidth());
  const APInt most = is_signed ? APInt::getSignedMaxValue(c.getBitWidth())
                               : APInt::getMaxValue(c.getBitWidth());
  if (!strict) {
    if (c == most) return truth(b, true);
    return b.binary(is_signed ? Op::kSlt : Op::kUlt, x, b.value(c + 1));
  }
  if (c == least) return truth(b, false);
  if (c == least + 1) return b.binary(Op::kEq, x, b.value(least));
  if (c == most) return b.binary(Op::kNe, x, b.value(most));
  if (is_signed && c.isZero()) return sign_of(b, x);
  if (!is_signed && c.isPowerOf2()) return upper_bits(b, Op::kEq, x, c);
  if (is_signed && mistaken(c)) {
    const NodeId rest = b.value(c.trunc(c.getBitWidth() - 1));
    return b.binary(Op::kAnd, sign_of(b, x), b.binary(Op::kUlt, rest_of(b, x), rest));
  }
  if (!needs_carry(c)) return kNone;
  if (is_signed && (c.isPowerOf2() || c.isNegatedPowerOf2())) return signed_range(b, x, c, true);
  if (const unsigned low = c.countTrailingZeros(); low > 0)
    return b.binary(n.op, b.slice(x, low, b.width(x) - low),
                    b.value(c.extractBits(b.width(x) - low, low)));
  return kNone;
}

// c < x or c <= x
NodeId above_constant(Rebuild& b, const Node& n, NodeId x, const APInt& c) {
  const bool is_signed = n.op == Op::kSlt || n.op == Op::kSle;
  const bool strict = n.op == Op::kUlt || n.op == Op::kSlt;
  const APInt least = is_signed ? APInt::getSignedMinValue(c.getBitWidth())
                                : APInt::getMinValue(c.getBitWidth());
  const APInt most = is_signed ? APInt::getSignedMaxValue(c.getBitWidth())
                               : APInt::getMaxValue(c.getBitWidth());
  if (!strict) {
    if (c == least) return truth(b, true);
    return b.binary(is_signed ? Op::kSlt : Op::kUlt, b.value(c - 1), x);
  }
  if (c == most) return truth(b, false);
  if (c == most - 1) return b.binary(Op::kEq, x, b.value(most));
  if (c == least) return b.binary(Op::kNe, x, b.value(least));
  if (is_signed && c.isAllOnes()) return b.inverse(sign_of(b, x));
  if (!is_signed && (c + 1).isPowerOf2()) return upper_bits(b, Op::kNe, x, c + 1);
  if (is_signed && mistaken(c)) {
    const NodeId rest = b.value(c.trunc(c.getBitWidth() - 1));
    return b.binary(Op::kOr, b.inverse(sign_of(b, x)), b.binary(Op::kUlt, rest, rest_of(b, x)));
  }
  if (!needs_carry(c)) return kNone;
  if (is_signed && ((c + 1).isPowerOf2() || (c + 1).isNegatedPowerOf2()))
    return signed_range(b, x, c + 1, false);
  if (const unsigned low = c.countTrailingOnes(); low > 0)
    return b.binary(n.op, b.value(c.extractBits(b.width(x) - low, low)),
                    b.slice(x, low, b.width(x) - low));
  return kNone;
}

NodeId compare(Rebuild& b, const Node& n) {
  if (n.op == Op::kNot && n.width == 1) return inverted(b, n);
  if (n.op < Op::kEq || n.op > Op::kSle || b.width(n.in[0]) == 0) return kNone;
  const APInt *left = b.constant(n.in[0]), *right = b.constant(n.in[1]);
  if (left != nullptr && right != nullptr) return kNone;  // folded elsewhere
  if (n.op == Op::kEq || n.op == Op::kNe) {
    if (right != nullptr) return equal_to_constant(b, n.in[0], APInt(*right), n.op == Op::kEq);
    return kNone;
  }
  if (b.width(n.in[0]) == 1) return kNone;  // logic, made so elsewhere
  if (right != nullptr) return below_constant(b, n, n.in[0], APInt(*right));
  if (left != nullptr) return above_constant(b, n, n.in[1], APInt(*left));
  return kNone;
}

}  // namespace

bool simplify_compares(Module& module) { return rewrite(module, compare); }

}  // namespace hlsgen
