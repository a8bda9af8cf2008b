#include "generator/print/prettify.hpp"

#include <array>
#include <optional>

namespace hlsgen {
namespace {

using syntax::Block;
using syntax::Expr;
using syntax::Statement;
using Kind = Expr::Kind;

bool is_zero(const Expr& e) { return e.is(Kind::kLiteral) && e.value.isZero(); }

struct Opposite {
  const char *op, *negated, *mirrored;
};
constexpr std::array<Opposite, 6> kComparisons = {{{"==", "!=", "=="},
                                                   {"!=", "==", "!="},
                                                   {"<", ">=", ">"},
                                                   {"<=", ">", ">="},
                                                   {">", "<=", "<"},
                                                   {">=", "<", "<="}}};
const Opposite* comparison(const Expr& e) {
  if (e.is(Kind::kBinary))
    for (const Opposite& o : kComparisons)
      if (e.text == o.op) return &o;
  return nullptr;
}

Expr pretty_unary(Expr e) {
  Expr& inner = e.operands[0];
  if (e.text == "!") {
    if (inner.is_operator("!")) return inner.operands[0];
    if (const Opposite* o = comparison(inner)) {
      inner.text = o->negated;
      return inner;
    }
  }
  return e;
}

Expr pretty_binary(Expr e) {
  Expr &a = e.operands[0], &b = e.operands[1];
  if (const Opposite* o = comparison(e); o != nullptr && a.is(Kind::kLiteral) &&
                                         !b.is(Kind::kLiteral)) {
    e.text = o->mirrored;
    std::swap(a, b);
  }
  const bool bitwise = e.text == "&" || e.text == "|" || e.text == "^";
  for (Expr& side : e.operands)
    if (bitwise && side.is(Kind::kLiteral)) side.base = Expr::Base::kHex;
  if (e.text == "+" && b.is(Kind::kLiteral) && e.width > 1 && (-b.value).ult(b.value)) {
    e.text = "-";
    b.value = -b.value;
  }
  if (e.text == "-" && is_zero(a)) return syntax::unary("-", b, e.width);
  return e;
}

Expr pretty_conditional(Expr e) {
  Expr &condition = e.operands[0], &then = e.operands[1], &otherwise = e.operands[2];
  if (condition.is_operator("!") && !otherwise.is(Kind::kConditional)) {
    condition = Expr(condition.operands[0]);
    std::swap(then, otherwise);
  }
  return e;
}

// Two parts of a concatenation as one, if they are neighbours.
std::optional<Expr> joined(const Expr& high, const Expr& low) {
  if (high.is(Kind::kLiteral) && low.is(Kind::kLiteral))
    return syntax::literal(high.value.concat(low.value));
  if (high.is(Kind::kSelect) && low.is(Kind::kSelect) && high.text == low.text &&
      high.low == low.high + 1)
    return syntax::select(syntax::name(high.text, high.declared_width), high.high, low.low);
  return std::nullopt;
}

Expr pretty_concat(Expr e) {
  std::vector<Expr> parts;
  for (Expr& part : e.operands) {
    std::vector<Expr> inner;
    if (part.is(Kind::kConcat)) inner = std::move(part.operands);
    else inner.push_back(std::move(part));
    for (Expr& p : inner) {
      if (!parts.empty())
        if (auto both = joined(parts.back(), p)) {
          parts.back() = std::move(*both);
          continue;
        }
      parts.push_back(std::move(p));
    }
  }
  return syntax::concat(std::move(parts));
}

bool is_empty(const Block& block) { return block.locals.empty() && block.statements.empty(); }

Statement pretty_if(Statement s) {
  s.then = prettify(std::move(s.then));
  s.otherwise = prettify(std::move(s.otherwise));
  const Block& other = s.otherwise;
  const bool else_if =
      other.locals.empty() && other.statements.size() == 1 && other.statements[0].is_if();
  const bool negated = s.value.is_operator("!");
  if (is_empty(s.then) || (negated && !is_empty(other) && !else_if)) {
    s.value = negated ? Expr(s.value.operands[0]) : prettify(syntax::unary("!", s.value, 1));
    std::swap(s.then, s.otherwise);
  }
  // if (a) if (b) p;   ->   if (a && b) p;
  if (is_empty(s.otherwise) && s.then.locals.empty() && s.then.statements.size() == 1) {
    Statement& inner = s.then.statements[0];
    if (inner.is_if() && is_empty(inner.otherwise)) {
      s.value = syntax::binary("&&", std::move(s.value), std::move(inner.value), 1);
      s.then = Block(std::move(inner.then));
    }
  }
  return s;
}

Statement pretty_statement(Statement s) {
  s.value = prettify(std::move(s.value));
  for (Statement::Arm& arm : s.arms) arm.block = prettify(std::move(arm.block));
  return s.is_if() ? pretty_if(std::move(s)) : s;
}

}  // namespace

Expr prettify(Expr e) {
  for (Expr& operand : e.operands) operand = prettify(std::move(operand));
  switch (e.kind) {
    case Kind::kUnary: return pretty_unary(std::move(e));
    case Kind::kBinary: return pretty_binary(std::move(e));
    case Kind::kConditional: return pretty_conditional(std::move(e));
    case Kind::kConcat: return pretty_concat(std::move(e));
    default: return e;
  }
}

Block prettify(Block block) {
  for (syntax::Item& item : block.locals)
    for_each_in_item(item, [](Expr& e) { e = prettify(std::move(e)); });
  merge_cases(block.locals);
  for (Statement& s : block.statements) s = pretty_statement(std::move(s));
  return block;
}

void prettify(syntax::Text& text) {
  for (syntax::Item& item : text.items)
    for_each_in_item(item, [](Expr& e) { e = prettify(std::move(e)); });
  for (auto& [port, value] : text.assigns) value = prettify(std::move(value));
  text.updates = prettify(std::move(text.updates));
  merge_cases(text.items);
}

}  // namespace hlsgen
