#include "generator/passes/evaluate.hpp"

#include "generator/backend.hpp"

namespace hlsgen {

using llvm::APInt;

APInt evaluate(const Module& module, const Node& n, const std::vector<APInt>& in) {
  const auto bit = [](bool b) { return APInt(1, b ? 1 : 0); };
  // All of the bits are gone once the amount reaches the width.
  const auto amount = [&] {
    return static_cast<unsigned>(in[1].getLimitedValue(n.width));
  };
  switch (n.op) {
    case Op::kAdd: return in[0] + in[1];
    case Op::kSub: return in[0] - in[1];
    case Op::kMul: return in[0] * in[1];
    case Op::kAnd: return in[0] & in[1];
    case Op::kOr: return in[0] | in[1];
    case Op::kXor: return in[0] ^ in[1];
    case Op::kNot: return ~in[0];
    case Op::kShl: return in[0].shl(amount());
    case Op::kLshr: return in[0].lshr(amount());
    case Op::kAshr: return in[0].ashr(amount());
    case Op::kEq: return bit(in[0] == in[1]);
    case Op::kNe: return bit(in[0] != in[1]);
    case Op::kUlt: return bit(in[0].ult(in[1]));
    case Op::kUle: return bit(in[0].ule(in[1]));
    case Op::kSlt: return bit(in[0].slt(in[1]));
    case Op::kSle: return bit(in[0].sle(in[1]));
    case Op::kMux: return in[0].isZero() ? in[2] : in[1];
    case Op::kSlice: return in[0].extractBits(n.width, n.low);
    case Op::kConcat: {
      APInt all = in[0];
      for (std::size_t i = 1; i < in.size(); ++i) all = all.concat(in[i]);
      return all;
    }
    case Op::kZext: return in[0].zext(n.width);
    case Op::kSext: return in[0].sext(n.width);
    case Op::kTable: {
      const Table& t = module.tables[n.index];
      // Beyond the end stands the last entry again, as in print.
      return t.entries[in[0].getLimitedValue(t.entries.size() - 1)];
    }
    case Op::kConstant: case Op::kInput: case Op::kRegister: case Op::kInstanceOutput: break;
  }
  throw NetlistError("module " + module.name + ": a source has no value of its own");
}

}  // namespace hlsgen
