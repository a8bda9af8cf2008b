// Bits that nothing reads; see legalise.hpp.

#include "generator/print/legalise.hpp"
#include "generator/print/prettify.hpp"

#include <map>

namespace hlsgen {
namespace {

using syntax::Expr;

class Readers {
 public:
  void declare(const std::string& name, unsigned width) {
    order_.push_back(name);
    read_.emplace(name, llvm::APInt(width, 0));
  }

  void visit(const Expr& e) {
    if (e.is(Expr::Kind::kName)) {
      const auto found = read_.find(e.text);
      if (found != read_.end()) found->second.setAllBits();
    }
    if (e.is(Expr::Kind::kSelect)) {
      const auto found = read_.find(e.text);
      if (found != read_.end()) found->second.setBits(e.low, e.high + 1);
    }
    for (const Expr& operand : e.operands) visit(operand);
  }

  std::vector<Expr> unread() const {
    std::vector<Expr> out;
    for (const std::string& name : order_) {
      const llvm::APInt& bits = read_.at(name);
      const unsigned width = bits.getBitWidth();
      for (unsigned low = 0; low < width;) {
        if (bits[low]) {
          ++low;
          continue;
        }
        unsigned high = low;
        while (high + 1 < width && !bits[high + 1]) ++high;
        out.push_back(syntax::select(syntax::name(name, width), high, low));
        low = high + 1;
      }
    }
    return out;
  }

 private:
  std::vector<std::string> order_;
  std::map<std::string, llvm::APInt> read_;
};

}  // namespace

std::vector<Expr> find_unused(const syntax::Text& text) {
  Readers readers;
  for (const syntax::Signal& s : text.parameters) readers.declare(s.name, s.width);
  for (const syntax::Signal& s : text.inputs) readers.declare(s.name, s.width);
  for (const syntax::Signal& s : text.registers) readers.declare(s.name, s.width);
  for (const syntax::Item& item : text.items) {
    if (const auto* wire = std::get_if<syntax::Wire>(&item)) readers.declare(wire->name, wire->width);
    if (const auto* c = std::get_if<syntax::Case>(&item))
      for (const auto& t : c->targets) readers.declare(t.name, t.width);
    if (const auto* cell = std::get_if<syntax::Cell>(&item))
      for (const auto& o : cell->outputs)
        if (o.wire.find("unused") == std::string::npos) readers.declare(o.wire, o.width);
  }
  for_each_expression(text, [&](const Expr& e) { readers.visit(e); });
  return readers.unread();
}

}  // namespace hlsgen
