#include "generator/schedule/keep.hpp"

#include <algorithm>
#include <optional>

#include "generator/backend.hpp"

namespace hlsgen::scheduling {
namespace {

// A bit that is kept takes a flip-flop while it lives, and a choice in front of it when others
// share it.
constexpr double kShared = 0.4;
constexpr int kRounds = 3;

class Keeper {
 public:
  Keeper(const Operations& ops, const Order& order)
      : ops_(ops),
        order_(order),
        count_(ops.module.nodes.size()),
        left_(count_, false),
        old_(ops.module.registers.size(), kNone),
        early_(old_.size(), false) {
    for (NodeId id = 0; id < count_; ++id)
      if (ops_.node(id).op == Op::kRegister) old_[ops_.node(id).index] = id;
    find_windows();
  }

  Keeping run() {
    choose_early();
    auto best = evaluate();
    if (!best) throw NetlistError(ops_.module.name + ": the schedule cannot be kept");
    for (int round = 0, improved = 1; round < kRounds && improved != 0; ++round) {
      improved = 0;
      for (NodeId id = 0; id < count_; ++id) {
        if (!best->kept[id] || ops_.kind[id] != Kind::kLogic || best->early_of[id] != 0) continue;
        left_[id] = true;
        auto other = evaluate();
        if (other && cost(*other) < cost(*best)) {
          best = std::move(other);
          ++improved;
        } else {
          left_[id] = false;
        }
      }
    }
    return *best;
  }

 private:
  // A unit's value stands until the next one comes out of it.
  void find_windows() {
    window_.assign(count_, order_.last);
    for (NodeId a = 0; a < count_; ++a) {
      if (ops_.kind[a] == Kind::kTaken) window_[a] = 0;
      if (!ops_.lives[a] || !ops_.is_unit(a)) continue;
      for (NodeId b = 0; b < count_; ++b) {
        if (ops_.lives[b] && ops_.is_unit(b) && ops_.pool(a) == ops_.pool(b) &&
            order_.unit[a] == order_.unit[b] && order_.issue[b] > order_.issue[a])
          window_[a] = std::min(window_[a], order_.issue[b] + ops_.latency(b) - 1);
      }
    }
  }

  // Whether an output shows the same value: then one register serves both, and takes it at the end.
  bool is_output(NodeId value) const {
    return std::any_of(ops_.module.outputs.begin(), ops_.module.outputs.end(),
                       [&](const Output& o) { return o.value == value; });
  }

  void choose_early() {
    const auto all = evaluate();
    std::vector<bool> used(count_, false);
    for (unsigned r = 0; all && r < early_.size(); ++r) {
      const NodeId value = ops_.module.registers[r].next;
      if (ops_.kind[value] != Kind::kLogic || used[value] || is_output(value) ||
          order_.step[value] == 0)
        continue;
      early_[r] = true;
      used[value] = evaluate().has_value();
      early_[r] = used[value];
    }
  }

  std::optional<Keeping> evaluate() {
    Keeping k;
    k.kept.assign(count_, false);
    k.from.assign(count_, 0);
    k.until.assign(count_, 0);
    k.early = early_;
    k.early_of.assign(count_, 0);
    k.times.assign(count_, llvm::BitVector(order_.last + 1));
    std::vector<llvm::BitVector> reads(count_, llvm::BitVector(order_.last + 1));
    for (const Output& o : ops_.module.outputs) reads[o.value].set(order_.last);
    for (unsigned r = 0; r < early_.size(); ++r) {
      const NodeId value = ops_.module.registers[r].next;
      if (early_[r]) k.early_of[value] = r + 1;
      reads[value].set(early_[r] ? order_.step[value] : order_.last);
    }
    for (NodeId id = static_cast<NodeId>(count_); id-- > 0;)
      if (reads[id].any()) settle(id, reads[id], k, reads);
    for (unsigned r = 0; r < early_.size(); ++r) {
      if (!early_[r] || old_[r] == kNone || reads[old_[r]].none()) continue;
      const auto last = static_cast<unsigned>(reads[old_[r]].find_last());
      if (last > order_.step[ops_.module.registers[r].next]) return std::nullopt;
    }
    return holds(k) ? std::optional(std::move(k)) : std::nullopt;
  }

  void settle(NodeId id, const llvm::BitVector& read, Keeping& k,
              std::vector<llvm::BitVector>& reads) const {
    const auto last = static_cast<unsigned>(read.find_last());
    switch (ops_.kind[id]) {
      case Kind::kSource:
        return;
      case Kind::kTaken:
      case Kind::kProduct:
      case Kind::kEntry:
        k.kept[id] = last > window_[id];
        k.from[id] = window_[id];
        if (ops_.is_unit(id)) k.times[id].set(order_.issue[id]);
        break;
      case Kind::kLogic:
        k.kept[id] = k.early_of[id] != 0 || (!left_[id] && last > order_.step[id]);
        k.from[id] = order_.step[id];
        if (k.kept[id] || !left_[id])
          k.times[id].set(order_.step[id]);
        else
          k.times[id] = read;
        break;
    }
    k.until[id] = last;
    for (const NodeId operand : ops_.node(id).in) reads[operand] |= k.times[id];
  }

  // Wires do not move: an operand is read in one way at all times.  And nothing takes too long.
  bool holds(Keeping& k) const {
    std::vector<unsigned> depth(count_, 0);
    const auto ends = [&](NodeId id, unsigned delay) {  // fits in front of a register
      k.longest = std::max(k.longest, depth[id] + delay);
      return depth[id] == 0 || depth[id] + delay <= ops_.most_delay();
    };
    for (NodeId id = 0; id < count_; ++id) {
      if (k.times[id].none()) continue;
      const auto first = static_cast<unsigned>(k.times[id].find_first());
      const auto last = static_cast<unsigned>(k.times[id].find_last());
      for (const NodeId operand : ops_.node(id).in) {
        if (k.way(operand, first) != k.way(operand, last)) return false;
        if (k.way(operand, first) == Way::kKept) continue;
        if (ops_.is_unit(id)) {
          if (!ends(operand, kChoice)) return false;
        } else {
          depth[id] = std::max(depth[id], depth[operand]);
        }
      }
      if (ops_.is_unit(id)) continue;
      const unsigned delay = ops_.delay[id];
      if (depth[id] != 0 && delay != 0 && depth[id] + delay > ops_.most_delay()) return false;
      depth[id] += delay;
      if (k.kept[id]) k.longest = std::max(k.longest, depth[id]);
    }
    return std::all_of(ops_.sinks.begin(), ops_.sinks.end(), [&](NodeId sink) {
      return k.early_of[sink] != 0 || k.way(sink, order_.last) == Way::kKept || ends(sink, kUpdate);
    });
  }

  double cost(const Keeping& k) const {
    std::vector<unsigned> live(order_.last + 1, 0);
    double shared = 0;
    for (NodeId id = 0; id < count_; ++id) {
      if (!k.kept[id] || k.early_of[id] != 0) continue;
      for (unsigned step = k.from[id] + 1; step <= k.until[id]; ++step)
        live[step] += ops_.node(id).width;
      shared += kShared * ops_.node(id).width;
    }
    return *std::max_element(live.begin(), live.end()) + shared;
  }

  const Operations& ops_;
  const Order& order_;
  std::size_t count_;
  std::vector<bool> left_;   // to its operands
  std::vector<NodeId> old_;  // present values of the registers
  std::vector<bool> early_;
  std::vector<unsigned> window_;  // the last step in which a value is there by itself
};

}  // namespace

Keeping keep(const Operations& operations, const Order& order) {
  return Keeper(operations, order).run();
}

}  // namespace hlsgen::scheduling
