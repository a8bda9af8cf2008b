#include "generator/dataflow/reach.hpp"

#include <algorithm>

namespace hlsgen {
namespace {

constexpr unsigned kBudget = 20'000;  // nodes looked at for one; beyond, a mark counts as there

bool is_mark(const Module& module, const Node& node) {
  return node.op == Op::kInput && node.index >= module.inputs.size();
}

}  // namespace

Reach::Reach(const Module& module) : module_(module), conditions_(module) {
  for (NodeId id = 0; id < module.nodes.size(); ++id) {
    const auto& in = module.nodes[id].in;
    carries_.push_back(is_mark(module, module.nodes[id]) ||
                       std::any_of(in.begin(), in.end(), [&](NodeId i) { return carries_[i]; }));
    budget_ = kBudget;
    if (carries_[id]) carries_[id] = from(id).has_value();
  }
}

std::optional<unsigned> Reach::find() {
  std::vector<NodeId> ends;
  for (const auto& instance : module_.instances) {
    ends.insert(ends.end(), instance.inputs.begin(), instance.inputs.end());
  }
  for (const auto& output : module_.outputs) ends.push_back(output.value);
  for (const auto& reg : module_.registers) ends.push_back(reg.next);
  for (const NodeId end : ends) {
    budget_ = kBudget;
    if (const auto mark = from(end)) return mark;
  }
  return std::nullopt;
}

std::optional<unsigned> Reach::from(NodeId id) {
  if (!carries_[id]) return std::nullopt;
  const Node& node = module_.nodes[id];
  if (is_mark(module_, node) || budget_ == 0) return mark_below(id);
  --budget_;
  if (node.op == Op::kMux) {
    if (const auto mark = from(node.in[0])) return mark;
    if (const auto mark = under(node.in[0], true, node.in[1])) return mark;
    return under(node.in[0], false, node.in[2]);
  }
  if (node.width == 1 && (node.op == Op::kAnd || node.op == Op::kOr)) {
    const bool lets_through = node.op == Op::kAnd;
    if (const auto mark = under(node.in[1], lets_through, node.in[0])) return mark;
    return under(node.in[0], lets_through, node.in[1]);
  }
  for (const NodeId in : node.in) {
    if (const auto mark = from(in)) return mark;
  }
  return std::nullopt;
}

std::optional<unsigned> Reach::under(NodeId condition, bool holds, NodeId node) {
  if (!carries_[node]) return std::nullopt;
  const auto before = conditions_.mark();
  std::optional<unsigned> reached;
  if (conditions_.assume(condition, holds)) reached = from(node);
  conditions_.back_to(before);
  return reached;
}

unsigned Reach::mark_below(NodeId id) const {
  while (!is_mark(module_, module_.nodes[id])) {
    const auto& in = module_.nodes[id].in;
    id = *std::find_if(in.begin(), in.end(), [&](NodeId i) { return carries_[i]; });
  }
  return module_.nodes[id].index - static_cast<unsigned>(module_.inputs.size());
}

}  // namespace hlsgen
