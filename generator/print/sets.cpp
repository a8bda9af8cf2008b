#include "generator/print/sets.hpp"

namespace hlsgen {

std::vector<int> sets_of(const Module& m) {
  std::vector<int> set(m.nodes.size(), -1);
  for (NodeId id = 0; id < m.nodes.size(); ++id) {
    const Node& n = m.nodes[id];
    if (n.op == Op::kInput) set[id] = m.inputs[n.index].set_of;
    if (n.op == Op::kRegister) set[id] = m.registers[n.index].leaf.set_of;
  }
  const auto goes = [&set](NodeId id, int to) {
    if (set[id] < 0) set[id] = to;
  };
  for (const Register& r : m.registers) goes(r.next, r.leaf.set_of);
  for (const Output& o : m.outputs) goes(o.value, o.leaf.set_of);
  for (NodeId id = static_cast<NodeId>(m.nodes.size()); id-- > 0;) {
    const Node& n = m.nodes[id];
    if (set[id] < 0) continue;
    if (n.op == Op::kOr || n.op == Op::kAnd || n.op == Op::kZext || n.op == Op::kNot)
      for (const NodeId operand : n.in) goes(operand, set[id]);
    if (n.op == Op::kMux) goes(n.in[1], set[id]), goes(n.in[2], set[id]);
    if (n.op == Op::kConcat) goes(n.in.back(), set[id]);
  }
  return set;
}

}  // namespace hlsgen
