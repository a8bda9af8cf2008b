#include "generator/print/bit_names.hpp"

#include "generator/print/prettify.hpp"

#include <algorithm>
#include <optional>
#include <set>

namespace hlsgen {
namespace {

using syntax::Block;
using syntax::Expr;
using syntax::Statement;
using Kind = Expr::Kind;

constexpr unsigned kMost = 5;  // bits that are asked one by one

class BitNames {
 public:
  explicit BitNames(syntax::Text& text) : text_(text) {}

  void run() {
    if (text_.sets.empty()) return;
    for_each_expression(text_, [this](Expr& e) { questions(e); });
    for (syntax::Item& item : text_.items) made(item);
    block(text_.updates);
    block(text_.resets);
    for (auto& [port, value] : text_.assigns) value_of(port, value);
    declare();
  }

 private:
  const syntax::Enumerators* names_of(const std::string& signal) const {
    const auto found = text_.sets.find(signal);
    return found == text_.sets.end() ? nullptr : &text_.enumerations[found->second];
  }

  // The localparam whose value is this bit's place.
  std::optional<Expr> name_of(const std::string& signal, unsigned bit) {
    const auto* names = names_of(signal);
    if (names == nullptr) return std::nullopt;
    for (const auto& [name, value] : *names)
      if (value.value == bit) {
        used_.insert(name);
        return syntax::name(name, value.width);
      }
    return std::nullopt;
  }

  // Whether the localparams are as wide as the place of one of these bits; linters ask for that.
  bool as_wide(const Expr& select) const {
    const auto* names = names_of(select.text);
    return names != nullptr && names->front().second.width == llvm::APInt(32, select.declared_width - 1).getActiveBits();
  }

  // What is read.
  void questions(Expr& e) {
    if (auto asked = asks_for_any(e)) e = std::move(*asked);
    for (Expr& operand : e.operands) questions(operand);
    if (!e.is(Kind::kSelect) || e.high != e.low || !as_wide(e)) return;
    if (const auto name = name_of(e.text, e.low)) e.index = name->text;
  }

  // Whether any of some bits is set, or none.
  std::optional<Expr> asks_for_any(const Expr& e) const {
    if (!e.is_operator("==") && !e.is_operator("!=")) return std::nullopt;
    if (!e.operands[1].is(Kind::kLiteral) || !e.operands[1].value.isZero()) return std::nullopt;
    const Expr& side = e.operands[0];
    const bool masked = side.is_operator("&") && side.operands[1].is(Kind::kLiteral);
    const Expr& signal = masked ? side.operands[0] : side;
    if ((!signal.is(Kind::kSelect) && !signal.is(Kind::kName)) || names_of(signal.text) == nullptr) return std::nullopt;
    const bool select = signal.is(Kind::kSelect);
    const unsigned low = select ? signal.low : 0, declared = select ? signal.declared_width : signal.width;
    const llvm::APInt mask = masked ? side.operands[1].value : llvm::APInt::getAllOnes(signal.width);
    if (mask.countPopulation() > kMost || mask.isZero()) return std::nullopt;
    std::optional<Expr> any;
    for (unsigned bit = signal.width; bit-- > 0;) {
      if (!mask[bit]) continue;
      Expr one = syntax::select(syntax::name(signal.text, declared), low + bit, low + bit);
      any = any ? syntax::binary("||", std::move(*any), std::move(one), 1) : std::move(one);
    }
    return e.text == "!=" ? std::move(*any) : syntax::unary("!", std::move(*any), 1);
  }

  // What is made: a bit alone is 1 shifted to its place.
  void value_of(const std::string& signal, Expr& e) {
    if (names_of(signal) == nullptr) return;
    if (e.is(Kind::kLiteral) && e.width > 1 && e.value.isPowerOf2()) {
      if (auto name = name_of(signal, e.value.logBase2()))
        e = syntax::binary("<<", syntax::literal(llvm::APInt(e.width, 1)), std::move(*name), e.width);
    } else if (e.is(Kind::kConditional)) {
      value_of(signal, e.operands[1]);
      value_of(signal, e.operands[2]);
    } else if (e.is_operator("|") || e.is_operator("&")) {
      for (Expr& operand : e.operands) value_of(signal, operand);
    }
  }

  void made(syntax::Item& item) {
    if (auto* wire = std::get_if<syntax::Wire>(&item)) value_of(wire->name, wire->value);
    if (auto* c = std::get_if<syntax::Case>(&item))
      for (auto& arm : c->arms)
        for (std::size_t i = 0; i < c->targets.size(); ++i) value_of(c->targets[i].name, arm.values[i]);
  }

  void block(Block& block) {
    for (syntax::Item& item : block.locals) made(item);
    for (Statement& s : block.statements) {
      if (!s.target.empty()) value_of(s.target, s.value);
      this->block(s.then);
      this->block(s.otherwise);
      for (Statement::Arm& arm : s.arms) this->block(arm.block);
    }
  }

  // Localparams in the order of their enumerations.
  void declare() {
    for (const auto& [name, value] : text_.constants) used_.insert(name);
    text_.constants.clear();
    for (const syntax::Enumerators& all : text_.enumerations)
      std::copy_if(all.begin(), all.end(), std::back_inserter(text_.constants),
                   [this](const auto& constant) { return used_.count(constant.first) != 0; });
  }

  syntax::Text& text_;
  std::set<std::string> used_;  // localparams
};

}  // namespace

void name_bits(syntax::Text& text) { BitNames(text).run(); }

}  // namespace hlsgen
