#include "generator/print/plan.hpp"

#include <set>

namespace hlsgen {
namespace {

// Names and literals in one expression; a reader's limit, not a tool's.
constexpr unsigned kLongest = 7;
constexpr unsigned kLongestChoice = 20;  // a ?: b : c ?: ... stands on several lines

class Planner {
 public:
  Planner(const Module& module, const Branch& clocked)
      : m_(module), clocked_(clocked), inner_(module.nodes.size(), false) {
    plan_.uses = count_uses(module, {}, &clocked);
    plan_.enumeration = infer_enumerations(module);
    plan_.wire.assign(module.nodes.size(), false);
    weight_.assign(module.nodes.size(), 1);
  }

  Plan run() {
    find_cases();
    plan_.uses = count_uses(m_, plan_.cases, &clocked_);
    find_clocked(clocked_);
    for (NodeId id = 0; id < m_.nodes.size(); ++id)
      if (plan_.uses[id] > 0) decide(id);
    for (const auto& [head, chain] : plan_.cases) {
      make_wire(chain.selector);
      for (const CaseChain::Arm& arm : chain.arms) forbid_selects(arm.value);
      forbid_selects(chain.otherwise);
    }
    return std::move(plan_);
  }

 private:
  const Node& node(NodeId id) const { return m_.nodes[id]; }

  void find_cases() {
    for (NodeId id = m_.nodes.size(); id-- > 0;) {
      if (plan_.uses[id] == 0 || node(id).op != Op::kMux || inner_[id]) continue;
      std::vector<NodeId> inner;
      auto chain = find_case(m_, plan_.uses, id, &inner);
      if (!chain) continue;
      for (const NodeId i : inner) inner_[i] = true;
      plan_.cases.emplace(id, std::move(*chain));
    }
  }

  // What registers take, and what their cases select by.
  void find_clocked(const Branch& block) {
    for (const Decision& step : block.steps) {
      if (step.arms.empty()) ++stored_[step.value];
      else if (node(step.selector).width > 1) selectors_.insert(step.selector);
      for (const Decision::Arm& arm : step.arms) find_clocked(arm.block);
    }
  }

  bool is_source(NodeId id) const {
    const Op op = node(id).op;
    return op == Op::kInput || op == Op::kRegister || op == Op::kInstanceOutput;
  }
  bool is_constant(NodeId id) const { return node(id).op == Op::kConstant; }
  bool is_atom(NodeId id) const { return is_source(id) || plan_.wire[id] || is_constant(id); }
  bool is_select(NodeId id) const { return node(id).op == Op::kSlice && !plan_.wire[id]; }

  void make_wire(NodeId id) {
    if (is_source(id) || is_constant(id)) return;
    plan_.wire[id] = true;
    weight_[id] = 1;
  }

  void decide(NodeId id) {
    const Node& n = node(id);
    if (is_source(id) || is_constant(id)) return;
    if (n.op == Op::kSlice && !is_select(n.in[0])) make_wire(n.in[0]);
    if (n.op == Op::kSext && !is_atom(n.in[0]) && !is_select(n.in[0])) make_wire(n.in[0]);
    if (n.op == Op::kTable) make_wire(n.in[0]);
    if (n.op == Op::kMul) separate_factors(n);
    if (inner_[id]) return;
    if (plan_.cases.count(id) != 0 || selectors_.count(id) != 0 || must_be_wire(n))
      return make_wire(id);
    shorten(id);
    const bool wanted = plan_.uses[id] > 1 || !n.name.empty();
    if (wanted && !is_plain(id) && !is_count(id) && !only_renames(id)) make_wire(id);
  }

  // $signed() reaches through a whole expression, so what needs it stands alone.
  static bool must_be_wire(const Node& n) {
    return n.op == Op::kMul || n.op == Op::kAshr || n.op == Op::kTable;
  }

  // A product is wider than its factors, and would have them computed that wide: a carry would show.
  void separate_factors(const Node& n) {
    for (const NodeId operand : n.in) {
      const NodeId value = factor(m_, operand).value;
      const Op op = node(value).op;
      if (op != Op::kSlice && op != Op::kConcat && op != Op::kZext && op != Op::kSext)
        make_wire(value);
    }
  }

  // So short that a name would say less.
  bool is_plain(NodeId id) const {
    const Node& n = node(id);
    switch (n.op) {
      case Op::kSlice: return true;
      case Op::kZext: case Op::kNot: return is_atom(n.in[0]) || is_select(n.in[0]);
      case Op::kEq: case Op::kNe:
        return (is_atom(n.in[0]) || is_select(n.in[0])) && is_constant(n.in[1]);
      default: return false;
    }
  }

  // A counter's step, in whatever branches it is taken: `left - 1`.
  bool is_count(NodeId id) const {
    const Node& n = node(id);
    const auto stores = stored_.find(id);
    return n.op == Op::kAdd && node(n.in[0]).op == Op::kRegister && is_constant(n.in[1]) &&
           stores != stored_.end() && stores->second == plan_.uses[id];
  }

  // Its only reader is a port or a register, which has a name already.
  bool only_renames(NodeId id) const {
    if (plan_.uses[id] != 1) return false;
    for (const Output& o : m_.outputs)
      if (o.value == id) return true;
    return stored_.count(id) != 0;
  }

  void shorten(NodeId id) {
    const Node& n = node(id);
    const bool choice = n.op == Op::kMux;
    while (true) {
      unsigned sum = 0;
      NodeId heaviest = kNone;
      for (const NodeId operand : n.in) {
        sum += weight_[operand];
        const bool fixed = is_atom(operand) || is_select(operand);
        if (!fixed && (heaviest == kNone || weight_[operand] > weight_[heaviest]))
          heaviest = operand;
      }
      weight_[id] = sum;
      const bool chain = choice && node(n.in[2]).op == Op::kMux && !plan_.wire[n.in[2]];
      if (sum <= (chain ? kLongestChoice : kLongest) || heaviest == kNone) break;
      make_wire(heaviest);
    }
    // A choice inside of anything but a choice hides; short ones may stay.
    if (choice) return;
    for (const NodeId operand : n.in)
      if (node(operand).op == Op::kMux && weight_[operand] > 3) make_wire(operand);
  }

  // Icarus 11 does not follow a select inside of always_comb.
  void forbid_selects(NodeId id) {
    if (has_select(id)) make_wire(id);
  }
  bool has_select(NodeId id) const {
    if (is_atom(id)) return false;
    if (node(id).op == Op::kSlice || node(id).op == Op::kSext) return true;
    for (const NodeId operand : node(id).in)
      if (has_select(operand)) return true;
    return false;
  }

  const Module& m_;
  const Branch& clocked_;
  std::map<NodeId, unsigned> stored_;  // in a register, and how often
  std::set<NodeId> selectors_;         // of a case
  Plan plan_;
  std::vector<bool> inner_;  // inside of a case chain, behind its head
  std::vector<unsigned> weight_;
};

}  // namespace

Plan plan(const Module& module, const Branch& clocked) { return Planner(module, clocked).run(); }

}  // namespace hlsgen
