#include "generator/schedule/bind.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace hlsgen::scheduling {
namespace {

constexpr std::size_t kFree = 1;    // values that a register takes without a choice
constexpr double kChoiceBit = 0.6;  // logic cells per bit of every further one

// Logic cells that a value more in this register costs.
double price(const Shared& shared, unsigned width) {
  const unsigned wider = std::max(shared.width, width);
  const double choices = shared.values.size() >= kFree ? kChoiceBit * width : 0;
  return choices + (wider - shared.width) + 0.1 * (wider - width);
}

void bind_registers(const Operations& ops, const Keeping& k, Binding& b) {
  std::vector<NodeId> values;
  for (NodeId id = 0; id < ops.module.nodes.size(); ++id)
    if (k.kept[id] && k.early_of[id] == 0) values.push_back(id);
  std::stable_sort(values.begin(), values.end(),
                   [&](NodeId x, NodeId y) { return k.from[x] < k.from[y]; });
  for (const NodeId id : values) {
    const unsigned width = ops.node(id).width;
    double best = 0.9 * width;  // a register of its own
    unsigned place = static_cast<unsigned>(b.registers.size());
    for (unsigned r = 0; r < b.registers.size(); ++r) {
      if (k.until[b.registers[r].values.back()] > k.from[id]) continue;
      const double p = price(b.registers[r], width);
      if (p >= best) continue;
      best = p;
      place = r;
    }
    if (place == b.registers.size()) b.registers.emplace_back();
    b.registers[place].width = std::max(b.registers[place].width, width);
    b.registers[place].values.push_back(id);
    b.place[id] = place;
  }
}

// What a unit's port is wired to: a register, or a value.
using Source = std::pair<bool, unsigned>;

void bind_factors(const Operations& ops, const Order& order, const Keeping& k,
                  const std::vector<std::pair<unsigned, unsigned>>& needs, Binding& b) {
  std::vector<NodeId> products;
  for (NodeId id = 0; id < ops.module.nodes.size(); ++id)
    if (ops.lives[id] && ops.kind[id] == Kind::kProduct) products.push_back(id);
  std::stable_sort(products.begin(), products.end(),
                   [&](NodeId x, NodeId y) { return order.issue[x] < order.issue[y]; });
  const auto source = [&](NodeId operand, unsigned step) -> Source {
    const bool kept = k.way(operand, step) == Way::kKept && k.early_of[operand] == 0;
    return kept ? Source{true, b.place[operand]} : Source{false, operand};
  };
  std::map<unsigned, std::set<Source>> first, second;  // per multiplier
  for (const NodeId id : products) {
    const Source x = source(ops.node(id).in[0], order.issue[id]);
    const Source y = source(ops.node(id).in[1], order.issue[id]);
    auto& one = first[order.unit[id]];
    auto& two = second[order.unit[id]];
    const bool may_stay =
        needs[id].first <= ops.budget.width && needs[id].second <= ops.budget.second_width;
    const bool may_change =
        needs[id].second <= ops.budget.width && needs[id].first <= ops.budget.second_width;
    const auto known = [&](const Source& s, const Source& t) {
      return one.count(s) + two.count(t);
    };
    b.exchanged[id] = !may_stay || (may_change && known(y, x) > known(x, y));
    one.insert(b.exchanged[id] ? y : x);
    two.insert(b.exchanged[id] ? x : y);
  }
}

}  // namespace

Binding bind(const Operations& operations, const Order& order, const Keeping& keeping,
             const std::vector<std::pair<unsigned, unsigned>>& needs) {
  Binding b;
  b.place.assign(operations.module.nodes.size(), 0);
  b.exchanged.assign(operations.module.nodes.size(), false);
  bind_registers(operations, keeping, b);
  bind_factors(operations, order, keeping, needs, b);
  return b;
}

}  // namespace hlsgen::scheduling
