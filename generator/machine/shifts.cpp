#include "generator/machine/shifts.hpp"

#include "generator/passes/rebuild.hpp"

namespace hlsgen::machine {

void expand_shifts(Module& sample) {
  rewrite(sample, [](Rebuild& b, const Node& n) -> NodeId {
    const bool shifts = n.op == Op::kShl || n.op == Op::kLshr || n.op == Op::kAshr;
    if (!shifts || b.constant(n.in[1]) != nullptr) return kNone;
    const auto by = [&](NodeId value, unsigned amount) {
      Node shift = n;
      shift.in = {value, b.value(llvm::APInt(32, amount))};
      return b.add(shift);
    };
    NodeId value = n.in[0];
    NodeId beyond = kNone;
    const unsigned bits = b.width(n.in[1]);
    for (unsigned k = 0; k < bits; ++k) {
      const NodeId bit = b.slice(n.in[1], k, 1);
      if (k < 16 && (1U << k) < n.width) {
        value = b.mux(bit, by(value, 1U << k), value);
      } else {
        beyond = beyond == kNone ? bit : b.binary(Op::kOr, beyond, bit);
      }
    }
    return beyond == kNone ? value : b.mux(beyond, by(n.in[0], n.width), value);
  });
}

}  // namespace hlsgen::machine
