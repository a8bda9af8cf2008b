#include "generator/passes/demanded_bits.hpp"

namespace hlsgen {
namespace {

using llvm::APInt;

class Demand {
 public:
  Demand(const Module& m, const std::vector<Known>& known) : m_(m), known_(known) {
    for (const Node& n : m.nodes) bits_.emplace_back(n.width, 0);
  }

  std::vector<APInt> run() {
    for (const Output& o : m_.outputs) bits_[o.value].setAllBits();
    for (const Register& r : m_.registers) bits_[r.next].setAllBits();
    for (const Instance& i : m_.instances)
      for (const NodeId input : i.inputs) bits_[input].setAllBits();
    for (NodeId id = m_.nodes.size(); id-- > 0;)
      if (!bits_[id].isZero()) pass_on(m_.nodes[id], bits_[id]);
    return std::move(bits_);
  }

 private:
  void pass_on(const Node& n, const APInt& d) {
    const auto all = [&](std::size_t i) { bits_[n.in[i]].setAllBits(); };
    const auto known = [&](std::size_t i) -> const llvm::KnownBits& { return known_[n.in[i]].bits; };
    // A carry runs upwards only.
    const APInt below = APInt::getLowBitsSet(n.width, d.getActiveBits());
    switch (n.op) {
      case Op::kAdd: case Op::kSub: case Op::kMul:
        bits_[n.in[0]] |= below;
        bits_[n.in[1]] |= below;
        return;
      case Op::kAnd:
        bits_[n.in[0]] |= d & ~known(1).Zero;
        bits_[n.in[1]] |= d & ~known(0).Zero;
        // Where both are known, the rule above would lose both of them.
        bits_[n.in[0]] |= d & known(0).Zero & known(1).Zero;
        return;
      case Op::kOr:
        bits_[n.in[0]] |= d & ~known(1).One;
        bits_[n.in[1]] |= d & ~known(0).One;
        bits_[n.in[0]] |= d & known(0).One & known(1).One;
        return;
      case Op::kXor:
        bits_[n.in[0]] |= d;
        bits_[n.in[1]] |= d;
        return;
      case Op::kNot: bits_[n.in[0]] |= d; return;
      case Op::kMux:
        all(0);
        bits_[n.in[1]] |= d;
        bits_[n.in[2]] |= d;
        return;
      case Op::kShl:
        bits_[n.in[0]] |= below;
        all(1);
        return;
      case Op::kSlice: bits_[n.in[0]] |= d.zext(bits_[n.in[0]].getBitWidth()).shl(n.low); return;
      case Op::kConcat: {
        unsigned low = n.width;
        for (const NodeId part : n.in) {
          low -= m_.nodes[part].width;
          bits_[part] |= d.extractBits(m_.nodes[part].width, low);
        }
        return;
      }
      case Op::kZext: case Op::kSext: {
        const unsigned inner = m_.nodes[n.in[0]].width;
        bits_[n.in[0]] |= d.trunc(inner);
        if (n.op == Op::kSext && d.getActiveBits() > inner) bits_[n.in[0]].setBit(inner - 1);
        return;
      }
      default:
        for (std::size_t i = 0; i < n.in.size(); ++i) all(i);
    }
  }

  const Module& m_;
  const std::vector<Known>& known_;
  std::vector<APInt> bits_;
};

}  // namespace

std::vector<APInt> demanded_bits(const Module& module, const std::vector<Known>& known) {
  return Demand(module, known).run();
}

}  // namespace hlsgen
