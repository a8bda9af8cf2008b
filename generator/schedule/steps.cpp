#include "generator/schedule/steps.hpp"

#include <algorithm>

namespace hlsgen::scheduling {

Steps::Steps(NodeBuilder& nodes, unsigned last) : nodes_(nodes) {
  while ((last >> width_) != 0) ++width_;
}

NodeId Steps::at(unsigned step) {
  return nodes_.compare(Op::kEq, counter_, nodes_.constant(width_, step));
}

NodeId Steps::any_of(const std::vector<Load>& loads) {
  NodeId any = kNone;
  for (const Load& load : loads)
    any = any == kNone ? at(load.step) : nodes_.binary(Op::kOr, any, at(load.step));
  return any;
}

NodeId Steps::chosen(std::vector<Load> loads, NodeId otherwise) {
  std::stable_sort(loads.begin(), loads.end(),
                   [](const Load& a, const Load& b) { return a.step < b.step; });
  if (otherwise == kNone) {
    otherwise = loads.back().value;
    loads.pop_back();
  }
  for (std::size_t i = loads.size(); i-- > 0;)
    otherwise = nodes_.mux(at(loads[i].step), loads[i].value, otherwise);
  return otherwise;
}

}  // namespace hlsgen::scheduling
