#include "generator/machine/cells.hpp"

#include <algorithm>

namespace hlsgen::machine {

void give_cells(const Program& p, const std::vector<unsigned>& writers,
                const std::vector<unsigned>& last_read, Order& order) {
  order.cell_of.resize(p.values.size());
  order.states.resize(p.next.size());
  for (unsigned r = 0; r < p.next.size(); ++r) {
    order.states[r] = 2 * r;
    order.places[writers[r]].written = 2 * r;
    order.cell_of[p.instructions[writers[r]].result] = 2 * r;
  }
  order.cells = static_cast<unsigned>(2 * p.next.size());
  for (ValueId v = 0; v < p.values.size(); ++v) {
    if (last_read[v] == 0) continue;
    if (p.values[v].source == Source::kConstant) order.cell_of[v] = order.cells++;
    if (p.values[v].source == Source::kState) order.cell_of[v] = 2 * p.values[v].index;
  }
  // Temporaries in the order of their birth; a cell is free after its last read.
  std::vector<unsigned> made;
  for (unsigned i = 0; i < p.instructions.size(); ++i)
    if (last_read[p.instructions[i].result] != 0 && !order.cell_of[p.instructions[i].result]) made.push_back(i);
  std::sort(made.begin(), made.end(), [&](unsigned x, unsigned y) {
    return order.places[x].clock < order.places[y].clock;
  });
  std::vector<std::pair<unsigned, unsigned>> free_after;  // last read, cell
  for (const unsigned i : made) {
    const unsigned born = order.places[i].clock + 2;
    auto found = std::find_if(free_after.begin(), free_after.end(),
                              [&](const auto& cell) { return cell.first < born; });
    if (found == free_after.end()) found = free_after.insert(found, {0, order.cells++});
    found->first = last_read[p.instructions[i].result];
    order.places[i].written = found->second;
    order.cell_of[p.instructions[i].result] = found->second;
  }
}

}  // namespace hlsgen::machine
