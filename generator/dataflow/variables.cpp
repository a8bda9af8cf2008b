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

}  // namespace

std::map<const llvm::Value*, std::string> variable_names(llvm::Function& function,
                                                         const std::string& file) {
  std::map<const llvm::Value*, std::string> names;
  for (const auto& instruction : llvm::instructions(function)) {
    const auto* at = llvm::dyn_cast<llvm::DbgValueInst>(&instruction);
    if (at == nullptr || at->hasArgList() || at->getVariable()->isArtificial()) continue;
    const auto* expression = at->getExpression();
    const unsigned own = expression->getFragmentInfo() ? 3 : 0;  // the fragment's own operands
    if (expression->getNumElements() != own) continue;
    const auto* value = at->getValue(0);
    if (value == nullptr || !llvm::isa<llvm::Instruction>(value)) continue;
    if (source_line(at->getVariable()->getFile(), 1).file != file) continue;
    names.try_emplace(value, name_of(*at));
  }
  return names;
}

}  // namespace hlsgen
