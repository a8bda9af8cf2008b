#include "generator/passes/known_bits.hpp"

#include <algorithm>

namespace hlsgen {
namespace {

using llvm::APInt;
using llvm::KnownBits;

KnownBits from_optional(std::optional<bool> result) {
  KnownBits k(1);
  if (result) (*result ? k.One : k.Zero).setBit(0);
  return k;
}

KnownBits concat(const Node& n, const std::vector<Known>& known) {
  KnownBits k = known[n.in[0]].bits;
  for (std::size_t i = 1; i < n.in.size(); ++i) {
    const KnownBits& low = known[n.in[i]].bits;
    KnownBits both(k.getBitWidth() + low.getBitWidth());
    both.Zero = k.Zero.concat(low.Zero);
    both.One = k.One.concat(low.One);
    k = both;
  }
  return k;
}

// A shift by an unknown amount keeps what was shifted in and what grows towards it.
KnownBits shift(const Node& n, const KnownBits& x) {
  KnownBits k(n.width);
  if (n.op == Op::kShl) k.Zero.setLowBits(x.countMinTrailingZeros());
  if (n.op == Op::kLshr || x.isNonNegative()) {
    if (n.op != Op::kShl) k.Zero.setHighBits(x.countMinLeadingZeros());
  } else if (n.op == Op::kAshr) {
    k.One.setHighBits(x.countMinLeadingOnes());
  }
  return k;
}

KnownBits table(const Table& t) {
  KnownBits k(t.width);
  k.setAllOnes();
  k.Zero.setAllBits();
  for (const APInt& e : t.entries) {
    k.One &= e;
    k.Zero &= ~e;
  }
  return k;
}

KnownBits bits_of(const Module& m, const Node& n, const std::vector<Known>& known) {
  const auto in = [&](std::size_t i) -> const KnownBits& { return known[n.in[i]].bits; };
  switch (n.op) {
    case Op::kConstant: return KnownBits::makeConstant(n.value);
    case Op::kAdd: return KnownBits::computeForAddSub(true, false, in(0), in(1));
    case Op::kSub: return KnownBits::computeForAddSub(false, false, in(0), in(1));
    case Op::kMul: return KnownBits::mul(in(0), in(1));
    case Op::kAnd: return in(0) & in(1);
    case Op::kOr: return in(0) | in(1);
    case Op::kXor: return in(0) ^ in(1);
    case Op::kNot: {
      KnownBits k = in(0);
      std::swap(k.Zero, k.One);
      return k;
    }
    case Op::kShl: case Op::kLshr: case Op::kAshr: return shift(n, in(0));
    case Op::kEq: return from_optional(KnownBits::eq(in(0), in(1)));
    case Op::kNe: return from_optional(KnownBits::ne(in(0), in(1)));
    case Op::kUlt: return from_optional(KnownBits::ult(in(0), in(1)));
    case Op::kUle: return from_optional(KnownBits::ule(in(0), in(1)));
    case Op::kSlt: return from_optional(KnownBits::slt(in(0), in(1)));
    case Op::kSle: return from_optional(KnownBits::sle(in(0), in(1)));
    case Op::kMux: return KnownBits::commonBits(in(1), in(2));
    case Op::kSlice: return in(0).extractBits(n.width, n.low);
    case Op::kConcat: return concat(n, known);
    case Op::kZext: return in(0).zext(n.width);
    case Op::kSext: return in(0).sext(n.width);
    case Op::kTable: return table(m.tables[n.index]);
    case Op::kInput: case Op::kRegister: case Op::kInstanceOutput: break;
  }
  return KnownBits(n.width);
}

unsigned table_sign_copies(const Table& t) {
  unsigned copies = t.width;
  for (const APInt& e : t.entries) copies = std::min(copies, e.getNumSignBits());
  return copies;
}

unsigned sign_copies_of(const Module& m, const Node& n, const std::vector<Known>& known) {
  const auto in = [&](std::size_t i) { return known[n.in[i]].sign_copies; };
  switch (n.op) {
    case Op::kAdd: case Op::kSub: return std::max(1u, std::min(in(0), in(1)) - 1);
    case Op::kMul: {
      const unsigned needed = (n.width - in(0) + 1) + (n.width - in(1) + 1);
      return needed > n.width ? 1 : n.width - needed + 1;
    }
    case Op::kAnd: case Op::kOr: case Op::kXor: return std::min(in(0), in(1));
    case Op::kMux: return std::min(in(1), in(2));
    case Op::kNot: case Op::kAshr: return in(0);
    case Op::kSext: return in(0) + n.width - known[n.in[0]].bits.getBitWidth();
    case Op::kConcat:
      return std::min(in(0), known[n.in[0]].bits.getBitWidth());
    case Op::kSlice: {
      const unsigned above = known[n.in[0]].bits.getBitWidth() - n.low - n.width;
      return in(0) > above ? std::min(n.width, in(0) - above) : 1;
    }
    case Op::kTable: return table_sign_copies(m.tables[n.index]);
    default: return 1;
  }
}

}  // namespace

std::vector<Known> known_bits(const Module& m) {
  std::vector<Known> known;
  known.reserve(m.nodes.size());
  for (const Node& n : m.nodes) {
    Known k{bits_of(m, n, known), sign_copies_of(m, n, known)};
    k.sign_copies = std::max(k.sign_copies, k.bits.countMinSignBits());
    known.push_back(std::move(k));
  }
  return known;
}

}  // namespace hlsgen
