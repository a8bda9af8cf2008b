#include "generator/passes/spell_enumerators.hpp"

#include "generator/passes/rebuild.hpp"
#include "generator/print/plan.hpp"

namespace hlsgen {

bool spell_enumerators(Module& module) {
  const std::vector<int> enumerations = infer_enumerations(module);
  return rewrite(module, [&](Rebuild& b, const Node& n) -> NodeId {
    if (n.op != Op::kZext && n.op != Op::kSext) return kNone;
    if (enumerations[b.old_id()] < 0) return kNone;
    const NodeId packed = n.in[0];
    const Node inner = b.node(packed);
    const auto extended = [&](NodeId id) {
      return n.op == Op::kZext ? b.zext(id, n.width) : b.sext(id, n.width);
    };
    if (inner.op == Op::kMux && b.used_once(packed)) {
      const NodeId then = extended(inner.in[1]);
      return b.mux(inner.in[0], then, extended(inner.in[2]));
    }
    if (inner.width != 1) return kNone;
    const auto one = n.op == Op::kZext ? llvm::APInt(n.width, 1) : llvm::APInt::getAllOnes(n.width);
    const NodeId set = b.value(one);
    return b.mux(packed, set, b.zero(n.width));
  });
}

}  // namespace hlsgen
