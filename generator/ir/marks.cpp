#include "generator/ir/marks.hpp"

#include <llvm/IR/DebugInfo.h>
#include <llvm/IR/InstIterator.h>
#include <llvm/IR/Instructions.h>
#include <llvm/IR/IntrinsicInst.h>

#include <map>

#include "generator/ir/numbers.hpp"
#include "generator/refusal.hpp"

namespace hlsgen {
namespace {

using llvm::dyn_cast;

Site site_of_variable(llvm::AllocaInst& variable) {
  for (auto* declaration : llvm::FindDbgDeclareUses(&variable)) {
    return {
        source_of(*declaration),
        "'" + declaration->getVariable()->getName().str() + "' may be read before it has a value",
        "give it an initial value"};
  }
  return {source_of(variable), "a value may be read before it was written",
          "give every variable and every path an initial value"};
}

void mark(llvm::Instruction* before, llvm::AllocaInst& variable, const Site& site, Opaque& opaque) {
  llvm::IRBuilder<> builder(before);
  const auto& data = variable.getModule()->getDataLayout();
  for (const auto& number : numbers_in(variable.getAllocatedType(), data)) {
    if (number.type->isPointerTy()) continue;  // there is no saying where it would point to
    auto* place = builder.CreateConstInBoundsGEP1_64(builder.getInt8Ty(), &variable, number.offset);
    builder.CreateStore(opaque.undefined(builder, number.type, site), place);
  }
}

}  // namespace

void mark_variables(llvm::Function& function, Opaque& opaque) {
  std::vector<llvm::AllocaInst*> variables;
  std::vector<llvm::IntrinsicInst*> lifetimes;
  std::map<const llvm::Value*, std::vector<llvm::IntrinsicInst*>> starts;
  for (auto& instruction : llvm::instructions(function)) {
    if (auto* variable = dyn_cast<llvm::AllocaInst>(&instruction)) variables.push_back(variable);
    auto* intrinsic = dyn_cast<llvm::IntrinsicInst>(&instruction);
    if (intrinsic == nullptr || !intrinsic->isLifetimeStartOrEnd()) continue;
    lifetimes.push_back(intrinsic);
    if (intrinsic->getIntrinsicID() != llvm::Intrinsic::lifetime_start) continue;
    starts[intrinsic->getArgOperand(1)->stripPointerCasts()].push_back(intrinsic);
  }
  for (auto* variable : variables) {
    if (variable->getName().startswith("hlsgen.")) continue;  // ours: filled number by number
    const auto site = site_of_variable(*variable);
    const auto found = starts.find(variable);
    if (found == starts.end()) {
      mark(variable->getNextNode(), *variable, site, opaque);
      continue;
    }
    for (auto* start : found->second) mark(start, *variable, site, opaque);
  }
  for (auto* lifetime : lifetimes) lifetime->eraseFromParent();
}

void check_marks(const llvm::Function& function, const Opaque& opaque) {
  for (const auto& instruction : llvm::instructions(function)) {
    if (opaque_kind(&instruction) != OpaqueKind::kUndefined || instruction.use_empty()) continue;
    const auto& site = opaque.site(site_of(llvm::cast<llvm::CallInst>(&instruction)));
    throw Refusal(site.where, site.what, site.mend);
  }
}

}  // namespace hlsgen
