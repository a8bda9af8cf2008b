#include "generator/passes/simplify_counters.hpp"

#include "generator/passes/rebuild.hpp"
#include "generator/print/plan.hpp"

namespace hlsgen {
namespace {

bool is_zero(Rebuild& b, NodeId id) { return b.constant(id) != nullptr && b.constant(id)->isZero(); }

NodeId counter(Rebuild& b, const Node& n) {
  for (const unsigned side : {0u, 1u}) {
    const NodeId count = n.in[side];
    if (!b.is(count, Op::kRegister)) continue;
    const Node by = b.node(n.in[1 - side]);
    if (by.op == Op::kMux) {
      const bool then = is_zero(b, by.in[2]);
      if (!then && !is_zero(b, by.in[1])) continue;
      const NodeId sum = b.binary(Op::kAdd, count, by.in[then ? 1 : 2]);
      return then ? b.mux(by.in[0], sum, count) : b.mux(by.in[0], count, sum);
    }
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
