#include "generator/print/wire_names.hpp"

#include <optional>

#include "generator/names.hpp"
#include "generator/print/sets.hpp"
#include "generator/print/spoken_names.hpp"

namespace hlsgen {
namespace {

std::string noun(const Module& m, const Node& n) {
  switch (n.op) {
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
    case Op::kSlice: return n.low == 0 ? "low" : n.low + n.width == m.nodes[n.in[0]].width ? "top" : "part";
    case Op::kConcat: return "joined";
    case Op::kZext: case Op::kSext: return "wide";
    case Op::kTable: return "entry";
    default: return "value";
  }
}

// The one named thing that a value is for, of all that read it; empty where there are several.
class Purposes {
 public:
  Purposes(const Module& m, const std::vector<std::string>& own) : own_(own), of_(m.nodes.size()), reader_(m.nodes.size(), kNone) {
    for (const Register& r : m.registers) reads(r.next, flat_name(r.leaf.name));
    for (const Output& o : m.outputs) reads(o.value, flat_name(o.leaf.name));
    for (const Instance& i : m.instances)
      for (const NodeId input : i.inputs) reads(input, flat_name(i.name));
    for (NodeId id = static_cast<NodeId>(m.nodes.size()); id-- > 0;) {
      const std::string& name = own_[id].empty() ? of_[id].value_or("") : own_[id];
      if (own_[id].empty() && !of_[id]) continue;  // nobody reads it
      for (const NodeId operand : m.nodes[id].in) {
        reader_[operand] = of_[operand] ? kNone : id;
        reads(operand, name);
      }
    }
  }

  std::string of(NodeId id) const { return of_[id].value_or(""); }
  NodeId reader(NodeId id) const { return reader_[id]; }  // the only one, or none

 private:
  void reads(NodeId id, const std::string& purpose) {
    if (!of_[id]) of_[id] = purpose;
    else if (*of_[id] != purpose) of_[id] = "";
  }

  const std::vector<std::string>& own_;
  std::vector<std::optional<std::string>> of_;
  std::vector<NodeId> reader_;
};

// What is extended, inverted or cut has a name.
std::string operand_name(const Module& m, const std::vector<std::string>& wanted, NodeId id) {
  const Node& n = m.nodes[id];
  if (n.op != Op::kZext && n.op != Op::kSext && n.op != Op::kNot && n.op != Op::kSlice) return {};
  const Node& operand = m.nodes[n.in[0]];
  if (operand.op == Op::kInput) return flat_name(m.inputs[operand.index].name);
  if (operand.op == Op::kRegister) return flat_name(m.registers[operand.index].leaf.name);
  return wanted[n.in[0]];
}

// Several bits, extended or not.
bool gathers_bits(const Module& m, NodeId id) {
  const Node& n = m.nodes[id];
  if (n.op == Op::kZext) return gathers_bits(m, n.in[0]);
  return n.op == Op::kOr && n.width > 1;
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

// What is known of a value that has no name of its own.
struct Origin {
  std::string operand, purpose;
  NodeId reader;     // the only one, or none
  std::string root;  // the first name among what it is made from
  bool of_set;       // one bit or more of a set
};

bool extends(const Node& n) { return n.op == Op::kZext || n.op == Op::kSext; }

// What is put together by OR, of a set or bit by bit, or a term of such an OR.
bool is_gathered(const Module& m, NodeId id, const Origin& from) {
  const Node& n = m.nodes[id];
  if (!from.operand.empty()) return false;
  if (from.of_set) return n.op == Op::kOr || n.op == Op::kConcat || extends(n);
  if (from.purpose.empty()) return false;
  return gathers_bits(m, id) || (n.op == Op::kOr && from.reader != kNone && m.nodes[from.reader].op == Op::kOr);
}

std::string by_operator(const Module& m, const SpokenNames& spoken, NodeId id, const Origin& from) {
  const Node& n = m.nodes[id];
  const std::string of = !from.operand.empty() ? from.operand : !from.purpose.empty() ? from.purpose
                         : !n.function.empty() ? n.function : from.root;
  const auto with = [&](const std::string& what) { return of.empty() ? what : of + "_" + what; };
  if (!n.hint.empty()) return with(n.hint.substr(1));
  if (const std::string member = spoken.member(id); !member.empty()) return with(member);
  if (is_gathered(m, id, from)) return with("so_far");
  const std::string selector = spoken.selector(id);
  if (!selector.empty() && selector != of && of.size() + selector.size() <= kLongestName) return with("by_" + selector);
  if (extends(n)) return of.empty() ? noun(m, n) : noun(m, n) + "_" + of;
  const bool has_role = from.operand.empty() && !from.purpose.empty() && from.reader != kNone;
  const std::string role = has_role ? spoken.role(id, from.reader) : "";
  return role.empty() ? with(noun(m, n)) : of + role;
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
  std::vector<std::string> spoken_for = wanted;  // names that a name may be made of: no operator is among them
  const SpokenNames spoken(m, plan, sets, [&](NodeId id) -> std::string {
    const Node& n = m.nodes[id];
    if (n.op == Op::kInput) return flat_name(m.inputs[n.index].name);
    if (n.op == Op::kRegister) return flat_name(m.registers[n.index].leaf.name);
    if (n.op == Op::kInstanceOutput) return instance_outputs[n.index][n.port];
    return spoken_for[id];
  });

  std::vector<std::string> result(m.nodes.size());
  std::vector<std::string> root(m.nodes.size());  // the first name among what a node is made from
  for (NodeId id = 0; id < m.nodes.size(); ++id) {
    const Node& n = m.nodes[id];
    root[id] = root_name(m, wanted, root, id);
    if (!plan.wire[id] || plan.uses[id] == 0) continue;
    if (wanted[id].empty()) spoken_for[id] = wanted[id] = spoken.of(id);
    if (wanted[id].empty() && n.op == Op::kTable) wanted[id] = "entry_of_" + constant_name(m.tables[n.index].name);
    if (wanted[id].empty()) {
      const Origin from{.operand = operand_name(m, wanted, id), .purpose = purposes.of(id), .reader = purposes.reader(id),
                        .root = root[id], .of_set = sets[id] >= 0};
      wanted[id] = by_operator(m, spoken, id, from);
      if (!from.operand.empty() && wanted[id].size() <= kLongestName) spoken_for[id] = wanted[id];
    }
    result[id] = names.pool.take(wanted[id]);
  }
  return result;
}

}  // namespace hlsgen
