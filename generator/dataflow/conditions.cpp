#include "generator/dataflow/conditions.hpp"

namespace hlsgen {

Conditions::Conditions(const Module& module)
    : module_(module), users_(module.nodes.size()), known_(module.nodes.size(), Known::kNo) {
  for (NodeId id = 0; id < module.nodes.size(); ++id) {
    const Node& node = module.nodes[id];
    if (node.width != 1) continue;
    if (node.op == Op::kConstant) known_[id] = node.value.isZero() ? Known::kFalse : Known::kTrue;
    for (const NodeId in : node.in) users_[in].push_back(id);
  }
}

bool Conditions::assume(NodeId condition, bool holds) {
  found_.assign(1, {condition, holds});
  while (!found_.empty()) {
    const auto [id, value] = found_.back();
    found_.pop_back();
    if (knows(id, value)) continue;
    if (knows(id, !value)) return false;
    known_[id] = value ? Known::kTrue : Known::kFalse;
    trail_.push_back(id);
    infer(id);
    for (const NodeId user : users_[id]) infer(user);
  }
  return true;
}

void Conditions::back_to(std::size_t mark) {
  for (; trail_.size() > mark; trail_.pop_back()) known_[trail_.back()] = Known::kNo;
}

// One step around a node: from its operands, and from itself to them.
void Conditions::infer(NodeId id) {
  const Node& node = module_.nodes[id];
  switch (node.op) {
    case Op::kNot:
      for (const bool holds : {false, true}) {
        if (knows(id, holds)) found_.push_back({node.in[0], !holds});
        if (knows(node.in[0], holds)) found_.push_back({id, !holds});
      }
      break;
    case Op::kAnd:
      infer_logic(id, false);
      break;
    case Op::kOr:
      infer_logic(id, true);
      break;
    case Op::kMux:
      infer_choice(id);
      break;
    case Op::kEq:
      if (knows(id, true)) exclude_others(id);
      break;
    default:
      break;
  }
}

// `absorbing` is the operand that decides alone: 0 in a && b, 1 in a || b.
void Conditions::infer_logic(NodeId id, bool absorbing) {
  const auto& in = module_.nodes[id].in;
  for (int i = 0; i < 2; ++i) {
    const NodeId one = in[i];
    const NodeId other = in[1 - i];
    if (knows(one, absorbing)) found_.push_back({id, absorbing});
    if (knows(id, !absorbing)) found_.push_back({one, !absorbing});
    if (!knows(one, !absorbing)) continue;
    if (knows(other, !absorbing)) found_.push_back({id, !absorbing});
    if (knows(id, absorbing)) found_.push_back({other, absorbing});
  }
}

void Conditions::infer_choice(NodeId id) {
  const auto& in = module_.nodes[id].in;
  for (const bool chosen : {true, false}) {
    if (!knows(in[0], chosen)) continue;
    const NodeId arm = in[chosen ? 1 : 2];
    for (const bool holds : {false, true}) {
      if (knows(id, holds)) found_.push_back({arm, holds});
      if (knows(arm, holds)) found_.push_back({id, holds});
    }
  }
}

// x == 2: it is no other constant.  Nodes are shared: another equality has another constant.
void Conditions::exclude_others(NodeId equality) {
  const auto& in = module_.nodes[equality].in;
  if (module_.nodes[in[1]].op != Op::kConstant) return;
  for (const NodeId user : users_[in[0]]) {
    const Node& other = module_.nodes[user];
    if (user == equality || other.op != Op::kEq || other.in[0] != in[0]) continue;
    if (module_.nodes[other.in[1]].op == Op::kConstant) found_.push_back({user, false});
  }
}

}  // namespace hlsgen
