#include "generator/passes/remove_dead.hpp"

#include "generator/passes/rebuild.hpp"

namespace hlsgen {
namespace {

class Liveness {
 public:
  explicit Liveness(const Module& m)
      : m_(m), nodes(m.nodes.size(), false), registers(m.registers.size(), false),
        tables(m.tables.size(), false) {
    for (const Output& o : m.outputs) reach(o.value);
    for (const Instance& i : m.instances)
      for (const NodeId input : i.inputs) reach(input);
  }

 private:
  void reach(NodeId root) {
    std::vector<NodeId> todo = {root};
    while (!todo.empty()) {
      const NodeId id = todo.back();
      todo.pop_back();
      if (nodes[id]) continue;
      nodes[id] = true;
      const Node& n = m_.nodes[id];
      todo.insert(todo.end(), n.in.begin(), n.in.end());
      if (n.op == Op::kTable) tables[n.index] = true;
      if (n.op != Op::kRegister || registers[n.index]) continue;
      registers[n.index] = true;
      todo.push_back(m_.registers[n.index].next);
    }
  }

  const Module& m_;

 public:
  std::vector<bool> nodes, registers, tables;
};

// Keeps what is live and returns where each element went.
template <class T>
std::vector<unsigned> compact(std::vector<T>& list, const std::vector<bool>& live) {
  std::vector<unsigned> where(list.size(), 0);
  std::vector<T> kept;
  for (std::size_t i = 0; i < list.size(); ++i) {
    where[i] = static_cast<unsigned>(kept.size());
    if (live[i]) kept.push_back(std::move(list[i]));
  }
  list = std::move(kept);
  return where;
}

}  // namespace

bool remove_dead(Module& module) {
  const Liveness live(module);
  const std::size_t before = module.nodes.size() + module.registers.size();
  const auto node_at = compact(module.nodes, live.nodes);
  const auto register_at = compact(module.registers, live.registers);
  const auto table_at = compact(module.tables, live.tables);
  for (Node& n : module.nodes) {
    for (NodeId& operand : n.in) operand = node_at[operand];
    if (n.op == Op::kRegister) n.index = register_at[n.index];
    if (n.op == Op::kTable) n.index = table_at[n.index];
  }
  remap_roots(module, node_at);
  return module.nodes.size() + module.registers.size() != before;
}

}  // namespace hlsgen
