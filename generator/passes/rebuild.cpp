#include "generator/passes/rebuild.hpp"

#include "generator/print/plan.hpp"

namespace hlsgen {

Rebuild::Rebuild(const Module& old) : old_(old) { nodes_.reserve(old.nodes.size()); }

NodeId Rebuild::add(Node n) {
  nodes_.push_back(std::move(n));
  uses_.push_back(0);
  return static_cast<NodeId>(nodes_.size() - 1);
}

NodeId Rebuild::value(llvm::APInt v) {
  Node n;
  n.width = v.getBitWidth();
  n.value = std::move(v);
  return add(std::move(n));
}

NodeId Rebuild::binary(Op op, NodeId a, NodeId b) {
  Node n;
  n.op = op;
  n.width = op >= Op::kEq && op <= Op::kSle ? 1 : width(a);
  n.in = {a, b};
  return add(std::move(n));
}

NodeId Rebuild::inverse(NodeId a) {
  if (is(a, Op::kNot)) return nodes_[a].in[0];
  Node n;
  n.op = Op::kNot;
  n.width = width(a);
  n.in = {a};
  return add(std::move(n));
}

NodeId Rebuild::mux(NodeId condition, NodeId then, NodeId otherwise) {
  Node n;
  n.op = Op::kMux;
  n.width = width(then);
  n.in = {condition, then, otherwise};
  return add(std::move(n));
}

NodeId Rebuild::slice(NodeId a, unsigned low, unsigned w) {
  if (low == 0 && w == width(a)) return a;
  if (const llvm::APInt* c = constant(a)) return value(c->extractBits(w, low));
  Node n;
  n.op = Op::kSlice;
  n.width = w;
  n.low = low;
  n.in = {a};
  return add(std::move(n));
}

NodeId Rebuild::zext(NodeId a, unsigned w) {
  if (w == width(a)) return a;
  Node n;
  n.op = Op::kZext;
  n.width = w;
  n.in = {a};
  return add(std::move(n));
}

NodeId Rebuild::sext(NodeId a, unsigned w) {
  if (w == width(a)) return a;
  Node n;
  n.op = Op::kSext;
  n.width = w;
  n.in = {a};
  return add(std::move(n));
}

NodeId Rebuild::concat(std::vector<NodeId> parts) {
  if (parts.size() == 1) return parts[0];
  Node n;
  n.op = Op::kConcat;
  n.width = 0;
  for (const NodeId p : parts) n.width += width(p);
  n.in = std::move(parts);
  return add(std::move(n));
}

bool rewrite(Module& module, const Rule& rule) {
  const std::vector<unsigned> uses = count_uses(module);
  Rebuild b(module);
  std::vector<NodeId> new_id(module.nodes.size());
  bool changed = false;
  for (NodeId id = 0; id < module.nodes.size(); ++id) {
    Node n = module.nodes[id];
    for (NodeId& operand : n.in) operand = new_id[operand];
    b.current_ = id;
    b.current_uses_ = uses[id];
    const NodeId made = b.nodes_.size();
    NodeId replacement = rule(b, n);
    if (replacement == kNone) {
      replacement = b.add(std::move(n));
    } else {
      changed = true;
      // What is new takes over the name of what it stands for.
      Node& r = b.nodes_[replacement];
      if (replacement >= made && r.name.empty() && r.op != Op::kConstant) {
        r.name = n.name;
        if (n.returned) r.function = n.function;
        r.returned = n.returned;
        r.hint = n.hint;
      }
      for (NodeId i = made; i < b.nodes_.size(); ++i)
        if (b.nodes_[i].source.line == 0) {
          b.nodes_[i].source = n.source;
          b.nodes_[i].function = n.function;
        }
    }
    b.uses_[replacement] += uses[id];
    new_id[id] = replacement;
  }
  module.nodes = std::move(b.nodes_);
  remap_roots(module, new_id);
  return changed;
}

void remap_roots(Module& module, const std::vector<NodeId>& new_id) {
  for (Output& o : module.outputs) o.value = new_id[o.value];
  for (Register& r : module.registers) r.next = new_id[r.next];
  for (Instance& i : module.instances)
    for (NodeId& input : i.inputs) input = new_id[input];
}

}  // namespace hlsgen
