#include "generator/print/rate.hpp"

#include <algorithm>

namespace hlsgen {
namespace {

constexpr unsigned kMostWays = 1U << 20;
constexpr double kLeastGainOfBit = 3;  // operators, where the register's value is not a choice

}  // namespace

Rater::Rater(const Module& module, Restrictor& restrictor) : m_(module), restrictor_(restrictor) {
  for (NodeId id = 0; id < m_.nodes.size(); ++id)
    if (m_.nodes[id].op == Op::kRegister) present_[id] = m_.nodes[id].index;
  for (const Output& o : m_.outputs) add_cone(o.value, free_);
  for (const Instance& i : m_.instances)
    for (const NodeId input : i.inputs) add_cone(input, free_);
}

// What has to be computed for a value, without what the module computes anyway.
void Rater::add_cone(NodeId id, Cone& cone) const {
  const Node& n = node(id);
  if (n.op == Op::kConstant || n.op == Op::kInput || n.op == Op::kRegister ||
      n.op == Op::kInstanceOutput || free_.count(id) != 0 || !cone.insert(id).second)
    return;
  for (const NodeId operand : n.in) add_cone(operand, cone);
}

bool Rater::is_simple(NodeId id) const {
  const Node& n = node(id);
  if (n.op == Op::kNot) return is_simple(n.in[0]);
  return n.op != Op::kMux && (n.width > 1 || n.in.empty());
}

Split Rater::rate(Split s, const Updates& updates, const std::vector<double>& own) {
  if (s.selector == kNone) return s;
  Cone before, condition;
  int values_more = 0;  // that would be written, as both branches name them
  add_cone(s.selector, condition);
  std::vector<Cone> cones(s.facts.size());
  for (std::size_t i = 0; i < updates.size(); ++i) {
    const Update& u = updates[i];
    const std::vector<NodeId> values = restricted(u, s);
    s.joined.push_back(joins(u, values, s, own[i]));
    if (!s.joined.back()) continue;
    add_cone(u.value, before);
    values_more -= static_cast<int>(count_values(u));
    for (std::size_t a = 0; a < values.size(); ++a) {
      add_cone(values[a], cones[a]);
      values_more += static_cast<int>(count_values({u.reg, values[a]}));
    }
  }
  s.gain = static_cast<double>(before.size()) - cost(cones, condition);
  if (values_more > 0 && cones.size() == 2) s.gain -= values_more;
  return s;
}

std::vector<NodeId> Rater::restricted(const Update& u, const Split& s) {
  std::vector<NodeId> values;
  for (const Facts& f : s.facts) values.push_back(restrictor_.restrict(f, u.value));
  return values;
}

double Rater::cost(const std::vector<Cone>& cones, const Cone& condition) {
  std::size_t sum = 0;
  for (const Cone& cone : cones)
    for (const NodeId id : cone) sum += condition.count(id) == 0 ? 1 : 0;
  return static_cast<double>(condition.size()) +
         static_cast<double>(sum) / static_cast<double>(cones.size());
}

double Rater::gain(const Update& u, const Split& s) {
  Cone before, condition, own;
  add_cone(u.value, before);
  add_cone(s.selector, condition);
  for (const NodeId id : before)
    if (condition.count(id) != 0) own.insert(id);
  std::vector<Cone> cones;
  for (const NodeId v : restricted(u, s)) {
    cones.emplace_back();
    add_cone(v, cones.back());
  }
  return static_cast<double>(before.size()) - cost(cones, own);
}

// A choice may be an arm of several: its ways count in each, but are counted once.
template <class Count>
unsigned Rater::count_ways(NodeId id, const Count& at_end, unsigned at_choice, Ways& known) const {
  const Node& n = node(id);
  if (n.op != Op::kMux) return at_end(id);
  const auto found = known.find(id);
  if (found != known.end()) return found->second;
  const unsigned ways = at_choice + count_ways(n.in[1], at_end, at_choice, known) +
                        count_ways(n.in[2], at_end, at_choice, known);
  return known[id] = std::min(ways, kMostWays);
}

// Assignments that a value takes, as ifs.
unsigned Rater::count_values(const Update& u) const {
  const auto is_stored = [&](NodeId id) {
    return node(id).op == Op::kConstant || holds({u.reg, id}) ? 0U : 1U;
  };
  Ways known;
  return count_ways(u.value, is_stored, 0, known);
}

unsigned Rater::count_choices(NodeId id) const {
  Ways known;
  return count_ways(id, [](NodeId) { return 0U; }, 1, known);
}

bool Rater::joins(const Update& u, const std::vector<NodeId>& values, const Split& s, double own) {
  if (free_.count(u.value) != 0 || std::all_of(values.begin(), values.end(),
                                               [&](NodeId v) { return v == u.value; }))
    return false;
  const bool choice = is_choice(u.value);
  if (choice && without_not(node(u.value).in[0]) == s.selector) return true;
  const auto simple = static_cast<std::size_t>(std::count_if(
      values.begin(), values.end(), [&](NodeId v) { return is_simple(v) || holds({u.reg, v}); }));
  if (simple == 0 || 4 * simple < values.size()) return false;
  unsigned choices = 0;
  for (const NodeId v : values) choices += count_choices(v);
  if (choice && 2 * choices > 3 * count_choices(u.value) + 2) return false;  // written twice
  const double gained = gain(u, s);
  return choice ? gained + kLeastGain >= own : gained >= kLeastGainOfBit;
}

}  // namespace hlsgen
