#include "generator/print/decide.hpp"

#include "generator/print/rate.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace hlsgen {
namespace {

constexpr unsigned kDeepest = 7;
constexpr unsigned kDeepestLiteral = 4;  // of a condition, through & | !
constexpr unsigned kMostRest = 4;        // labels that a comment behind `default` may list
constexpr double kTie = 0.5;

class Decider {
 public:
  explicit Decider(Module& module) : m_(module), restrictor_(module), rater_(module, restrictor_) {}

  Branch run() {
    Updates all;
    for (unsigned r = 0; r < m_.registers.size(); ++r) all.push_back({r, m_.registers[r].next});
    return build(std::move(all), {}, 0);
  }

 private:
  const Node& node(NodeId id) const { return m_.nodes[id]; }
  bool holds(const Update& u) const { return rater_.holds(u); }
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
      if (holds({u.reg, selector}) && range.countPopulation() == 1)
        return range.countTrailingZeros() == node(u.value).value.getZExtValue();
    }
    return false;
  }

  Branch build(Updates updates, const Facts& facts, unsigned depth) {
    Branch block;
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
      Decision step;
      step.reg = joined.front().reg;
      step.selector = split.selector;
      for (std::size_t a = 0; a < split.facts.size(); ++a)
        step.arms.push_back({split.labels[a], build(joined, split.facts[a], depth + 1), {}});
      step.arms.back().rest = split.rest;
      block.steps.push_back(std::move(step));
      updates = std::move(rest);
    }
    for (const Update& u : updates) {
      Decision step;
      step.reg = u.reg;
      step.value = u.value;
      block.steps.push_back(std::move(step));
    }
    std::stable_sort(block.steps.begin(), block.steps.end(),
                     [](const Decision& a, const Decision& b) { return a.reg < b.reg; });
    return block;
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
  Split find_split(const Updates& updates, const Facts& facts) {
    std::set<NodeId> literals, whole;
    std::vector<double> own;  // what each update gains from its own condition
    for (const Update& u : updates) {
      own.push_back(0);
      if (!rater_.is_choice(u.value) || rater_.is_free(u.value)) continue;
      const NodeId condition = rater_.without_not(node(u.value).in[0]);
      add_literals(condition, 0, literals);
      whole.insert(condition);
      own.back() = rater_.gain(u, on(condition, facts));
    }
    Split best;
    const auto consider = [&](Split s) {
      if (s.gain >= Rater::kLeastGain && s.gain > best.gain + kTie) best = std::move(s);
    };
    std::set<NodeId> selectors;
    // A condition comes before its parts, and goes unless a part is clearly better.
    for (auto it = literals.rbegin(); it != literals.rend(); ++it) {
      const Split s = rater_.rate(on(*it, facts), updates, own);
      // A part of one register's condition is no better than the condition.
      if (whole.count(*it) != 0 || std::count(s.joined.begin(), s.joined.end(), true) > 1)
        consider(s);
      if (const Domain* d = restrictor_.domain(*it)) selectors.insert(d->selector);
    }
    for (const NodeId selector : selectors) {
      // Who does not join should not tell arms apart either.
      const Split all = rater_.rate(cases(selector, updates, facts), updates, own);
      Updates joined;
      for (std::size_t i = 0; i < all.joined.size(); ++i)
        if (all.joined[i]) joined.push_back(updates[i]);
      consider(rater_.rate(cases(selector, joined, facts), updates, own));
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

  Module& m_;
  Restrictor restrictor_;
  Rater rater_;
};

}  // namespace

Branch decide(Module& module) { return Decider(module).run(); }

}  // namespace hlsgen
