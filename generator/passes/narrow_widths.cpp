#include "generator/passes/narrow_widths.hpp"

#include "generator/passes/demanded_bits.hpp"
#include "generator/passes/rebuild.hpp"
#include "generator/print/plan.hpp"

#include <llvm/ADT/bit.h>

#include <algorithm>

namespace hlsgen {
namespace {

using llvm::APInt;

class Narrower {
 public:
  explicit Narrower(const Module& m)
      : m_(m), known_(known_bits(m)), demanded_(demanded_bits(m, known_)),
        enumerations_(infer_enumerations(m)) {}

  NodeId operator()(Rebuild& b, const Node& n) const {
    const Known& k = known_[b.old_id()];
    const APInt& d = demanded_[b.old_id()];
    if (n.op <= Op::kInstanceOutput || d.isZero()) return kNone;
    if (d.isSubsetOf(k.bits.Zero | k.bits.One)) return b.value(k.bits.One & d);
    switch (n.op) {
      case Op::kAdd: case Op::kSub: case Op::kMul: case Op::kAnd: case Op::kOr: case Op::kXor:
      case Op::kNot: case Op::kMux: case Op::kShl: return low_bits(b, n, k, d);
      case Op::kEq: case Op::kNe: case Op::kUlt: case Op::kUle: case Op::kSlt: case Op::kSle:
        return comparison(b, n);
      case Op::kLshr: case Op::kAshr: return shift_right(b, n);
      case Op::kSext:
        if (known(b, 0).bits.isNonNegative() ||
            d.getActiveBits() <= b.width(n.in[0]))
          return b.zext(n.in[0], n.width);
        return kNone;
      case Op::kTable: return table(b, n);
      default: return kNone;
    }
  }

 private:
  const Known& known(const Rebuild& b, std::size_t operand) const {
    return known_[m_.nodes[b.old_id()].in[operand]];
  }

  // Operators of which the low bits depend on the low bits alone.
  NodeId low_bits(Rebuild& b, const Node& n, const Known& k, const APInt& d) const {
    if (const NodeId r = masked(b, n); r != kNone) return r;
    // A choice of enumerators stays one, whatever bits the enumerators have in common.
    if (n.op == Op::kMux && enumerations_[b.old_id()] >= 0 && d.isNegative()) return kNone;
    const unsigned read = d.getActiveBits(), zero = k.unsigned_width();
    // A sign can be copied upwards only if someone cares that it is right.
    const unsigned sign = d[k.signed_width() - 1] ? k.signed_width() : n.width;
    const unsigned least = std::min({read, zero, sign});
    if (least == n.width) return n.op == Op::kShl ? amount(b, n) : kNone;
    Node narrow = n;
    narrow.width = least;
    for (std::size_t i = n.op == Op::kMux ? 1 : 0; i < n.in.size(); ++i)
      if (n.op != Op::kShl || i == 0) narrow.in[i] = b.slice(n.in[i], 0, least);
    const NodeId r = b.add(std::move(narrow));
    return least == read || least == zero ? b.zext(r, n.width) : b.sext(r, n.width);
  }

  // x & (zeros, then ones, then zeros) moves bits and computes nothing; so does | where both sides
  // cannot be set at once.
  NodeId masked(Rebuild& b, const Node& n) const {
    if (n.op != Op::kAnd && n.op != Op::kOr) return kNone;
    const APInt* c = b.constant(n.in[1]);
    if (c == nullptr) return kNone;
    const APInt mask = n.op == Op::kAnd ? *c : ~*c;
    unsigned at = 0, ones = 0;
    if (!mask.isShiftedMask(at, ones) || ones == n.width) return kNone;
    const APInt fill = n.op == Op::kAnd ? APInt(n.width, 0) : *c;
    std::vector<NodeId> parts;
    const unsigned above = n.width - at - ones;
    if (above > 0) parts.push_back(b.value(fill.extractBits(above, at + ones)));
    parts.push_back(b.slice(n.in[0], at, ones));
    if (at > 0) parts.push_back(b.value(fill.extractBits(at, 0)));
    return b.concat(std::move(parts));
  }

  NodeId comparison(Rebuild& b, const Node& n) const {
    const Known &x = known(b, 0), &y = known(b, 1);
    const unsigned width = b.width(n.in[0]);
    const bool equality = n.op == Op::kEq || n.op == Op::kNe;
    const bool is_signed = n.op == Op::kSlt || n.op == Op::kSle;
    if (is_signed && x.bits.isNonNegative() && y.bits.isNonNegative())
      return b.binary(n.op == Op::kSlt ? Op::kUlt : Op::kUle, n.in[0], n.in[1]);
    for (const NodeId side : m_.nodes[b.old_id()].in)
      if (enumerations_[side] >= 0) return kNone;
    unsigned high = width, low = 0;
    if (!is_signed) high = std::max(x.unsigned_width(), y.unsigned_width());
    if (is_signed || equality)
      high = std::min(high, std::max(x.signed_width(), y.signed_width()));
    if (equality) {
      const APInt same = (x.bits.Zero & y.bits.Zero) | (x.bits.One & y.bits.One);
      low = std::min(same.countTrailingOnes(), high - 1);
    }
    if (high == width && low == 0) return kNone;
    return b.binary(n.op, b.slice(n.in[0], low, high - low), b.slice(n.in[1], low, high - low));
  }

  NodeId amount(Rebuild& b, const Node& n) const {
    const unsigned needed = known(b, 1).unsigned_width();
    if (needed >= b.width(n.in[1])) return kNone;
    return b.binary(n.op, n.in[0], b.slice(n.in[1], 0, needed));
  }

  NodeId shift_right(Rebuild& b, const Node& n) const {
    if (n.op == Op::kAshr && known(b, 0).bits.isNonNegative())
      return b.binary(Op::kLshr, n.in[0], n.in[1]);
    // What is shifted in equals what stands there already.
    const unsigned w = n.op == Op::kLshr ? known(b, 0).unsigned_width()
                                         : known(b, 0).signed_width();
    if (w < n.width) {
      const NodeId r = b.binary(n.op, b.slice(n.in[0], 0, w), n.in[1]);
      return n.op == Op::kLshr ? b.zext(r, n.width) : b.sext(r, n.width);
    }
    return amount(b, n);
  }

  NodeId table(Rebuild& b, const Node& n) const {
    const std::size_t entries = m_.tables[n.index].entries.size();
    const unsigned needed = std::max(
        1u, std::min<unsigned>(known(b, 0).unsigned_width(), llvm::bit_width(entries - 1)));
    if (needed >= b.width(n.in[0])) return kNone;
    Node narrow = n;
    narrow.name.clear();
    narrow.in[0] = b.slice(n.in[0], 0, needed);
    return b.add(std::move(narrow));
  }

  const Module& m_;
  const std::vector<Known> known_;
  const std::vector<APInt> demanded_;
  const std::vector<int> enumerations_;
};

}  // namespace

bool narrow_widths(Module& module) { return rewrite(module, Narrower(module)); }

}  // namespace hlsgen
