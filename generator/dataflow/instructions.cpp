#include "generator/dataflow/instructions.hpp"

#include <llvm/IR/Constants.h>
#include <llvm/IR/IntrinsicInst.h>

#include "generator/dataflow/intrinsics.hpp"
#include "generator/refusal.hpp"

namespace hlsgen {
namespace {

[[noreturn]] void refuse(const llvm::Instruction& at, const std::string& what,
                         const std::string& mend) {
  throw Refusal(source_of(at), what, mend);
}

NodeId comparison(NodeBuilder& nodes, const llvm::ICmpInst& at, NodeId a, NodeId b) {
  using Predicate = llvm::CmpInst;
  switch (at.getPredicate()) {
    case Predicate::ICMP_EQ:
      return nodes.compare(Op::kEq, a, b);
    case Predicate::ICMP_NE:
      return nodes.compare(Op::kNe, a, b);
    case Predicate::ICMP_ULT:
      return nodes.compare(Op::kUlt, a, b);
    case Predicate::ICMP_ULE:
      return nodes.compare(Op::kUle, a, b);
    case Predicate::ICMP_UGT:
      return nodes.compare(Op::kUlt, b, a);
    case Predicate::ICMP_UGE:
      return nodes.compare(Op::kUle, b, a);
    case Predicate::ICMP_SLT:
      return nodes.compare(Op::kSlt, a, b);
    case Predicate::ICMP_SLE:
      return nodes.compare(Op::kSle, a, b);
    case Predicate::ICMP_SGT: {
      const auto* constant = llvm::dyn_cast<llvm::ConstantInt>(at.getOperand(1));
      if (constant != nullptr && constant->isMinusOne()) {  // not negative
        return nodes.unary_not(nodes.bit(a, nodes.width(a) - 1));
      }
      return nodes.compare(Op::kSlt, b, a);
    }
    default:
      return nodes.compare(Op::kSle, b, a);
  }
}

// x / 2^k, rounded towards zero: a negative x is moved up by 2^k - 1 first.
NodeId signed_division(NodeBuilder& nodes, NodeId x, unsigned k) {
  if (k == 0) return x;
  const unsigned width = nodes.width(x);
  const NodeId sign = nodes.bit(x, width - 1);
  const NodeId bias = nodes.zext(nodes.sext(sign, k), width);
  return nodes.shift(Op::kAshr, nodes.binary(Op::kAdd, x, bias), nodes.constant(width, k));
}

// By 2^k, and by -2^k, LLVM's form of -x / 2^k.
NodeId division(NodeBuilder& nodes, const llvm::BinaryOperator& at, NodeId x) {
  const auto* divisor = llvm::dyn_cast<llvm::ConstantInt>(at.getOperand(1));
  const bool is_signed =
      at.getOpcode() == llvm::Instruction::SDiv || at.getOpcode() == llvm::Instruction::SRem;
  const bool is_remainder =
      at.getOpcode() == llvm::Instruction::URem || at.getOpcode() == llvm::Instruction::SRem;
  const bool is_negative = is_signed && divisor != nullptr && divisor->isNegative();
  const llvm::APInt size = divisor == nullptr ? llvm::APInt() : divisor->getValue();
  const llvm::APInt magnitude = is_negative ? -size : size;
  if (divisor == nullptr || !magnitude.isPowerOf2()) {
    refuse(at,
           divisor == nullptr ? "division by what is only known at run time"
                              : "division by a constant that is no power of two",
           "multiply by a reciprocal, or divide by a power of two");
  }
  const unsigned k = magnitude.logBase2();
  const unsigned width = nodes.width(x);
  if (!is_signed) {
    if (k == 0) return is_remainder ? nodes.constant(width, 0) : x;
    return is_remainder ? nodes.zext(nodes.slice(x, k, 0), width)
                        : nodes.shift(Op::kLshr, x, nodes.constant(width, k));
  }
  const NodeId quotient = signed_division(nodes, x, k);
  if (!is_remainder) {
    return is_negative ? nodes.binary(Op::kSub, nodes.constant(width, 0), quotient) : quotient;
  }
  const NodeId product = nodes.shift(Op::kShl, quotient, nodes.constant(width, k));
  return nodes.binary(Op::kSub, x, product);
}

NodeId arithmetic(NodeBuilder& nodes, const llvm::BinaryOperator& at, NodeId a, NodeId b) {
  switch (at.getOpcode()) {
    case llvm::Instruction::Add:
      return nodes.binary(Op::kAdd, a, b);
    case llvm::Instruction::Sub:
      return nodes.binary(Op::kSub, a, b);
    case llvm::Instruction::Mul:
      return nodes.binary(Op::kMul, a, b);
    case llvm::Instruction::And:
      return nodes.binary(Op::kAnd, a, b);
    case llvm::Instruction::Or:
      return nodes.binary(Op::kOr, a, b);
    case llvm::Instruction::Xor:
      return nodes.binary(Op::kXor, a, b);
    case llvm::Instruction::Shl:
      return nodes.shift(Op::kShl, a, b);
    case llvm::Instruction::LShr:
      return nodes.shift(Op::kLshr, a, b);
    case llvm::Instruction::AShr:
      return nodes.shift(Op::kAshr, a, b);
    default:
      return division(nodes, at, a);
  }
}

}  // namespace

NodeId instruction(NodeBuilder& nodes, const llvm::Instruction& at, const std::vector<NodeId>& in) {
  const auto width = [&] { return at.getType()->getIntegerBitWidth(); };
  if (const auto* binary = llvm::dyn_cast<llvm::BinaryOperator>(&at)) {
    return arithmetic(nodes, *binary, in[0], in[1]);
  }
  if (const auto* compare = llvm::dyn_cast<llvm::ICmpInst>(&at)) {
    return comparison(nodes, *compare, in[0], in[1]);
  }
  switch (at.getOpcode()) {
    case llvm::Instruction::Trunc:
      return nodes.slice(in[0], width(), 0);
    case llvm::Instruction::ZExt:
      return nodes.zext(in[0], width());
    case llvm::Instruction::SExt:
      return nodes.sext(in[0], width());
    case llvm::Instruction::Freeze:
      return in[0];
    case llvm::Instruction::Select:
      return nodes.mux(in[0], in[1], in[2]);
    default:
      break;
  }
  std::string name = at.getOpcodeName();
  if (const auto* call = llvm::dyn_cast<llvm::IntrinsicInst>(&at)) {
    const NodeId result = intrinsic(nodes, call->getIntrinsicID(), in);
    if (result != kNone) return result;
    name = call->getCalledFunction()->getName().str();
  }
  refuse(at, "an operation without a circuit (" + name + ")",
         "write it with + - * & | ^ << >> and comparisons");
}

}  // namespace hlsgen
