#include "generator/passes/share_common.hpp"

#include "generator/passes/rebuild.hpp"

#include <algorithm>
#include <map>
#include <tuple>

namespace hlsgen {

bool share_common(Module& module) {
  using Key = std::tuple<Op, unsigned, std::vector<NodeId>, std::vector<std::uint64_t>, unsigned,
                         unsigned, unsigned>;
  std::map<Key, NodeId> known;
  std::vector<NodeId> new_id(module.nodes.size());
  std::vector<Node> nodes;
  for (NodeId id = 0; id < module.nodes.size(); ++id) {
    Node n = module.nodes[id];
    for (NodeId& operand : n.in) operand = new_id[operand];
    std::vector<NodeId> in = n.in;
    const bool commutes = n.op == Op::kAdd || n.op == Op::kMul || n.op == Op::kAnd ||
                          n.op == Op::kOr || n.op == Op::kXor || n.op == Op::kEq ||
                          n.op == Op::kNe;
    if (commutes) std::sort(in.begin(), in.end());
    std::vector<std::uint64_t> words;
    if (n.op == Op::kConstant)
      words.assign(n.value.getRawData(), n.value.getRawData() + n.value.getNumWords());
    const auto [at, fresh] = known.emplace(
        Key(n.op, n.width, std::move(in), std::move(words), n.index, n.port, n.low),
        static_cast<NodeId>(nodes.size()));
    new_id[id] = at->second;
    if (fresh) {
      nodes.push_back(std::move(n));
      continue;
    }
    Node& first = nodes[at->second];
    if (first.name.empty()) first.name = n.name;
    if (first.hint.empty()) first.hint = n.hint;
    if (n.returned && !first.returned) {
      first.function = n.function;
      first.returned = true;
    }
  }
  const bool changed = nodes.size() != module.nodes.size();
  module.nodes = std::move(nodes);
  remap_roots(module, new_id);
  return changed;
}

}  // namespace hlsgen
