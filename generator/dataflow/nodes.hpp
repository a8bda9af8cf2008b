// Makes nodes: equal ones once, operands before users, and none that a wire would do for.
//
//     mux(c, a, a)           ->  a               mux(c, 1, 0)      ->  c
//     slice(zext(x), 3, 0)   ->  slice(x, 3, 0)  mux(c, 2, x) == 2 ->  c | x == 2
//
// Larger rewriting belongs to the passes of the back end.
//
// Doc: docs/generator.md   Test: tests/generator/frontend/design_test.cpp

#pragma once

#include <map>
#include <tuple>

#include "generator/netlist.hpp"

namespace hlsgen {

class NodeBuilder {
 public:
  explicit NodeBuilder(std::vector<Node>& nodes) : nodes_(nodes) {}

  // The line and the function that new nodes get.
  void set_source(SourceLine source, std::string function = {}) {
    source_ = std::move(source);
    function_ = std::move(function);
  }
  const SourceLine& source() const { return source_; }
  const std::string& function() const { return function_; }
  // A name for a node that has none; sources (ports, registers) keep theirs.
  void name(NodeId node, const std::string& name);
  // It is what a C++ function returned.
  void returned(NodeId node, const std::string& function);
  // What to call it where it has no name and needs one; "_0_to_3" comes behind what it is for.
  void hint(NodeId node, const std::string& name);

  NodeId constant(const llvm::APInt& value);
  NodeId constant(unsigned width, std::uint64_t value) { return constant({width, value}); }
  NodeId source_node(Op op, unsigned width, unsigned index, unsigned port = 0);
  NodeId table(unsigned width, NodeId address, unsigned index);

  NodeId unary_not(NodeId a);
  NodeId binary(Op op, NodeId a, NodeId b);  // arithmetic, logic, shift
  NodeId compare(Op op, NodeId a, NodeId b);
  NodeId mux(NodeId condition, NodeId yes, NodeId no);
  NodeId slice(NodeId a, unsigned width, unsigned low);
  NodeId concat(const std::vector<NodeId>& parts);  // most significant first
  NodeId zext(NodeId a, unsigned width);
  NodeId sext(NodeId a, unsigned width);

  NodeId bit(NodeId a, unsigned i) { return slice(a, 1, i); }
  NodeId shift(Op op, NodeId a, NodeId amount);  // wires only when the amount is constant
  NodeId choice(std::vector<NodeId> list, NodeId number);  // which of the list: a tree of choices

  unsigned width(NodeId a) const { return nodes_[a].width; }
  bool is_constant(NodeId a) const { return nodes_[a].op == Op::kConstant; }
  unsigned significant(NodeId a) const;  // width without the zeros that an extension put on top
  std::uint64_t value(NodeId a) const { return nodes_[a].value.getLimitedValue(); }

 private:
  NodeId add(Op op, unsigned width, std::vector<NodeId> in, unsigned index = 0, unsigned port = 0,
             unsigned low = 0);
  bool is_value(NodeId a, std::uint64_t value) const;
  NodeId equals(NodeId a, NodeId b);
  NodeId shift_by(Op op, NodeId a, std::uint64_t amount);

  using Key = std::tuple<Op, unsigned, std::vector<NodeId>, unsigned, unsigned, unsigned>;
  std::vector<Node>& nodes_;
  std::map<Key, NodeId> known_;
  std::map<std::pair<unsigned, std::string>, NodeId> constants_;
  SourceLine source_;
  std::string function_;
};

}  // namespace hlsgen
