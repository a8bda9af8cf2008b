#include "generator/passes/simplify_counters.hpp"

#include "generator/passes/rebuild.hpp"
#include "generator/print/plan.hpp"

namespace hlsgen {
namespace {

NodeId counter(Rebuild& b, const Node& n) {
  if (n.op != Op::kAdd || !b.current_used_once()) return kNone;
  for (const unsigned side : {0u, 1u}) {
    const NodeId count = n.in[side], step = n.in[1 - side];
    if (!b.is(count, Op::kRegister)) continue;
    const Node by = b.node(step);
    if ((by.op != Op::kSext && by.op != Op::kZext) || b.width(by.in[0]) != 1) continue;
    const auto one = by.op == Op::kSext ? llvm::APInt::getAllOnes(n.width) : llvm::APInt(n.width, 1);
    return b.mux(by.in[0], b.binary(Op::kAdd, count, b.value(one)), count);
  }
  return kNone;
}

}  // namespace

bool simplify_counters(Module& module) {
  const std::vector<unsigned> uses = count_uses(module);
  return rewrite(module, [&](Rebuild& b, const Node& n) {
    return n.op == Op::kAdd && uses[b.old_id()] == 1 ? counter(b, n) : kNone;
  });
}

}  // namespace hlsgen
