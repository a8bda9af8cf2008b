// Finding `case` in chains of muxes, and enumerations along them; see plan.hpp.

#include "generator/print/plan.hpp"

#include <algorithm>

namespace hlsgen {
namespace {

bool is_constant(const Module& m, NodeId id) { return m.nodes[id].op == Op::kConstant; }

// Collects the labels of `s == a || s == b || ...`; false if the condition is anything else.
bool collect_labels(const Module& m, NodeId condition, NodeId* selector,
                    std::vector<llvm::APInt>* labels) {
  const Node& n = m.nodes[condition];
  if (n.op == Op::kOr)
    return collect_labels(m, n.in[0], selector, labels) &&
           collect_labels(m, n.in[1], selector, labels);
  if (n.op != Op::kEq) return false;
  const bool first = is_constant(m, n.in[0]);
  const NodeId value = n.in[first ? 1 : 0];
  const NodeId constant = n.in[first ? 0 : 1];
  if (!is_constant(m, constant) || is_constant(m, value) || m.nodes[value].width == 1)
    return false;
  if (*selector != kNone && *selector != value) return false;
  *selector = value;
  labels->push_back(m.nodes[constant].value);
  return true;
}

}  // namespace

std::optional<CaseChain> find_case(const Module& m, const std::vector<unsigned>& uses, NodeId head,
                                   std::vector<NodeId>* inner) {
  CaseChain chain;
  std::vector<llvm::APInt> seen;
  NodeId at = head;
  while (m.nodes[at].op == Op::kMux && (at == head || uses[at] == 1)) {
    const Node& n = m.nodes[at];
    NodeId selector = chain.selector;
    CaseChain::Arm arm{{}, n.in[1]};
    if (!collect_labels(m, n.in[0], &selector, &arm.labels)) break;
    chain.selector = selector;
    std::vector<llvm::APInt> fresh;
    for (const llvm::APInt& label : arm.labels)
      if (std::find(seen.begin(), seen.end(), label) == seen.end()) {
        seen.push_back(label);
        fresh.push_back(label);
      }
    arm.labels = std::move(fresh);
    if (!arm.labels.empty()) chain.arms.push_back(std::move(arm));
    if (at != head) inner->push_back(at);
    at = n.in[2];
  }
  chain.otherwise = at;
  if (seen.size() < 3) {
    inner->clear();
    return std::nullopt;
  }
  return chain;
}

Factor factor(const Module& m, NodeId operand) {
  const Node& n = m.nodes[operand];
  if (n.op == Op::kZext) return {n.in[0], m.nodes[n.in[0]].width, false};
  if (n.op == Op::kSext) return {n.in[0], m.nodes[n.in[0]].width, true};
  // A constant just below 2^width is better taken as a small negative number.
  const bool small_negative = n.op == Op::kConstant && n.value.isNegative() &&
                              n.value.getSignificantBits() + 1 < n.width;
  return {operand, n.width, small_negative};
}

std::vector<unsigned> count_uses(const Module& m, const std::map<NodeId, CaseChain>& cases,
                                 const Branch* clocked) {
  std::vector<unsigned> uses(m.nodes.size(), 0);
  for (const Output& o : m.outputs) ++uses[o.value];
  if (clocked != nullptr)
    for_each_read(*clocked, [&](NodeId id, const Branch&) { ++uses[id]; });
  else
    for (const Register& r : m.registers) ++uses[r.next];
  for (const Instance& i : m.instances)
    for (const NodeId input : i.inputs) ++uses[input];
  for (NodeId id = m.nodes.size(); id-- > 0;) {
    if (uses[id] == 0) continue;
    const auto chain = cases.find(id);
    if (chain == cases.end()) {
      const bool product = m.nodes[id].op == Op::kMul;
      for (const NodeId operand : m.nodes[id].in)
        ++uses[product ? factor(m, operand).value : operand];
      continue;
    }
    ++uses[chain->second.selector];
    for (const CaseChain::Arm& arm : chain->second.arms) ++uses[arm.value];
    ++uses[chain->second.otherwise];
  }
  return uses;
}

std::vector<int> infer_enumerations(const Module& m) {
  std::vector<int> e(m.nodes.size(), -1);
  for (NodeId id = 0; id < m.nodes.size(); ++id) {
    const Node& n = m.nodes[id];
    if (n.op == Op::kInput) e[id] = m.inputs[n.index].enumeration;
    if (n.op == Op::kRegister) e[id] = m.registers[n.index].leaf.enumeration;
    if (n.op != Op::kMux) continue;
    // A mux of a state and constants is a state.
    const int a = e[n.in[1]], b = e[n.in[2]];
    if (a == b || (b < 0 && is_constant(m, n.in[2]))) e[id] = a;
    else if (a < 0 && is_constant(m, n.in[1])) e[id] = b;
  }
  // A mux of constants is what it is stored to.
  const auto sink = [&](NodeId id, int enumeration) {
    const Op op = m.nodes[id].op;
    const bool passes_on = op == Op::kMux || op == Op::kZext || op == Op::kSext;
    if (enumeration >= 0 && e[id] < 0 && passes_on) e[id] = enumeration;
  };
  for (const Output& o : m.outputs) sink(o.value, o.leaf.enumeration);
  for (const Register& r : m.registers) sink(r.next, r.leaf.enumeration);
  for (NodeId id = m.nodes.size(); id-- > 0;)
    if (m.nodes[id].op == Op::kMux && e[id] >= 0) {
      sink(m.nodes[id].in[1], e[id]);
      sink(m.nodes[id].in[2], e[id]);
    }
  return e;
}

}  // namespace hlsgen
