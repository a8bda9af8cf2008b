#include "generator/passes/constant_registers.hpp"

#include "generator/passes/evaluate.hpp"
#include "generator/passes/rebuild.hpp"

#include <optional>

namespace hlsgen {
namespace {

using llvm::APInt;

// Takes every register for constant, and gives up those whose next value disagrees, until none does.
class Constants {
 public:
  explicit Constants(const Module& m) : m_(m), stays(m.registers.size(), true) {
    while (drop_some()) {
    }
  }

 private:
  bool drop_some() {
    std::vector<std::optional<APInt>> value(m_.nodes.size());
    for (NodeId id = 0; id < m_.nodes.size(); ++id) value[id] = value_of(m_.nodes[id], value);
    bool dropped = false;
    for (std::size_t r = 0; r < m_.registers.size(); ++r) {
      if (!stays[r] || value[m_.registers[r].next] == m_.registers[r].reset) continue;
      stays[r] = false;
      dropped = true;
    }
    return dropped;
  }

  std::optional<APInt> value_of(const Node& n,
                                const std::vector<std::optional<APInt>>& value) const {
    switch (n.op) {
      case Op::kConstant: return n.value;
      case Op::kInput: case Op::kInstanceOutput: return std::nullopt;
      case Op::kRegister:
        if (stays[n.index]) return m_.registers[n.index].reset;
        return std::nullopt;
      case Op::kMux: {
        const auto &c = value[n.in[0]], &t = value[n.in[1]], &o = value[n.in[2]];
        if (c) return c->isZero() ? o : t;
        if (t && o && *t == *o) return t;
        return std::nullopt;
      }
      case Op::kAnd:
        for (const NodeId operand : n.in)
          if (value[operand] && value[operand]->isZero()) return value[operand];
        break;
      case Op::kOr:
        for (const NodeId operand : n.in)
          if (value[operand] && value[operand]->isAllOnes()) return value[operand];
        break;
      default: break;
    }
    std::vector<APInt> in;
    for (const NodeId operand : n.in) {
      if (!value[operand]) return std::nullopt;
      in.push_back(*value[operand]);
    }
    return evaluate(m_, n, in);
  }

  const Module& m_;

 public:
  std::vector<bool> stays;
};

}  // namespace

bool constant_registers(Module& module) {
  const Constants constants(module);
  return rewrite(module, [&](Rebuild& b, const Node& n) -> NodeId {
    if (n.op != Op::kRegister || !constants.stays[n.index]) return kNone;
    return b.value(b.module().registers[n.index].reset);
  });
}

}  // namespace hlsgen
