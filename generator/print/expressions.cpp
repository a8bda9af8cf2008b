#include "generator/print/expressions.hpp"

#include "generator/backend.hpp"

#include <algorithm>

namespace hlsgen {

using syntax::Expr;

Expressions::Expressions(const Module& module, const Plan& plan, NameOf name_of,
                         std::vector<std::vector<std::string>> enumerators)
    : module_(module), plan_(plan), name_of_(std::move(name_of)),
      enumerators_(std::move(enumerators)) {}

std::optional<Expressions::Used> Expressions::find_enumerator(const llvm::APInt& value,
                                                              int enumeration) const {
  if (enumeration < 0) return std::nullopt;
  const Enumeration& e = module_.enumerations[enumeration];
  for (std::size_t i = 0; i < e.values.size(); ++i)
    if (e.width == value.getBitWidth() && llvm::APInt(e.width, e.values[i].second) == value)
      return Used{enumeration, i};
  return std::nullopt;
}

Expr Expressions::constant(const llvm::APInt& value, int enumeration, Expr::Base base) {
  const auto found = find_enumerator(value, enumeration);
  if (!found) return syntax::literal(value, base);
  used_.insert(*found);
  return syntax::name(enumerator(*found), value.getBitWidth());
}

Expr Expressions::use(NodeId id, int enumeration) {
  const Node& n = node(id);
  if (n.op == Op::kConstant) return constant(n.value, enumeration, Expr::Base::kDecimal);
  if (plan_.wire[id]) return syntax::name(name_of_(id), n.width);
  return define(id, enumeration);
}

Expr Expressions::define(NodeId id, int enumeration) {
  const Node& n = node(id);
  const auto both = [&](const char* op) {
    return syntax::binary(op, use(n.in[0]), use(n.in[1]), n.width);
  };
  const bool bit = n.width == 1;
  switch (n.op) {
    case Op::kConstant: return use(id, enumeration);
    case Op::kInput: case Op::kRegister: case Op::kInstanceOutput: {
      Expr e = syntax::name(name_of_(id), n.width);
      e.declared_signed = n.op == Op::kRegister && is_signed(module_.registers[n.index].leaf);
      return e;
    }
    case Op::kAdd: return both("+");
    case Op::kSub: return both("-");
    case Op::kMul: return multiply(n);
    case Op::kAnd: return both(bit ? "&&" : "&");
    case Op::kOr: return both(bit ? "||" : "|");
    case Op::kXor: return both("^");
    case Op::kNot: return syntax::unary(bit ? "!" : "~", use(n.in[0]), n.width);
    case Op::kShl: return both("<<");
    case Op::kLshr: return both(">>");
    case Op::kAshr:
      return syntax::binary(">>>", syntax::as_signed(use(n.in[0])), use(n.in[1]), n.width);
    case Op::kEq: case Op::kNe: case Op::kUlt: case Op::kUle: case Op::kSlt: case Op::kSle:
      return compare(n);
    case Op::kMux: {
      const int e = plan_.enumeration[id] >= 0 ? plan_.enumeration[id] : enumeration;
      return syntax::conditional(use(n.in[0]), use(n.in[1], e), use(n.in[2], e));
    }
    case Op::kSlice: return slice(n);
    case Op::kConcat: {
      std::vector<Expr> parts;
      for (const NodeId part : n.in) parts.push_back(use(part));
      return syntax::concat(std::move(parts));
    }
    case Op::kZext: case Op::kSext: return extend(n);
    case Op::kTable: break;  // a case, made by legalise
  }
  throw NetlistError("module " + module_.name + ": a table has no expression");
}

Expr Expressions::compare(const Node& n) {
  const auto make = [&](const char* op, bool is_signed) {
    if (is_signed)
      return syntax::binary(op, signed_use(n.in[0]), signed_use(n.in[1]), 1);
    const int left = plan_.enumeration[n.in[0]], right = plan_.enumeration[n.in[1]];
    Expr a = use(n.in[0], right), b = use(n.in[1], left);
    // Two signed ones would be compared as such.
    if (n.op != Op::kEq && n.op != Op::kNe && syntax::is_signed(a) && syntax::is_signed(b)) a = syntax::as_unsigned(std::move(a));
    return syntax::binary(op, std::move(a), std::move(b), 1);
  };
  switch (n.op) {
    case Op::kEq: return make("==", false);
    case Op::kNe: return make("!=", false);
    case Op::kUlt: return make("<", false);
    case Op::kUle: return make("<=", false);
    case Op::kSlt: return make("<", true);
    default: return make("<=", true);
  }
}

Expr Expressions::signed_use(NodeId id) {
  if (node(id).op == Op::kConstant)
    return syntax::literal(node(id).value, Expr::Base::kSignedDecimal);
  return syntax::as_signed(use(id));
}

Expr Expressions::slice(const Node& n) {
  const Node& value = node(n.in[0]);
  if (value.op == Op::kConstant)
    return syntax::literal(value.value.extractBits(n.width, n.low), Expr::Base::kHex);
  return syntax::select(use(n.in[0]), n.low + n.width - 1, n.low);
}

Expr Expressions::extend(const Node& n) {
  const Node& value = node(n.in[0]);
  const unsigned more = n.width - value.width;
  if (value.op == Op::kConstant)
    return syntax::literal(n.op == Op::kSext ? value.value.sext(n.width)
                                             : value.value.zext(n.width));
  const Expr inner = use(n.in[0]);
  if (more == 0) return inner;
  if (n.op == Op::kZext) return syntax::concat({syntax::literal(llvm::APInt(more, 0)), inner});
  if (value.width == 1) return syntax::replicate(n.width, inner);
  const Expr sign = syntax::select(inner, value.width - 1, value.width - 1);
  return syntax::concat({syntax::replicate(more, sign), inner});
}

Expr Expressions::multiply(const Node& n) {
  const Factor f[2] = {factor(module_, n.in[0]), factor(module_, n.in[1])};
  const bool is_signed = f[0].is_signed || f[1].is_signed;
  const bool whole = f[0].width == n.width && f[1].width == n.width;  // only the low half counts
  Expr sides[2];
  unsigned sum = 0;
  for (int i = 0; i < 2; ++i) {
    const Node& v = node(f[i].value);
    Expr& side = sides[i];
    if (v.op == Op::kConstant) {
      llvm::APInt c = f[i].is_signed ? v.value : v.value.zext(v.width + 1);
      if (whole) c = v.value;
      else c = c.trunc(is_signed ? c.getSignificantBits() : std::max(1u, c.getActiveBits()));
      // Signed as a literal, since a minus in front would be computed as wide as the product.
      const bool sign = is_signed && !whole;
      side = syntax::literal(c, sign ? Expr::Base::kSignedHex : Expr::Base::kDecimal);
    } else {
      side = use(f[i].value);
      if (is_signed && !whole) {
        if (!f[i].is_signed) side = syntax::concat({syntax::literal(llvm::APInt(1, 0)), side});
        side = syntax::as_signed(std::move(side));
      }
    }
    sum += side.width;
  }
  // Two signed ones would be extended as such.
  const bool both = syntax::is_signed(sides[0]) && syntax::is_signed(sides[1]);
  if (!is_signed && !whole && both) sides[0] = syntax::as_unsigned(std::move(sides[0]));
  return syntax::binary("*", std::move(sides[0]), std::move(sides[1]), whole ? n.width : sum);
}

}  // namespace hlsgen
