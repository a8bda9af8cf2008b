#include "generator/print/synchronisers.hpp"

#include "generator/print/plan.hpp"

namespace hlsgen {

std::vector<bool> find_synchronisers(const Module& m) {
  const std::vector<unsigned> uses = count_uses(m);
  std::vector<bool> found(m.registers.size());
  for (std::size_t second = 0; second < m.registers.size(); ++second) {
    const NodeId taken = m.registers[second].next;
    if (m.nodes[taken].op != Op::kRegister || uses[taken] != 1) continue;
    const unsigned first = m.nodes[taken].index;
    if (m.nodes[m.registers[first].next].op == Op::kInput) found[first] = found[second] = true;
  }
  return found;
}

}  // namespace hlsgen
