// From nodes to expressions: legal in every tool, if not yet pretty.
//
//     zext, sext   ->  {8'd0, x}, {{8{x[7]}}, x}
//     slt          ->  $signed(a) < $signed(b)
//     mul          ->  $signed(a) * $signed({1'b0, b}), as narrow as its factors
//
// Test: tests/generator/backend_print_test.cpp

#pragma once

#include "generator/print/plan.hpp"
#include "generator/print/syntax.hpp"

#include <functional>
#include <optional>
#include <set>
#include <string>

namespace hlsgen {

class Expressions {
 public:
  // The name of a source or wire, as the module's text spells it.
  using NameOf = std::function<std::string(NodeId)>;

  // enumerators: the localparams' names, per enumeration and value.
  Expressions(const Module& module, const Plan& plan, NameOf name_of,
              std::vector<std::vector<std::string>> enumerators);

  struct Used {
    int enumeration;
    std::size_t value;
    bool operator<(const Used& o) const {
      return enumeration != o.enumeration ? enumeration < o.enumeration : value < o.value;
    }
  };

  // The value where it is used: its name if it has one.  A constant is spelled as the enumerator.
  syntax::Expr use(NodeId id, int enumeration = -1);
  // The value where it is defined.  For a product: as wide as its factors ask.
  syntax::Expr define(NodeId id, int enumeration = -1);
  // The enumerator's name if there is one; only `constant` has its localparam printed.
  std::optional<Used> find_enumerator(const llvm::APInt& value, int enumeration) const;
  syntax::Expr constant(const llvm::APInt& value, int enumeration, syntax::Expr::Base base);

  const std::set<Used>& used_enumerators() const { return used_; }
  const std::string& enumerator(const Used& u) const {
    return enumerators_[u.enumeration][u.value];
  }

 private:
  const Node& node(NodeId id) const { return module_.nodes[id]; }
  syntax::Expr compare(const Node& n);
  syntax::Expr signed_use(NodeId id);
  syntax::Expr extend(const Node& n);
  syntax::Expr slice(const Node& n);
  syntax::Expr multiply(const Node& n);

  const Module& module_;
  const Plan& plan_;
  NameOf name_of_;
  std::vector<std::vector<std::string>> enumerators_;
  std::set<Used> used_;
};

}  // namespace hlsgen
