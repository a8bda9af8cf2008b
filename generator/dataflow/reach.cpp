#include "generator/dataflow/reach.hpp"

#include <algorithm>

namespace hlsgen {
namespace {

constexpr unsigned kBudget = 200'000;  // nodes looked at; beyond, a mark counts as reached

bool is_mark(const Module& module, const Node& node) {
  return node.op == Op::kInput && node.index >= module.inputs.size();
}

}  // namespace

Reach::Reach(const Module& module) : module_(module), budget_(kBudget) {
  for (const auto& node : module.nodes) {
    carries_.push_back(is_mark(module, node) ||
                       std::any_of(node.in.begin(), node.in.end(),
                                   [&](NodeId in) { return carries_[in]; }));
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
    if (const auto mark = from(end)) return mark;
  }
  return std::nullopt;
}

std::optional<unsigned> Reach::from(NodeId id) {
  if (!carries_[id]) return std::nullopt;
  const Node& node = module_.nodes[id];
  if (is_mark(module_, node) || budget_ == 0) {
    // Out of patience: any mark below will do.
    NodeId mark = id;
    while (!is_mark(module_, module_.nodes[mark])) {
      const auto& in = module_.nodes[mark].in;
      mark = *std::find_if(in.begin(), in.end(), [&](NodeId i) { return carries_[i]; });
    }
    return module_.nodes[mark].index - static_cast<unsigned>(module_.inputs.size());
  }
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
  const auto already = known(condition);
  if (already) return *already == holds ? from(node) : std::nullopt;
  const auto conditions = conditions_;
  const auto values = values_;
  assume(condition, holds);
  const auto mark = from(node);
  conditions_ = conditions;
  values_ = values;
  return mark;
}

std::optional<bool> Reach::known(NodeId id) const {
  const auto found = conditions_.find(id);
  if (found != conditions_.end()) return found->second;
  const Node& node = module_.nodes[id];
  if (node.op == Op::kConstant) return node.value.getBoolValue();
  if (node.op == Op::kNot) {
    const auto inner = known(node.in[0]);
    return inner ? std::optional(!*inner) : std::nullopt;
  }
  if (node.width == 1 && (node.op == Op::kAnd || node.op == Op::kOr)) {
    const bool decides = node.op == Op::kOr;
    const auto a = known(node.in[0]);
    const auto b = known(node.in[1]);
    if ((a && *a == decides) || (b && *b == decides)) return decides;
    return a && b ? std::optional(!decides) : std::nullopt;
  }
  if (node.op == Op::kEq && module_.nodes[node.in[1]].op == Op::kConstant) {
    const auto value = values_.find(node.in[0]);
    if (value != values_.end()) return value->second == module_.nodes[node.in[1]].value;
  }
  return std::nullopt;
}

void Reach::assume(NodeId id, bool holds) {
  conditions_[id] = holds;
  const Node& node = module_.nodes[id];
  if (node.op == Op::kNot) assume(node.in[0], !holds);
  if (node.width == 1 && ((node.op == Op::kAnd && holds) || (node.op == Op::kOr && !holds))) {
    assume(node.in[0], holds);
    assume(node.in[1], holds);
  }
  if (node.op == Op::kEq && holds && module_.nodes[node.in[1]].op == Op::kConstant) {
    values_.insert_or_assign(node.in[0], module_.nodes[node.in[1]].value);
  }
}

}  // namespace hlsgen
