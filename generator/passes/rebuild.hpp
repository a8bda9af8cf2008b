// How a pass works: it walks the nodes of a module in order, looks at each with its operands already
// rewritten, and either keeps it or answers with another node that has the same value.
//
//     bool changed = rewrite(module, [](Rebuild& b, const Node& n) { ... return id or kNone; });
//
// Test: tests/generator/backend_pass_test.cpp

#pragma once

#include "generator/netlist.hpp"

#include <functional>
#include <vector>

namespace hlsgen {

class Rebuild {
 public:
  explicit Rebuild(const Module& old);

  const Node& node(NodeId id) const { return nodes_[id]; }
  unsigned width(NodeId id) const { return nodes_[id].width; }
  const llvm::APInt* constant(NodeId id) const {  // null unless it is one
    return nodes_[id].op == Op::kConstant ? &nodes_[id].value : nullptr;
  }
  bool is(NodeId id, Op op) const { return nodes_[id].op == op; }
  // Read in one place of the old module, so that replacing the reader frees it.
  bool used_once(NodeId id) const { return uses_[id] == 1; }
  bool current_used_once() const { return current_uses_ == 1; }  // the node being looked at
  const Module& module() const { return old_; }
  NodeId old_id() const { return current_; }  // of the node being looked at

  NodeId add(Node n);
  NodeId value(llvm::APInt v);
  NodeId zero(unsigned width) { return value(llvm::APInt(width, 0)); }
  NodeId binary(Op op, NodeId a, NodeId b);
  NodeId inverse(NodeId a);
  NodeId mux(NodeId condition, NodeId then, NodeId otherwise);
  NodeId slice(NodeId a, unsigned low, unsigned width);  // a itself, if that is all of it
  NodeId zext(NodeId a, unsigned width);
  NodeId sext(NodeId a, unsigned width);
  NodeId concat(std::vector<NodeId> parts);

 private:
  friend bool rewrite(Module&, const std::function<NodeId(Rebuild&, const Node&)>&);

  const Module& old_;
  std::vector<Node> nodes_;
  std::vector<unsigned> uses_;
  NodeId current_ = kNone;
  unsigned current_uses_ = 0;
};

using Rule = std::function<NodeId(Rebuild&, const Node&)>;
bool rewrite(Module& module, const Rule& rule);

// Points registers, outputs and instances to the new ids.
void remap_roots(Module& module, const std::vector<NodeId>& new_id);

}  // namespace hlsgen
