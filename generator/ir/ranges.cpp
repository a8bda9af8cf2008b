#include "generator/ir/ranges.hpp"

#include <llvm/Analysis/ValueTracking.h>
#include <llvm/IR/Constants.h>
#include <llvm/IR/Operator.h>
#include <llvm/IR/PatternMatch.h>
#include <llvm/Support/KnownBits.h>

#include <utility>

namespace hlsgen {
namespace {

using llvm::ConstantRange;
using llvm::dyn_cast;
namespace match = llvm::PatternMatch;

constexpr unsigned kBudget = 4000;  // values looked at for one question

ConstantRange full(const llvm::Value* value) {
  return ConstantRange::getFull(value->getType()->getIntegerBitWidth());
}

}  // namespace

ConstantRange Ranges::of(const llvm::Value* value, const llvm::Instruction& at) {
  facts_.clear();
  budget_ = kBudget;
  learn_block(at.getParent());
  return range(value);
}

// What must have held for control to come to a block: the edges that dominate it.
void Ranges::learn_block(const llvm::BasicBlock* block) {
  for (auto* node = dominators_.getNode(block); node != nullptr && node->getIDom() != nullptr;
       node = node->getIDom()) {
    const auto* from = node->getIDom()->getBlock();
    const auto* to = node->getBlock();
    const bool is_only_way = to->getSinglePredecessor() == from;
    if (is_only_way) learn_edge(from, to);
  }
}

void Ranges::learn_edge(const llvm::BasicBlock* from, const llvm::BasicBlock* to) {
  const auto* end = from->getTerminator();
  if (const auto* branch = dyn_cast<llvm::BranchInst>(end)) {
    if (branch->isUnconditional() || branch->getSuccessor(0) == branch->getSuccessor(1)) return;
    learn(branch->getCondition(), branch->getSuccessor(0) == to);
  } else if (const auto* choice = dyn_cast<llvm::SwitchInst>(end)) {
    auto taken = ConstantRange::getEmpty(choice->getCondition()->getType()->getIntegerBitWidth());
    auto rest = taken.inverse();
    for (const auto& entry : choice->cases()) {
      const ConstantRange value(entry.getCaseValue()->getValue());
      if (entry.getCaseSuccessor() == to)
        taken = taken.unionWith(value);
      else
        rest = rest.difference(value);
    }
    learn(choice->getCondition(), choice->getDefaultDest() == to ? taken.unionWith(rest) : taken);
  }
}

void Ranges::learn(const llvm::Value* condition, bool holds) {
  learn(condition, ConstantRange(llvm::APInt(1, holds ? 1 : 0)));
  const llvm::Value* a = nullptr;
  const llvm::Value* b = nullptr;
  if (match::match(condition, match::m_Not(match::m_Value(a)))) return learn(a, !holds);
  if (holds ? match::match(condition, match::m_LogicalAnd(match::m_Value(a), match::m_Value(b)))
            : match::match(condition, match::m_LogicalOr(match::m_Value(a), match::m_Value(b)))) {
    learn(a, holds);
    learn(b, holds);
  }
  const auto* compare = dyn_cast<llvm::ICmpInst>(condition);
  if (compare == nullptr || !compare->getOperand(0)->getType()->isIntegerTy()) return;
  const auto predicate = holds ? compare->getPredicate() : compare->getInversePredicate();
  const auto* bound = dyn_cast<llvm::ConstantInt>(compare->getOperand(1));
  if (bound == nullptr) return;
  if (compare->isEquality()) learn_masked(*compare, predicate == llvm::CmpInst::ICMP_EQ);
  learn(compare->getOperand(0), ConstantRange::makeExactICmpRegion(predicate, bound->getValue()));
}

// (x & 0b110) != 0b110, LLVM's form of x < 6 where x has three bits; (x & 0b100) == 0 for x < 4.
void Ranges::learn_masked(const llvm::ICmpInst& compare, bool equal) {
  const llvm::Value* x = nullptr;
  const llvm::APInt* mask = nullptr;
  const llvm::APInt* bound = nullptr;
  if (!match::match(compare.getOperand(0), match::m_And(match::m_Value(x), match::m_APInt(mask))) ||
      !match::match(compare.getOperand(1), match::m_APInt(bound)) || !mask->isShiftedMask()) {
    return;
  }
  const unsigned width = mask->getActiveBits();
  if (!equal && *bound == *mask) {
    facts_.push_back({x, ConstantRange(llvm::APInt(width, 0), mask->trunc(width))});
  } else if (equal && bound->isZero() && mask->countTrailingZeros() > 0) {
    const auto limit = llvm::APInt::getOneBitSet(width, mask->countTrailingZeros());
    facts_.push_back({x, ConstantRange(llvm::APInt(width, 0), limit)});
  }
}

void Ranges::learn(const llvm::Value* value, const ConstantRange& range) {
  facts_.push_back({value, range});
  // x + c in [a, b), LLVM's form of a two-sided test, says as much of x.
  const llvm::APInt* added = nullptr;
  const llvm::Value* x = nullptr;
  if (match::match(value, match::m_Add(match::m_Value(x), match::m_APInt(added)))) {
    facts_.push_back({x, range.subtract(*added)});
  } else if (const auto* wide = dyn_cast<llvm::ZExtInst>(value)) {
    const unsigned width = wide->getSrcTy()->getIntegerBitWidth();
    const auto inside = range.intersectWith(
        ConstantRange::getFull(width).zeroExtend(value->getType()->getIntegerBitWidth()));
    facts_.push_back({wide->getOperand(0), inside.truncate(width)});
  } else if (match::match(value, match::m_And(match::m_Value(x), match::m_APInt(added))) &&
             added->isMask()) {
    // The lower bits of x, as a trunc would give them.
    const unsigned width = added->getActiveBits();
    const auto inside = range.intersectWith(
        ConstantRange::getFull(width).zeroExtend(value->getType()->getIntegerBitWidth()));
    facts_.push_back({x, inside.truncate(width)});
  }
}

ConstantRange Ranges::range(const llvm::Value* value) {
  if (const auto* constant = dyn_cast<llvm::ConstantInt>(value)) {
    return ConstantRange(constant->getValue());
  }
  if (!value->getType()->isIntegerTy()) return full(value);
  if (is_everywhere_ || budget_ == 0) return everywhere(value);
  --budget_;
  auto result = by_bits(value);
  const auto* cut = dyn_cast<llvm::TruncInst>(value);
  for (const auto& fact : facts_) {
    const bool is_own = fact.value == value || (cut != nullptr && fact.value == cut->getOperand(0));
    if (is_own && fact.range.getBitWidth() == result.getBitWidth()) {
      result = result.intersectWith(fact.range);
    }
  }
  return result;
}

ConstantRange Ranges::everywhere(const llvm::Value* value) {
  const auto known = everywhere_.find(value);
  if (known != everywhere_.end()) return known->second;
  const bool before = std::exchange(is_everywhere_, true);
  const auto result = by_bits(value);
  is_everywhere_ = before;
  everywhere_.emplace(value, result);
  return result;
}

// x + x is even: then x + x < 14 is as good as x + x != 14 to LLVM; bits tell what ranges do not.
ConstantRange Ranges::by_bits(const llvm::Value* value) {
  const auto bits = llvm::computeKnownBits(value, data_);
  return by_operands(value).intersectWith(ConstantRange::fromKnownBits(bits, false),
                                          ConstantRange::Unsigned);
}

ConstantRange Ranges::by_operands(const llvm::Value* value) {
  const auto* at = dyn_cast<llvm::Instruction>(value);
  if (at == nullptr) return full(value);
  if (const auto* bounds = at->getMetadata(llvm::LLVMContext::MD_range)) {
    return llvm::getConstantRangeFromMetadata(*bounds);
  }
  if (const auto* binary = dyn_cast<llvm::BinaryOperator>(at)) {
    return range(binary->getOperand(0)).binaryOp(binary->getOpcode(), range(binary->getOperand(1)));
  }
  if (llvm::isa<llvm::ZExtInst, llvm::SExtInst, llvm::TruncInst>(at)) {
    return range(at->getOperand(0))
        .castOp(llvm::cast<llvm::CastInst>(at)->getOpcode(), at->getType()->getIntegerBitWidth());
  }
  if (const auto* choice = dyn_cast<llvm::SelectInst>(at)) return select(*choice);
  if (const auto* merge = dyn_cast<llvm::PHINode>(at)) return phi(*merge);
  if (const auto* call = dyn_cast<llvm::CallInst>(at)) {
    const auto id = call->getIntrinsicID();
    if (!ConstantRange::isIntrinsicSupported(id)) return full(value);
    std::vector<ConstantRange> operands;
    for (const auto& operand : call->args()) operands.push_back(range(operand));
    return ConstantRange::intrinsic(id, operands);
  }
  if (llvm::isa<llvm::FreezeInst>(at)) return range(at->getOperand(0));
  return full(value);
}

ConstantRange Ranges::select(const llvm::SelectInst& choice) {
  if (is_everywhere_) return range(choice.getTrueValue()).unionWith(range(choice.getFalseValue()));
  const auto before = facts_.size();
  auto result = ConstantRange::getEmpty(choice.getType()->getIntegerBitWidth());
  for (const bool holds : {true, false}) {
    learn(choice.getCondition(), holds);
    result = result.unionWith(range(holds ? choice.getTrueValue() : choice.getFalseValue()));
    facts_.erase(facts_.begin() + static_cast<std::ptrdiff_t>(before), facts_.end());
  }
  return result;
}

ConstantRange Ranges::phi(const llvm::PHINode& phi) {
  // What holds where the phi is used need not hold where its values came from, except in what both
  // lie below; the facts of each edge replace the others.
  auto result = ConstantRange::getEmpty(phi.getType()->getIntegerBitWidth());
  if (is_everywhere_) {
    for (const auto& value : phi.incoming_values()) result = result.unionWith(range(value));
    return result;
  }
  const auto outer = facts_;
  for (unsigned i = 0; i < phi.getNumIncomingValues(); ++i) {
    facts_.clear();
    learn_block(phi.getIncomingBlock(i));
    learn_edge(phi.getIncomingBlock(i), phi.getParent());
    result = result.unionWith(range(phi.getIncomingValue(i)));
  }
  facts_ = outer;
  return result;
}

}  // namespace hlsgen
