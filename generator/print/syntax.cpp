#include "generator/print/syntax.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace hlsgen::syntax {

bool operator==(const Expr& a, const Expr& b) {
  return a.kind == b.kind && a.width == b.width && a.text == b.text && a.high == b.high &&
         a.low == b.low && a.count == b.count && a.operands == b.operands &&
         (a.kind != Expr::Kind::kLiteral || a.value == b.value);
}

Expr name(std::string text, unsigned width) {
  Expr e;
  e.kind = Expr::Kind::kName;
  e.width = width;
  e.text = std::move(text);
  return e;
}

Expr literal(llvm::APInt value, Expr::Base base) {
  Expr e;
  e.width = value.getBitWidth();
  e.value = std::move(value);
  e.base = base;
  return e;
}

Expr select(const Expr& signal, unsigned high, unsigned low) {
  const bool nested = signal.is(Expr::Kind::kSelect);
  const unsigned declared = nested ? signal.declared_width : signal.width;
  if (high - low + 1 == signal.width) return signal;
  Expr e;
  e.kind = Expr::Kind::kSelect;
  e.width = high - low + 1;
  e.text = signal.text;
  e.high = high + (nested ? signal.low : 0);
  e.low = low + (nested ? signal.low : 0);
  e.declared_width = declared;
  return e;
}

Expr concat(std::vector<Expr> parts) {
  if (parts.size() == 1) return std::move(parts[0]);
  Expr e;
  e.kind = Expr::Kind::kConcat;
  e.width = 0;
  for (const Expr& p : parts) e.width += p.width;
  e.operands = std::move(parts);
  return e;
}

Expr replicate(unsigned count, Expr inner) {
  if (count == 1) return inner;
  Expr e;
  e.kind = Expr::Kind::kReplicate;
  e.width = count * inner.width;
  e.count = count;
  e.operands.push_back(std::move(inner));
  return e;
}

Expr unary(std::string op, Expr inner, unsigned width) {
  Expr e;
  e.kind = Expr::Kind::kUnary;
  e.width = width;
  e.text = std::move(op);
  e.operands.push_back(std::move(inner));
  return e;
}

Expr binary(std::string op, Expr a, Expr b, unsigned width) {
  Expr e;
  e.kind = Expr::Kind::kBinary;
  e.width = width;
  e.text = std::move(op);
  e.operands.push_back(std::move(a));
  e.operands.push_back(std::move(b));
  return e;
}

Expr conditional(Expr condition, Expr then, Expr otherwise) {
  Expr e;
  e.kind = Expr::Kind::kConditional;
  e.width = then.width;
  e.operands.push_back(std::move(condition));
  e.operands.push_back(std::move(then));
  e.operands.push_back(std::move(otherwise));
  return e;
}

bool is_signed(const Expr& e) {
  const auto all = [&](std::size_t from) {
    return std::all_of(e.operands.begin() + static_cast<std::ptrdiff_t>(from), e.operands.end(), is_signed);
  };
  constexpr std::array<std::string_view, 9> kBits = {"!", "==", "!=", "<", "<=", ">", ">=", "&&", "||"};
  switch (e.kind) {
    case Expr::Kind::kName: return e.declared_signed;
    case Expr::Kind::kLiteral: return e.base == Expr::Base::kSignedDecimal || e.base == Expr::Base::kSignedHex;
    case Expr::Kind::kSigned: return e.text.empty();
    case Expr::Kind::kUnary:
    case Expr::Kind::kBinary:
      if (std::find(kBits.begin(), kBits.end(), e.text) != kBits.end()) return false;
      return e.text == "<<" || e.text == ">>" || e.text == ">>>" ? is_signed(e.operands[0]) : all(0);
    case Expr::Kind::kConditional: return all(1);
    default: return false;
  }
}

namespace {

Expr cast(Expr inner, std::string to) {
  Expr e;
  e.kind = Expr::Kind::kSigned;
  e.width = inner.width;
  e.text = std::move(to);
  e.operands.push_back(std::move(inner));
  return e;
}

}  // namespace

Expr as_signed(Expr inner) {
  if (inner.is(Expr::Kind::kName) && inner.declared_signed) return inner;
  return cast(std::move(inner), "");
}

Expr as_unsigned(Expr inner) { return is_signed(inner) ? cast(std::move(inner), "$unsigned") : inner; }

}  // namespace hlsgen::syntax
