#include "generator/print/decide.hpp"

#include "generator/print/restrict.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace hlsgen {
namespace {

constexpr unsigned kDeepest = 7;
constexpr unsigned kDeepestLiteral = 4;  // of a condition, through & | !
constexpr double kLeastGain = 1;         // operators that a branch saves
constexpr unsigned kMostRest = 4;        // labels that a comment behind `default` may list
constexpr double kTie = 0.5;
constexpr double kLeastGainOfBit = 3;    // ... where the register's value is not a choice

struct Update {
  unsigned reg;
  NodeId value;
};
using Updates = std::vector<Update>;
using Cone = std::set<NodeId>;

struct Split {
  NodeId selector = kNone;
  std::vector<std::vector<llvm::APInt>> labels;  // per arm; none: default
  std::vector<Facts> facts;                      // per arm
  std::vector<llvm::APInt> rest;                 // what the default stands for
  std::vector<bool> joined;       // per update
  double gain = 0;
};

class Decider {
 public:
  explicit Decider(Module& module) : m_(module), restrictor_(module) {
    for (NodeId id = 0; id < m_.nodes.size(); ++id)
      if (m_.nodes[id].op == Op::kRegister) present_.emplace(id, m_.nodes[id].index);
    for (const Output& o : m_.outputs) add_cone(o.value, free_);
    for (const Instance& i : m_.instances)
      for (const NodeId input : i.inputs) add_cone(input, free_);
  }

  Block run() {
    Updates all;
    for (unsigned r = 0; r < m_.registers.size(); ++r) all.push_back({r, m_.registers[r].next});
    return build(std::move(all), {}, 0);
  }

 private:
  const Node& node(NodeId id) const { return m_.nodes[id]; }
  bool holds(const Update& u) const {
    const auto found = present_.find(u.value);
    return found != present_.end() && found->second == u.reg;
  }
  // It is known to have the value that it takes.
  bool stays(const Update& u, const Facts& facts) const {
    if (node(u.value).op != Op::kConstant) return false;
    for (const auto& [condition, value] : facts.bits) {
      const Node& n = node(condition);
      if (n.op == (value ? Op::kEq : Op::kNe) && holds({u.reg, n.in[0]}) &&
          node(n.in[1]).op == Op::kConstant && node(n.in[1]).value == node(u.value).value)
        return true;
    }
    for (const auto& [selector, range] : facts.ranges) {
      const auto found = present_.find(selector);
      if (found != present_.end() && found->second == u.reg && range.countPopulation() == 1)
        return range.countTrailingZeros() == node(u.value).value.getZExtValue();
    }
    return false;
  }

  Block build(Updates updates, const Facts& facts, unsigned depth) {
    Block block;
    for (Update& u : updates) u.value = restrictor_.restrict(facts, u.value);
    updates.erase(std::remove_if(updates.begin(), updates.end(),
                                 [&](const Update& u) { return holds(u) || stays(u, facts); }),
                  updates.end());
    while (!updates.empty()) {
      const Split split = depth < kDeepest ? find_split(updates, facts) : Split{};
      if (split.selector == kNone) break;
      Updates joined, rest;
      for (std::size_t i = 0; i < updates.size(); ++i)
        (split.joined[i] ? joined : rest).push_back(updates[i]);
      Step step;
      step.reg = joined.front().reg;
      step.selector = split.selector;
      for (std::size_t a = 0; a < split.facts.size(); ++a)
        step.arms.push_back({split.labels[a], build(joined, split.facts[a], depth + 1), {}});
      step.arms.back().rest = split.rest;
      block.steps.push_back(std::move(step));
      updates = std::move(rest);
    }
    for (const Update& u : updates) {
      Step step;
      step.reg = u.reg;
      step.value = u.value;
      block.steps.push_back(std::move(step));
    }
    std::stable_sort(block.steps.begin(), block.steps.end(),
                     [](const Step& a, const Step& b) { return a.reg < b.reg; });
    return block;
  }

  // What has to be computed for a value, without what the module computes anyway.
  void add_cone(NodeId id, Cone& cone) const {
    const Node& n = node(id);
    if (n.op == Op::kConstant || n.op == Op::kInput || n.op == Op::kRegister ||
        n.op == Op::kInstanceOutput || free_.count(id) != 0 || !cone.insert(id).second)
      return;
    for (const NodeId operand : n.in) add_cone(operand, cone);
  }

  // The conditions a value hangs on.
  void add_literals(NodeId id, unsigned depth, std::set<NodeId>& out) const {
    const Node& n = node(id);
    if (n.op == Op::kConstant) return;
    if (n.op == Op::kNot) return add_literals(n.in[0], depth, out);
    out.insert(id);
    if (depth < kDeepestLiteral && (n.op == Op::kAnd || n.op == Op::kOr))
      for (const NodeId operand : n.in) add_literals(operand, depth + 1, out);
  }
  bool is_choice(NodeId id) const { return node(id).op == Op::kMux; }
  bool is_simple(NodeId id) const {
    const Node& n = node(id);
    if (n.op == Op::kNot) return is_simple(n.in[0]);
    return n.op != Op::kMux && (n.width > 1 || n.in.empty());
  }

  Split find_split(const Updates& updates, const Facts& facts) {
    std::set<NodeId> literals, whole;
    std::vector<double> own;  // what each update gains from its own condition
    for (const Update& u : updates) {
      own.push_back(0);
      if (!is_choice(u.value) || free_.count(u.value) != 0) continue;
      const NodeId condition = without_not(node(u.value).in[0]);
      add_literals(condition, 0, literals);
      whole.insert(condition);
      own.back() = gain(u, on(condition, facts));
    }
    Split best;
    const auto consider = [&](Split s) {
      if (s.gain >= kLeastGain && s.gain > best.gain + kTie) best = std::move(s);
    };
    std::set<NodeId> selectors;
    // A condition comes before its parts, and goes unless a part is clearly better.
    for (auto it = literals.rbegin(); it != literals.rend(); ++it) {
      const Split s = rate(on(*it, facts), updates, own);
      // A part of one register's condition is no better than the condition.
      if (whole.count(*it) != 0 || std::count(s.joined.begin(), s.joined.end(), true) > 1)
        consider(s);
      if (const Domain* d = restrictor_.domain(*it)) selectors.insert(d->selector);
    }
    for (const NodeId selector : selectors) {
      // Who does not join should not tell arms apart either.
      const Split all = rate(cases(selector, updates, facts), updates, own);
      Updates joined;
      for (std::size_t i = 0; i < all.joined.size(); ++i)
        if (all.joined[i]) joined.push_back(updates[i]);
      consider(rate(cases(selector, joined, facts), updates, own));
    }
    return best;
  }

  Split on(NodeId condition, const Facts& facts) const {
    Split s{condition, {{}, {}}, {facts, facts}, {}, {}, 0};
    restrictor_.learn(s.facts[0], condition, true);
    restrictor_.learn(s.facts[1], condition, false);
    return s;
  }

  // Values of the selector that lead to the same, in one arm; the largest is the default.
  Split cases(NodeId selector, const Updates& updates, const Facts& facts) {
    const llvm::APInt range = restrictor_.range(facts, selector);
    std::map<std::vector<NodeId>, llvm::APInt> classes;
    for (unsigned v = 0; v < range.getBitWidth(); ++v) {
      if (!range[v]) continue;
      Facts known = facts;
      known.splits_shared = true;
      known.ranges[selector] = llvm::APInt::getOneBitSet(range.getBitWidth(), v);
      std::vector<NodeId> values;
      for (const Update& u : updates) values.push_back(restrictor_.restrict(known, u.value));
      classes.emplace(values, llvm::APInt(range.getBitWidth(), 0)).first->second.setBit(v);
    }
    std::vector<llvm::APInt> arms;
    for (const auto& [values, members] : classes) arms.push_back(members);
    std::sort(arms.begin(), arms.end(), [](const llvm::APInt& a, const llvm::APInt& b) {
      return a.countTrailingZeros() < b.countTrailingZeros();
    });
    if (arms.size() < 3) return {};
    const auto fallback = std::max_element(
        arms.begin(), arms.end(), [](const llvm::APInt& a, const llvm::APInt& b) {
          return a.countPopulation() <= b.countPopulation();  // the last of them
        });
    std::rotate(fallback, fallback + 1, arms.end());
    Split s;
    s.selector = selector;
    for (const llvm::APInt& arm : arms) {
      s.labels.emplace_back();
      s.facts.push_back(facts);
      s.facts.back().ranges[selector] = arm;
      s.facts.back().splits_shared = true;
      const bool last = s.labels.size() == arms.size();
      if (last && arm.countPopulation() > kMostRest) break;
      for (unsigned v = 0; v < arm.getBitWidth(); ++v)
        if (arm[v]) (last ? s.rest : s.labels.back()).emplace_back(node(selector).width, v);
    }
    return s;
  }

  // Who joins, and how many operators fewer a clock needs if all arms are as likely.
  Split rate(Split s, const Updates& updates, const std::vector<double>& own) {
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
      values_more -= count_values(u);
      for (std::size_t a = 0; a < values.size(); ++a) {
        add_cone(values[a], cones[a]);
        values_more += count_values({u.reg, values[a]});
      }
    }
    s.gain = static_cast<double>(before.size()) - cost(cones, condition);
    if (values_more > 0 && cones.size() == 2) s.gain -= values_more;
    return s;
  }

  std::vector<NodeId> restricted(const Update& u, const Split& s) {
    std::vector<NodeId> values;
    for (const Facts& f : s.facts) values.push_back(restrictor_.restrict(f, u.value));
    return values;
  }

  static double cost(const std::vector<Cone>& cones, const Cone& condition) {
    std::size_t sum = 0;
    for (const Cone& cone : cones)
      for (const NodeId id : cone) sum += condition.count(id) == 0 ? 1 : 0;
    return static_cast<double>(condition.size()) +
           static_cast<double>(sum) / static_cast<double>(cones.size());
  }

  // What one update alone gains, the condition being there already as far as others made it.
  double gain(const Update& u, const Split& s) {
    Cone before, condition, own;
    add_cone(u.value, before);
    add_cone(s.selector, condition);
    std::set_intersection(before.begin(), before.end(), condition.begin(), condition.end(),
                          std::inserter(own, own.end()));
    std::vector<Cone> cones;
    for (const NodeId v : restricted(u, s)) {
      cones.emplace_back();
      add_cone(v, cones.back());
    }
    return static_cast<double>(before.size()) - cost(cones, own);
  }

  // Assignments that a value takes, as ifs.
  int count_values(const Update& u) const {
    const Node& n = node(u.value);
    if (n.op == Op::kConstant || holds(u)) return 0;
    if (n.op != Op::kMux) return 1;
    return count_values({u.reg, n.in[1]}) + count_values({u.reg, n.in[2]});
  }

  unsigned count_choices(NodeId id) const {
    const Node& n = node(id);
    return n.op != Op::kMux ? 0 : 1 + count_choices(n.in[1]) + count_choices(n.in[2]);
  }

  NodeId without_not(NodeId id) const { return node(id).op == Op::kNot ? node(id).in[0] : id; }

  bool joins(const Update& u, const std::vector<NodeId>& values, const Split& s, double own) {
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

  Module& m_;
  Restrictor restrictor_;
  std::map<NodeId, unsigned> present_;  // a register's present value
  Cone free_;                           // what outputs and instances need
};

}  // namespace

Block decide(Module& module) { return Decider(module).run(); }

}  // namespace hlsgen
