#include "generator/print/place.hpp"

#include <algorithm>
#include <numeric>
#include <set>

namespace hlsgen {
namespace {

// Where a wire may stand: in a block, or, read by several arms of a step, around these arms.
struct Place {
  Branch* block = nullptr;  // that holds the wire if it stands here
  Decision* step = nullptr;    // null: anywhere in the block
  bool operator<(const Place& o) const {
    return block != o.block ? std::less<>()(block, o.block) : std::less<>()(step, o.step);
  }
  bool operator==(const Place& o) const { return block == o.block && step == o.step; }
};

class Placer {
 public:
  Placer(const Module& module, const Plan& plan, Branch& root)
      : m_(module), plan_(plan), root_(root), at_(module.nodes.size()) {
    for (const Node& n : m_.nodes) read_.emplace_back(n.width, 0);
    parents_[{&root_, nullptr}] = {};
    find_parents(root_);
    for (const Output& o : m_.outputs) read(o.value, root_);
    for (const Instance& i : m_.instances)
      for (const NodeId input : i.inputs) read(input, root_);
    for_each_read(root_, [this](NodeId id, Branch& block) { read(id, block); });
    for (NodeId id = static_cast<NodeId>(m_.nodes.size()); id-- > 0;)
      if (at_[id].block != nullptr) place(id);
  }

  void write() {
    for (NodeId id = 0; id < m_.nodes.size(); ++id)
      if (at_[id].block != nullptr && at_[id].block != &root_ && plan_.wire[id])
        at_[id].block->wires.push_back(id);
  }

  bool group_arms() { return group_arms(root_); }

 private:
  void find_parents(Branch& block) {
    for (Decision& step : block.steps) {
      parents_[{&block, &step}] = {&block, nullptr};
      for (Decision::Arm& arm : step.arms) {
        parents_[{&arm.block, nullptr}] = {&block, &step};
        find_parents(arm.block);
      }
    }
  }

  // The innermost place that holds both.
  Place around(Place a, Place b) const {
    if (a.block == nullptr) return b;
    std::set<Place> above;
    for (; a.block != nullptr; a = parents_.at(a)) above.insert(a);
    while (above.count(b) == 0) b = parents_.at(b);
    return b;
  }

  void read(NodeId id, Branch& from) {
    read(id, {&from, nullptr}, llvm::APInt::getAllOnes(m_.nodes[id].width));
  }
  void read(NodeId id, const Place& from, const llvm::APInt& bits) {
    at_[id] = around(at_[id], from);
    read_[id] |= bits;
    readers_[id].insert(from);
  }

  void place(NodeId id) {
    const Node& n = m_.nodes[id];
    // A product is printed in two wires, a table in a case of its own, and bits that nothing reads
    // are listed at the module's end, where a branch's wires are not known.
    if (plan_.wire[id] && (n.op == Op::kMul || n.op == Op::kTable || !read_[id].isAllOnes()))
      at_[id] = {&root_, nullptr};
    const auto all = [&](NodeId operand) {
      read(operand, at_[id], llvm::APInt::getAllOnes(m_.nodes[operand].width));
    };
    const auto chain = plan_.cases.find(id);
    if (chain != plan_.cases.end()) {
      all(chain->second.selector);
      for (const CaseChain::Arm& arm : chain->second.arms) all(arm.value);
      all(chain->second.otherwise);
      return;
    }
    for (const NodeId operand : n.in) {
      if (n.op == Op::kSlice)
        read(operand, at_[id], read_[id].zext(m_.nodes[operand].width).shl(n.low));
      else
        all(operand);
    }
  }

  bool computes(NodeId id) const {
    const Op op = m_.nodes[id].op;
    return plan_.wire[id] && op != Op::kSlice && op != Op::kConcat && op != Op::kZext &&
           op != Op::kSext && op != Op::kNot;
  }

  bool group_arms(Branch& block) {
    bool changed = false;
    for (Decision& step : block.steps) {
      if (step.arms.size() > 2) changed |= group_arms(block, step);
      for (Decision::Arm& arm : step.arms) changed |= group_arms(arm.block);
    }
    return changed;
  }

  bool group_arms(Branch& block, Decision& step) {
    std::vector<std::size_t> group(step.arms.size());
    std::iota(group.begin(), group.end(), 0u);
    for (NodeId id = 0; id < m_.nodes.size(); ++id)
      if (computes(id) && at_[id] == Place{&block, &step}) {
        std::set<std::size_t> arms;
        find_arms(id, step, arms);
        for (const std::size_t arm : arms) merge(group, *arms.begin(), arm);
      }
    std::vector<Decision::Arm> arms;
    bool changed = false;
    for (std::size_t first = 0; first < group.size(); ++first) {
      if (group[first] != first) continue;
      const auto size = static_cast<std::size_t>(std::count(group.begin(), group.end(), first));
      if (size == group.size()) return false;
      if (size == 1) continue;
      changed = true;
    }
    if (!changed) return false;
    // The default's group comes last and stays the default.
    const std::size_t last = group.back();
    for (std::size_t first = 0; first < group.size(); ++first)
      if (group[first] == first && first != last) arms.push_back(gather(step, group, first));
    arms.push_back(gather(step, group, last));
    step.arms = std::move(arms);
    return true;
  }

  static void merge(std::vector<std::size_t>& group, std::size_t a, std::size_t b) {
    const std::size_t to = std::min(group[a], group[b]), from = std::max(group[a], group[b]);
    std::replace(group.begin(), group.end(), from, to);
  }

  // The arms in which the value is read, by way of other values as well.
  void find_arms(NodeId id, const Decision& step, std::set<std::size_t>& arms) {
    std::set<NodeId> seen;
    std::vector<NodeId> todo{id};
    while (!todo.empty()) {
      const NodeId at = todo.back();
      todo.pop_back();
      if (!seen.insert(at).second) continue;
      for (const Place& reader : readers_[at]) {
        for (Place p = reader; p.block != nullptr; p = parents_.at(p))
          for (std::size_t a = 0; a < step.arms.size(); ++a)
            if (p.block == &step.arms[a].block) arms.insert(a);
      }
      for (NodeId user = at + 1; user < m_.nodes.size(); ++user) {
        const std::vector<NodeId>& in = m_.nodes[user].in;
        if (at_[user].block != nullptr && std::find(in.begin(), in.end(), at) != in.end())
          todo.push_back(user);
      }
    }
  }

  static Decision::Arm gather(Decision& step, const std::vector<std::size_t>& group,
                              std::size_t first) {
    const bool holds_default = group.back() == first;
    if (std::count(group.begin(), group.end(), first) == 1)
      return std::move(holds_default ? step.arms.back() : step.arms[first]);
    Decision::Arm out;
    Decision inner;
    inner.reg = step.reg;
    inner.selector = step.selector;
    for (std::size_t a = 0; a < group.size(); ++a) {
      if (group[a] != first) continue;
      out.labels.insert(out.labels.end(), step.arms[a].labels.begin(), step.arms[a].labels.end());
      inner.arms.push_back(std::move(step.arms[a]));
    }
    if (holds_default) out.labels.clear();
    if (!inner.arms.back().labels.empty()) inner.arms.back().rest = inner.arms.back().labels;
    inner.arms.back().labels.clear();
    out.block.steps.push_back(std::move(inner));
    return out;
  }

  const Module& m_;
  const Plan& plan_;
  Branch& root_;
  std::map<Place, Place> parents_;
  std::vector<Place> at_;          // no block: no one reads it
  std::vector<llvm::APInt> read_;  // bits
  std::map<NodeId, std::set<Place>> readers_;
};

}  // namespace

void place_wires(const Module& module, const Plan& plan, Branch& root) {
  while (Placer(module, plan, root).group_arms()) {
  }
  Placer(module, plan, root).write();
}

}  // namespace hlsgen
