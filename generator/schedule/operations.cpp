#include "generator/schedule/operations.hpp"

#include <llvm/Support/MathExtras.h>

#include <algorithm>

namespace hlsgen::scheduling {
namespace {

// Look-up tables in a row that take in so many bits, four at a time.
unsigned tree(unsigned bits) {
  unsigned levels = 0;
  for (; bits > 1; bits = (bits + 3) / 4) ++levels;
  return std::max(levels, 1u);
}

unsigned bits_of(std::size_t count) { return count < 2 ? 0 : llvm::Log2_64_Ceil(count); }

unsigned delay_of(const Module& m, const Node& n) {
  const unsigned operand = n.in.empty() ? 0 : m.nodes[n.in[0]].width;
  const bool by_constant = n.in.size() > 1 && m.nodes[n.in[1]].op == Op::kConstant;
  switch (n.op) {
    case Op::kAdd:
    case Op::kSub:
      return kQuarters + 2 + n.width / 2;
    case Op::kUlt:
    case Op::kUle:
    case Op::kSlt:
    case Op::kSle:
      return kQuarters + 2 + operand / 2;
    case Op::kEq:
    case Op::kNe:
      return kQuarters * tree(by_constant ? operand : 2 * operand);
    case Op::kAnd:
    case Op::kOr:
    case Op::kXor:
    case Op::kMux:
      return kQuarters;
    case Op::kShl:
    case Op::kLshr:
    case Op::kAshr:
      return by_constant ? 0 : kQuarters * std::min(bits_of(n.width) + 1, m.nodes[n.in[1]].width);
    case Op::kTable: {
      const unsigned address = bits_of(m.tables[n.index].entries.size());
      return kQuarters * (address <= 4 ? 1 : address - 3);
    }
    default:
      return 0;  // wiring; an inverter goes into its reader
  }
}

}  // namespace

Operations::Operations(const Module& m, const Budget& b)
    : module(m), budget(b), lives(m.nodes.size(), false) {
  for (const Node& n : m.nodes) {
    delay.push_back(delay_of(m, n));
    Kind k = Kind::kLogic;
    if (n.op == Op::kConstant || n.op == Op::kRegister) k = Kind::kSource;
    if (n.op == Op::kInput) k = b.held ? Kind::kSource : Kind::kTaken;
    if (n.op == Op::kMul) k = Kind::kProduct;
    if (n.op == Op::kTable) {
      const Table& t = m.tables[n.index];
      if (t.entries.size() * t.width > kSmallTable) k = Kind::kEntry;
    }
    kind.push_back(k);
  }
  for (const Output& o : m.outputs) sinks.push_back(o.value);
  for (const Register& r : m.registers) sinks.push_back(r.next);
  for (const NodeId sink : sinks) lives[sink] = true;
  for (NodeId id = static_cast<NodeId>(m.nodes.size()); id-- > 0;)
    if (lives[id])
      for (const NodeId operand : m.nodes[id].in) lives[operand] = true;
}

}  // namespace hlsgen::scheduling
