#include "generator/print/decide.hpp"

#include "generator/print/splits.hpp"

#include <algorithm>

namespace hlsgen {
namespace {

constexpr unsigned kDeepest = 7;

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
    if (depth < kDeepest) updates = take_decisions(std::move(updates), facts, depth, block);
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

  // What is left to be stored as it is.
  Updates take_decisions(Updates updates, const Facts& facts, unsigned depth, Branch& block) {
    Splits splits(restrictor_, rater_, std::move(updates), facts);
    for (;;) {
      const Split split = splits.best();
      if (split.selector == kNone) return splits.rest();
      const Updates joined = splits.take();
      Decision step;
      step.reg = joined.front().reg;
      step.selector = split.selector;
      for (std::size_t a = 0; a < split.facts.size(); ++a)
        step.arms.push_back({split.labels[a], build(joined, split.facts[a], depth + 1), {}});
      step.arms.back().rest = split.rest;
      block.steps.push_back(std::move(step));
    }
  }

  Module& m_;
  Restrictor restrictor_;
  Rater rater_;
};

}  // namespace

Branch decide(Module& module) { return Decider(module).run(); }

}  // namespace hlsgen
