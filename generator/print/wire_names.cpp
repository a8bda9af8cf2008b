#include "generator/print/wire_names.hpp"

#include <optional>

#include "generator/names.hpp"
#include "generator/print/sets.hpp"
#include "generator/print/spoken_names.hpp"

namespace hlsgen {
namespace {

std::string noun(Op op) {
  switch (op) {
    case Op::kAdd: return "sum";
    case Op::kSub: return "difference";
    case Op::kMul: return "product";
    case Op::kAnd: return "both";
    case Op::kOr: return "either";
    case Op::kXor: return "differ";
    case Op::kNot: return "inverse";
    case Op::kShl: case Op::kLshr: case Op::kAshr: return "shifted";
    case Op::kEq: return "equal";
    case Op::kNe: return "unequal";
    case Op::kUlt: case Op::kSlt: return "below";
    case Op::kUle: case Op::kSle: return "at_most";
    case Op::kMux: return "choice";
    case Op::kSlice: return "part";
    case Op::kConcat: return "joined";
    case Op::kZext: case Op::kSext: return "wide";
    case Op::kTable: return "entry";
    default: return "value";
  }
}

// The one named thing that a value is for, of all that read it; empty where there are several.
class Purposes {
 public:
  Purposes(const Module& m, const std::vector<std::string>& own) : own_(own), of_(m.nodes.size()) {
    for (const Register& r : m.registers) reads(r.next, flat_name(r.leaf.name));
    for (const Output& o : m.outputs) reads(o.value, flat_name(o.leaf.name));
    for (const Instance& i : m.instances)
      for (const NodeId input : i.inputs) reads(input, flat_name(i.name));
    for (NodeId id = static_cast<NodeId>(m.nodes.size()); id-- > 0;) {
      const std::string& name = own_[id].empty() ? of_[id].value_or("") : own_[id];
      if (own_[id].empty() && !of_[id]) continue;  // nobody reads it
      for (const NodeId operand : m.nodes[id].in) reads(operand, name);
    }
  }

  std::string of(NodeId id) const { return of_[id].value_or(""); }

 private:
  void reads(NodeId id, const std::string& purpose) {
    if (!of_[id]) of_[id] = purpose;
    else if (*of_[id] != purpose) of_[id] = "";
  }

  const std::vector<std::string>& own_;
  std::vector<std::optional<std::string>> of_;
};

// What is extended or inverted has a name.
std::string operand_name(const Module& m, const std::vector<std::string>& wanted, NodeId id) {
  const Node& n = m.nodes[id];
  if (n.op != Op::kZext && n.op != Op::kSext && n.op != Op::kNot) return {};
  const Node& operand = m.nodes[n.in[0]];
  if (operand.op == Op::kInput) return flat_name(m.inputs[operand.index].name);
  if (operand.op == Op::kRegister) return flat_name(m.registers[operand.index].leaf.name);
  return wanted[n.in[0]];
}

// Its own name, or else the first one among its operands, which come before it.
std::string root_name(const Module& m, const std::vector<std::string>& wanted, const std::vector<std::string>& root, NodeId id) {
  const Node& n = m.nodes[id];
  if (n.op == Op::kInput) return flat_name(m.inputs[n.index].name);
  if (n.op == Op::kRegister) return flat_name(m.registers[n.index].leaf.name);
  if (!wanted[id].empty()) return wanted[id];
  for (const NodeId operand : n.in) {
    if (!root[operand].empty()) return root[operand];
  }
  return {};
}

}  // namespace

std::vector<std::string> wire_names(const Module& m, const Plan& plan, FixedNames& names,
                                    const std::vector<std::vector<std::string>>& instance_outputs) {
  std::vector<std::string> wanted(m.nodes.size());
  for (NodeId id = 0; id < m.nodes.size(); ++id) {
    const Node& n = m.nodes[id];
    wanted[id] = !n.name.empty() ? n.name : n.returned ? n.function : "";
  }
  for (std::size_t o = m.outputs.size(); o-- > 0;) {
    const std::string name = flat_name(m.outputs[o].leaf.name);
    if (m.nodes[m.outputs[o].value].name.empty() && names.pool.is_free(name))
      wanted[m.outputs[o].value] = name;
  }
  for (std::size_t r = m.registers.size(); r-- > 0;)
    wanted[m.registers[r].next] = names.registers[r] + "_next";
  for (NodeId id = 0; id < m.nodes.size(); ++id) {  // a bit whose inverse has a name
    const Node& n = m.nodes[id];
    if (n.op == Op::kNot && n.width == 1 && !n.name.empty() && wanted[n.in[0]].empty()) wanted[n.in[0]] = inverted(n.name);
    if (wanted[id].empty() && n.hint[0] != '_') wanted[id] = n.hint;
  }
  const Purposes purposes(m, wanted);
  const std::vector<int> sets = sets_of(m);
  const std::vector<std::string> known = wanted;  // without those that are made here
  const SpokenNames spoken(m, plan, sets, [&](NodeId id) -> std::string {
    const Node& n = m.nodes[id];
    if (n.op == Op::kInput) return flat_name(m.inputs[n.index].name);
    if (n.op == Op::kRegister) return flat_name(m.registers[n.index].leaf.name);
    if (n.op == Op::kInstanceOutput) return instance_outputs[n.index][n.port];
    return known[id];
  });

  std::vector<std::string> result(m.nodes.size());
  std::vector<std::string> root(m.nodes.size());  // the first name among what a node is made from
  for (NodeId id = 0; id < m.nodes.size(); ++id) {
    const Node& n = m.nodes[id];
    root[id] = root_name(m, wanted, root, id);
    if (!plan.wire[id] || plan.uses[id] == 0) continue;
    if (wanted[id].empty()) wanted[id] = spoken.of(id);
    if (wanted[id].empty()) {
      std::string of = operand_name(m, wanted, id);
      const bool renames = !of.empty();
      if (of.empty()) of = purposes.of(id);
      if (of.empty()) of = n.function;
      if (of.empty()) of = root[id];
      const std::string member = spoken.member(id);
      const bool gathers = sets[id] >= 0 && (n.op == Op::kOr || n.op == Op::kConcat || (n.op == Op::kZext && !renames));
      const std::string what = !n.hint.empty() ? n.hint.substr(1) : !member.empty() ? member : gathers ? "so_far" : noun(n.op);
      wanted[id] = of.empty() ? what : of + "_" + what;
    }
    result[id] = names.pool.take(wanted[id]);
  }
  return result;
}

}  // namespace hlsgen
