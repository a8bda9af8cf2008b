#include "generator/print/write_expression.hpp"

#include <fmt/format.h>
#include <llvm/ADT/SmallString.h>

#include <algorithm>
#include <array>
#include <cctype>

namespace hlsgen {
namespace {

using syntax::Expr;
using Kind = Expr::Kind;

enum class Family { kProduct, kSum, kShift, kComparison, kBitwise, kLogical };

Family family(const std::string& op) {
  if (op == "*") return Family::kProduct;
  if (op == "+" || op == "-") return Family::kSum;
  if (op == "<<" || op == ">>" || op == ">>>") return Family::kShift;
  if (op == "&" || op == "|" || op == "^") return Family::kBitwise;
  if (op == "&&" || op == "||") return Family::kLogical;
  return Family::kComparison;
}

// Where a reader would have to recall a table of precedence, parentheses stay.
bool reads_without_parentheses(const Expr& parent, const Expr& child, bool right) {
  const Family p = family(parent.text), c = family(child.text);
  switch (p) {
    case Family::kSum: return c == Family::kProduct || (c == Family::kSum && !right);
    case Family::kComparison: return c == Family::kProduct || c == Family::kSum;
    case Family::kLogical: return c == Family::kComparison || parent.text == child.text;
    case Family::kBitwise: return parent.text == child.text;
    case Family::kProduct: case Family::kShift: return false;
  }
  return false;
}

bool needs_parentheses(const Expr& parent, const Expr& child, std::size_t position) {
  if (child.is(Kind::kConditional))
    return !(parent.is(Kind::kConditional) && position == 2) && !parent.is(Kind::kConcat) &&
           !parent.is(Kind::kSigned);
  switch (parent.kind) {
    case Kind::kUnary: return child.is(Kind::kBinary) || child.is(Kind::kUnary);
    case Kind::kBinary:
      if (child.is(Kind::kUnary)) return child.text == "-";
      return child.is(Kind::kBinary) && !reads_without_parentheses(parent, child, position == 1);
    case Kind::kConditional: return position == 0 && child.is(Kind::kBinary);
    default: return false;
  }
}

std::string digits(const llvm::APInt& value, unsigned radix) {
  llvm::SmallString<48> s;
  value.toString(s, radix, /*Signed=*/false, /*formatAsCLiteral=*/false);
  std::string out(s.str());
  for (char& c : out) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return out;
}

std::string write_literal(const Expr& e) {
  if (e.base == Expr::Base::kSignedDecimal) {
    const bool negative = e.value.isNegative();
    return fmt::format("{}{}'sd{}", negative ? "-" : "", e.width,
                       digits(negative ? -e.value : e.value, 10));
  }
  if (e.base == Expr::Base::kSignedHex)
    return fmt::format("{}'sh{}", e.width, digits(e.value, 16));
  if (e.width == 1) return e.value.isZero() ? "1'b0" : "1'b1";
  if (e.base == Expr::Base::kHex || e.value.getActiveBits() > 32)
    return fmt::format("{}'h{}", e.width, digits(e.value, 16));
  return fmt::format("{}'d{}", e.width, digits(e.value, 10));
}

class Layout {
 public:
  Layout(bool wrap, unsigned indent) : wrap_(wrap), indent_(indent) {}

  std::string write(const Expr& e, unsigned column) const {
    switch (e.kind) {
      case Kind::kName: return e.text;
      case Kind::kLiteral: return write_literal(e);
      case Kind::kSelect:
        return !e.index.empty() ? fmt::format("{}[{}]", e.text, e.index)
               : e.high == e.low ? fmt::format("{}[{}]", e.text, e.low)
                               : fmt::format("{}[{}:{}]", e.text, e.high, e.low);
      case Kind::kReplicate:
        return fmt::format("{{{}{{{}}}}}", e.count, write_flat(e.operands[0]));
      case Kind::kSigned: return (e.text.empty() ? "$signed" : e.text) + "(" + write_flat(e.operands[0]) + ")";
      case Kind::kUnary: return e.text + part(e, 0, column);
      case Kind::kConcat: return concat(e, column);
      case Kind::kBinary: return join(part(e, 0, column) + " " + e.text, e, 1, column);
      case Kind::kConditional: return conditional(e, column);
    }
    return "";
  }

 private:
  static unsigned after(const std::string& text, unsigned column) {
    const std::size_t line = text.rfind('\n');
    return line == std::string::npos ? column + text.size() : text.size() - line - 1;
  }
  std::string new_line() const { return "\n" + std::string(indent_, ' '); }

  std::string part(const Expr& e, std::size_t i, unsigned column) const {
    const std::string text = write(e.operands[i], column);
    return needs_parentheses(e, e.operands[i], i) ? "(" + text + ")" : text;
  }
  // The operand behind `left`: on the same line if all of it fits there, else on one of its own.
  std::string join(const std::string& left, const Expr& e, std::size_t i, unsigned column) const {
    const std::string flat = Layout(false, 0).part(e, i, 0);
    constexpr unsigned kCloser = 3;  // what may follow: ") ;" or an operator
    if (!wrap_ || after(left, column) + 1 + flat.size() + kCloser <= kColumns)
      return left + " " + flat;
    return left + new_line() + part(e, i, indent_);
  }

  std::string concat(const Expr& e, unsigned column) const {
    std::string out = "{" + part(e, 0, column + 1);
    for (std::size_t i = 1; i < e.operands.size(); ++i) out = join(out + ",", e, i, column);
    return out + "}";
  }

  // c ? x :
  // d ? y :
  // z
  std::string conditional(const Expr& e, unsigned column, bool inside_chain = false) const {
    const std::string head = join(part(e, 0, column) + " ?", e, 1, column) + " :";
    const Expr& otherwise = e.operands[2];
    if (wrap_ && otherwise.is(Kind::kConditional))
      return head + new_line() + conditional(otherwise, indent_, true);
    if (wrap_ && inside_chain) return head + new_line() + part(e, 2, indent_);
    return join(head, e, 2, column);
  }

  bool wrap_;
  unsigned indent_;
};

}  // namespace

std::string write_flat(const Expr& e) { return Layout(false, 0).write(e, 0); }

std::string write_wrapped(const Expr& e, unsigned column, unsigned indent) {
  const bool chain = e.is(Kind::kConditional) && e.operands[2].is(Kind::kConditional);
  std::string flat = write_flat(e);
  if (!chain && column + flat.size() + 1 <= kColumns) return flat;
  return Layout(true, indent).write(e, column);
}

std::string write_assignment(unsigned indent, const std::string& head, const Expr& value,
                             const std::string& comment) {
  const std::string start(indent, ' ');
  const bool chain = value.is(Kind::kConditional) && value.operands[2].is(Kind::kConditional);
  const std::string note = write_comment(comment);
  std::string flat = write_flat(value);
  // x <= (a <= b): the two arrows should not be mistaken for each other.
  if (value.is_operator("<=") && head.ends_with("<=")) flat = "(" + flat + ")";
  const std::string line = start + head + " " + flat + ";";
  if (!chain && line.size() <= kColumns)
    return line + (line.size() + note.size() <= kColumns ? note : "") + "\n";
  const unsigned deeper = indent + 4;
  return start + head + note + "\n" + std::string(deeper, ' ') +
         write_wrapped(value, deeper, deeper) + ";\n";
}

std::string write_range(unsigned width) {
  return width == 1 ? "" : fmt::format("[{}:0] ", width - 1);
}

std::string disarm(const std::string& text) {
  std::string clean;
  for (const char c : text) clean += std::isprint(static_cast<unsigned char>(c)) != 0 ? c : ' ';
  const std::size_t begin = clean.find_first_not_of(' ');
  if (begin == std::string::npos) return "";
  std::string lower = clean.substr(begin, 12);
  for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  constexpr std::array<const char*, 6> kDirectives = {"verilator", "synopsys", "synthesis",
                                                      "pragma", "verilint", "translate_"};
  for (const char* word : kDirectives)
    if (lower.rfind(word, 0) == 0) clean.insert(begin, "C++: ");
  return clean;
}

std::string write_comment(const std::string& text) {
  const std::string clean = disarm(text);
  const std::size_t begin = clean.find_first_not_of(' ');
  return begin == std::string::npos ? "" : "  // " + clean.substr(begin);
}

}  // namespace hlsgen
