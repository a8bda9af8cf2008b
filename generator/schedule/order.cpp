#include "generator/schedule/order.hpp"

#include <algorithm>
#include <set>

#include "generator/backend.hpp"

namespace hlsgen::scheduling {
namespace {

constexpr unsigned kOrders = 24;
constexpr unsigned kMostSteps = 4096;
constexpr unsigned kUnknown = ~0u;

// A place in time; later is greater.
struct Moment {
  unsigned step = 0, depth = 0;
  bool operator<(const Moment& o) const { return step != o.step ? step < o.step : depth < o.depth; }
};

// A register in between where the delays do not fit into one step.
Moment after(const Operations& ops, Moment m, unsigned delay) {
  if (m.depth != 0 && delay != 0 && m.depth + delay > ops.most_delay()) return {m.step + 1, delay};
  return {m.step, m.depth + delay};
}

class Scheduler {
 public:
  explicit Scheduler(const Operations& ops) : ops_(ops) { find_urgency(); }

  // An unlimited number of units: no order is faster.
  Order unlimited() {
    limited_ = false;
    return run(0);
  }
  Order limited(unsigned variant) {
    limited_ = true;
    return run(variant);
  }

  // Steps from the issue of a unit to the end, at least.
  unsigned steps_behind(NodeId id) const { return behind_[id].step + ops_.latency(id); }

 private:
  // Backwards as if time ran the other way: from the ends, as late as can be.
  void find_urgency() {
    behind_.assign(ops_.module.nodes.size(), {});
    for (const NodeId sink : ops_.sinks) behind_[sink].depth = kUpdate;
    for (NodeId id = static_cast<NodeId>(ops_.module.nodes.size()); id-- > 0;) {
      if (!ops_.lives[id]) continue;
      const Moment before = ops_.is_unit(id) ? Moment{behind_[id].step + ops_.latency(id), kChoice}
                                             : after(ops_, behind_[id], ops_.delay[id]);
      for (const NodeId operand : ops_.node(id).in)
        behind_[operand] = std::max(behind_[operand], before);
    }
  }

  Order run(unsigned variant) {
    const std::size_t count = ops_.module.nodes.size();
    order_ = {};
    order_.step.assign(count, kUnknown);
    order_.depth.assign(count, 0);
    order_.issue.assign(count, kUnknown);
    order_.unit.assign(count, 0);
    for (unsigned step = 0; spread(step, variant); ++step)
      if (step == kMostSteps) throw NetlistError(ops_.module.name + ": the schedule does not end");
    order_.last = 1;
    for (const NodeId sink : ops_.sinks) order_.last = std::max(order_.last, end_of(sink, kUpdate));
    return order_;
  }

  // The step in which a reader with a delay of its own can take the value.
  unsigned end_of(NodeId id, unsigned delay) const {
    const bool fits = order_.depth[id] == 0 || order_.depth[id] + delay <= ops_.most_delay();
    return order_.step[id] + (fits ? 0 : 1);
  }

  // One step: what is known by now, and what goes into the units.  False when all is known.
  bool spread(unsigned step, unsigned variant) {
    std::vector<std::vector<NodeId>> ready(ops_.pools());
    bool missing = false;
    for (NodeId id = 0; id < ops_.module.nodes.size(); ++id) {
      if (!ops_.lives[id] || order_.step[id] != kUnknown) continue;
      const Node& n = ops_.node(id);
      if (std::any_of(n.in.begin(), n.in.end(),
                      [&](NodeId o) { return order_.step[o] == kUnknown; })) {
        missing = true;
        continue;
      }
      if (ops_.is_unit(id)) {
        unsigned earliest = 0;
        for (const NodeId operand : n.in) earliest = std::max(earliest, end_of(operand, kChoice));
        missing = true;
        if (!limited_)
          issue(id, earliest, 0);
        else if (earliest <= step)
          ready[ops_.pool(id)].push_back(id);
        continue;
      }
      Moment latest;
      for (const NodeId operand : n.in)
        latest = std::max(latest, Moment{order_.step[operand], order_.depth[operand]});
      latest = after(ops_, latest, ops_.delay[id]);
      order_.step[id] = latest.step;
      order_.depth[id] = latest.depth;
    }
    for (unsigned pool = 0; pool < ready.size(); ++pool) {
      std::stable_sort(ready[pool].begin(), ready[pool].end(), [&](NodeId a, NodeId b) {
        return urgency(a, variant) > urgency(b, variant);
      });
      for (unsigned u = 0; u < ready[pool].size() && u < ops_.units_in(pool); ++u)
        issue(ready[pool][u], step, u);
    }
    return missing;
  }

  void issue(NodeId id, unsigned step, unsigned unit) {
    order_.issue[id] = step;
    order_.unit[id] = unit;
    order_.step[id] = step + ops_.latency(id);
  }

  // Variants other than the first shake it by up to a step or two.
  std::uint64_t urgency(NodeId id, unsigned variant) const {
    const std::uint64_t way =
        std::uint64_t{behind_[id].step} * ops_.most_delay() + behind_[id].depth;
    if (variant == 0) return way;
    std::uint64_t mixed = (std::uint64_t{id} + 1) * 0x9e3779b97f4a7c15U * (variant | 1U);
    mixed ^= mixed >> 29;
    return way + mixed % ((variant % 3 + 1) * std::uint64_t{ops_.most_delay()});
  }

  const Operations& ops_;
  Order order_;
  bool limited_ = true;
  std::vector<Moment> behind_;  // what follows upon a value, counted from the end
};

unsigned bound_of(const Operations& ops, const Scheduler& scheduler, const Order& free) {
  unsigned bound = free.last;
  for (unsigned pool = 0; pool < ops.pools(); ++pool) {
    std::vector<std::pair<unsigned, unsigned>> units;  // earliest issue, steps behind it
    std::set<unsigned> starts, ends;
    for (NodeId id = 0; id < ops.module.nodes.size(); ++id) {
      if (!ops.lives[id] || !ops.is_unit(id) || ops.pool(id) != pool) continue;
      units.emplace_back(free.issue[id], scheduler.steps_behind(id));
      starts.insert(units.back().first);
      ends.insert(units.back().second);
    }
    for (const unsigned start : starts) {
      for (const unsigned end : ends) {
        const auto among =
            static_cast<unsigned>(std::count_if(units.begin(), units.end(), [&](const auto& u) {
              return u.first >= start && u.second >= end;
            }));
        if (among == 0) continue;
        const unsigned turns = (among + ops.units_in(pool) - 1) / ops.units_in(pool);
        bound = std::max(bound, start + turns - 1 + end);
      }
    }
  }
  return bound;
}

}  // namespace

Order order(const Operations& operations) {
  Scheduler scheduler(operations);
  const unsigned bound = bound_of(operations, scheduler, scheduler.unlimited());
  Order best = scheduler.limited(0);
  for (unsigned variant = 1; variant < kOrders && best.last > bound; ++variant) {
    Order other = scheduler.limited(variant);
    if (other.last < best.last) best = std::move(other);
  }
  best.bound = bound;
  return best;
}

}  // namespace hlsgen::scheduling
