#include "generator/dataflow/variables.hpp"

#include <llvm/BinaryFormat/Dwarf.h>
#include <llvm/IR/DebugInfoMetadata.h>
#include <llvm/IR/InstIterator.h>
#include <llvm/IR/IntrinsicInst.h>

#include "generator/cpp/layout.hpp"
#include "generator/refusal.hpp"

namespace hlsgen {
namespace {

// The member at a bit offset: "phase" or "limits_upper"; empty when the whole is meant.
std::string member_at(const llvm::DIType* type, std::uint64_t bit) {
  const auto* composite = class_of(type);
  if (composite == nullptr) return {};
  if (composite->getTag() == llvm::dwarf::DW_TAG_array_type) {
    const auto* element = class_of(composite->getBaseType());
    const std::uint64_t size =
        element != nullptr ? element->getSizeInBits() : composite->getBaseType()->getSizeInBits();
    if (size == 0) return {};
    return "[" + std::to_string(bit / size) + "]" + member_at(composite->getBaseType(), bit % size);
  }
  if (composite->getTag() == llvm::dwarf::DW_TAG_enumeration_type) return {};
  const llvm::DIDerivedType* found = nullptr;
  unsigned members = 0;
  for (const auto* element : composite->getElements()) {
    const auto* member = llvm::dyn_cast<llvm::DIDerivedType>(element);
    if (member == nullptr || member->getTag() != llvm::dwarf::DW_TAG_member ||
        member->isStaticMember()) {
      continue;
    }
    ++members;
    if (member->getOffsetInBits() <= bit) found = member;
  }
  if (found == nullptr) return {};
  const std::string rest = member_at(found->getBaseType(), bit - found->getOffsetInBits());
  const bool is_number = members == 1 && rest.empty();
  if (is_number || found->getName().startswith("_M_")) return rest;
  return "." + found->getName().str() + rest;
}

std::string name_of(const llvm::DbgVariableIntrinsic& at) {
  const auto* variable = at.getVariable();
  std::uint64_t bit = 0;
  if (const auto fragment = at.getExpression()->getFragmentInfo()) bit = fragment->OffsetInBits;
  return variable->getName().str() + member_at(variable->getType(), bit);
}

// Whether the variable holds the value itself, or a part of a variable: clang keeps a bool in a
// byte, so that after optimisation one bit is converted to it.
bool is_the_value(const llvm::DIExpression& expression) {
  std::uint64_t width = 0;
  for (const auto& operand : expression.expr_ops()) {
    switch (operand.getOp()) {
      case llvm::dwarf::DW_OP_LLVM_convert:
        if (operand.getArg(0) < width) return false;
        width = operand.getArg(0);
        break;
      case llvm::dwarf::DW_OP_LLVM_fragment:
      case llvm::dwarf::DW_OP_stack_value:
        break;
      default:
        return false;
    }
  }
  return true;
}

// Whether the variable is the value inverted: what was `goes` may have become an or of what stands against it.
bool is_the_inverse(const llvm::DIExpression& expression) {
  bool ones = false, inverted = false;
  for (const auto& operand : expression.expr_ops()) {
    switch (operand.getOp()) {
      case llvm::dwarf::DW_OP_constu:
      case llvm::dwarf::DW_OP_consts:
        ones = operand.getArg(0) == 1 || operand.getArg(0) == ~std::uint64_t{0};
        break;
      case llvm::dwarf::DW_OP_xor:
        inverted = ones;
        break;
      case llvm::dwarf::DW_OP_LLVM_convert:
      case llvm::dwarf::DW_OP_stack_value:
        break;
      default:
        return false;
    }
  }
  return inverted;
}

// A lambda, or an operator of a class of the block's own.
bool is_lambda(const llvm::DISubprogram* function) {
  return function != nullptr && function->getName().startswith("operator");
}

// A call that was inlined: which function, and where.
using Frame = std::pair<const llvm::DISubprogram*, const llvm::DILocation*>;

// The innermost one outside the number library.
Frame frame_of(const llvm::DILocation* at) {
  for (; at != nullptr; at = at->getInlinedAt()) {
    const auto* function = at->getScope()->getSubprogram();
    const auto where = source_line(function->getFile(), function->getLine());
    if (is_system_header(where) || is_number_library(where)) continue;
    return {function, at->getInlinedAt()};
  }
  return {};
}

Frame frame_of(const llvm::Instruction& value) {
  if (value.getDebugLoc()) return frame_of(value.getDebugLoc().get());
  const auto* phi = llvm::dyn_cast<llvm::PHINode>(&value);
  if (phi == nullptr) return {};
  for (const auto* block : phi->blocks()) {
    if (const auto& at = block->getTerminator()->getDebugLoc()) return frame_of(at.get());
  }
  return {};
}

bool is_within(const llvm::Instruction& user, const Frame& frame) {
  for (const llvm::DILocation* at = user.getDebugLoc(); at != nullptr; at = at->getInlinedAt()) {
    if (at->getInlinedAt() == frame.second) return true;
  }
  return false;
}

bool names_something(const llvm::DISubprogram& function) {
  return !is_lambda(&function) && function.getName() != "tick";
}

using Reading = bool (*)(const llvm::DIExpression&);  // of a variable's value from another

ValueNames names_in(llvm::Function& function, bool parameters, Reading reading = is_the_value) {
  ValueNames names;
  for (const auto& instruction : llvm::instructions(function)) {
    const auto* at = llvm::dyn_cast<llvm::DbgValueInst>(&instruction);
    if (at == nullptr || at->hasArgList() || at->getVariable()->isArtificial()) continue;
    const auto* variable = at->getVariable();
    if ((variable->getArg() > 0) != parameters || !reading(*at->getExpression())) continue;
    if (parameters && is_lambda(variable->getScope()->getSubprogram())) continue;
    const auto* value = at->getValue(0);
    if (value == nullptr || !llvm::isa<llvm::Instruction>(value)) continue;
    const auto where = source_line(variable->getFile(), variable->getLine());
    if (is_system_header(where) || is_number_library(where)) continue;
    names.try_emplace(value, name_of(*at));
  }
  return names;
}

}  // namespace

ValueNames variable_names(llvm::Function& function) { return names_in(function, false); }
ValueNames parameter_names(llvm::Function& function) { return names_in(function, true); }
ValueNames inverse_names(llvm::Function& function) { return names_in(function, false, is_the_inverse); }

std::string function_of(const llvm::Instruction& instruction) {
  const Frame frame = frame_of(instruction);
  if (frame.second == nullptr || !names_something(*frame.first)) return {};
  const auto name = frame.first->getName();  // observe<steplock::CurrentModel::In>
  return name.take_until([](char c) { return c == '<'; }).str();
}

bool is_returned(const llvm::Instruction& instruction) {
  const Frame frame = frame_of(instruction);
  if (frame.second == nullptr || !names_something(*frame.first)) return false;
  const auto types = frame.first->getType()->getTypeArray();
  if (types.size() == 0 || types[0] == nullptr) return false;  // void
  return llvm::any_of(instruction.users(), [&](const llvm::User* user) {
    const auto* reader = llvm::dyn_cast<llvm::Instruction>(user);
    return reader != nullptr && reader->getDebugLoc() && !is_within(*reader, frame);
  });
}

}  // namespace hlsgen
