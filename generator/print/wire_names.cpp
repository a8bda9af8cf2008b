#include "generator/print/wire_names.hpp"

#include "generator/names.hpp"

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

}  // namespace

std::vector<std::string> wire_names(const Module& m, const Plan& plan, FixedNames& names) {
  std::vector<std::string> wanted(m.nodes.size());
  for (NodeId id = 0; id < m.nodes.size(); ++id) {
    const Node& n = m.nodes[id];
    wanted[id] = !n.name.empty() ? n.name
                 : n.source.line == 0 ? noun(n.op)
                                      : noun(n.op) + "_" + std::to_string(n.source.line);
  }
  for (std::size_t o = m.outputs.size(); o-- > 0;) {
    const std::string name = flat_name(m.outputs[o].leaf.name);
    if (m.nodes[m.outputs[o].value].name.empty() && names.pool.is_free(name))
      wanted[m.outputs[o].value] = name;
  }
  for (std::size_t r = m.registers.size(); r-- > 0;)
    wanted[m.registers[r].next] = names.registers[r] + "_next";

  std::vector<std::string> result(m.nodes.size());
  for (NodeId id = 0; id < m.nodes.size(); ++id)
    if (plan.wire[id] && plan.uses[id] > 0) result[id] = names.pool.take(wanted[id]);
  return result;
}

}  // namespace hlsgen
