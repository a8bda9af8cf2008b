#include "generator/ir/opaque.hpp"

#include <llvm/IR/Constants.h>

#include <algorithm>

namespace hlsgen {
namespace {

const llvm::CallInst* call_of(const llvm::Value* value, llvm::StringRef prefix) {
  const auto* call = llvm::dyn_cast<llvm::CallInst>(value);
  if (call == nullptr || call->getCalledFunction() == nullptr) return nullptr;
  return call->getCalledFunction()->getName().startswith(prefix) ? call : nullptr;
}

std::uint64_t constant(const llvm::CallInst* call, unsigned operand) {
  return llvm::cast<llvm::ConstantInt>(call->getArgOperand(operand))->getZExtValue();
}

std::string width_of(const llvm::Type* type) {
  return "i" + std::to_string(type->getIntegerBitWidth());
}

}  // namespace

llvm::FunctionCallee Opaque::declare(const std::string& name, llvm::Type* result,
                                     llvm::ArrayRef<llvm::Type*> parameters) {
  auto callee =
      module_.getOrInsertFunction(name, llvm::FunctionType::get(result, parameters, false));
  auto* function = llvm::cast<llvm::Function>(callee.getCallee());
  function->setDoesNotAccessMemory();
  function->setDoesNotThrow();
  function->addFnAttr(llvm::Attribute::WillReturn);
  function->addFnAttr(llvm::Attribute::NoFree);
  function->addFnAttr(llvm::Attribute::NoSync);
  return callee;
}

llvm::ConstantInt* Opaque::add(Site site) {
  sites_.push_back(std::move(site));
  return llvm::ConstantInt::get(llvm::Type::getInt32Ty(module_.getContext()), sites_.size() - 1);
}

llvm::CallInst* Opaque::undefined(llvm::IRBuilder<>& builder, llvm::Type* type, Site site) {
  auto* id = add(std::move(site));
  return builder.CreateCall(declare("hlsgen.undefined." + width_of(type), type, {id->getType()}),
                            {id});
}

llvm::CallInst* Opaque::index(llvm::IRBuilder<>& builder, llvm::Value* value, std::uint64_t count,
                              Site site) {
  auto* type = value->getType();
  auto* id = add(std::move(site));
  auto* bound = builder.getInt64(count);
  return builder.CreateCall(
      declare("hlsgen.index." + width_of(type), type, {type, bound->getType(), id->getType()}),
      {value, bound, id});
}

llvm::CallInst* Opaque::table(llvm::IRBuilder<>& builder, llvm::Value* address, Table table) {
  // The width first: entries of different widths do not compare.
  const auto is_it = [&](const Table& known) {
    return known.width == table.width && known.name == table.name &&
           known.entries == table.entries;
  };
  const auto number = static_cast<std::size_t>(
      std::find_if(tables_.begin(), tables_.end(), is_it) - tables_.begin());
  auto* result = builder.getIntNTy(table.width);
  if (number == tables_.size()) tables_.push_back(std::move(table));
  const std::string name = "hlsgen.table." + std::to_string(number) + "." +
                           width_of(address->getType()) + "." + width_of(result);
  auto callee = declare(name, result, {builder.getInt32Ty(), address->getType()});
  llvm::cast<llvm::Function>(callee.getCallee())->addFnAttr(llvm::Attribute::Speculatable);
  return builder.CreateCall(callee, {builder.getInt32(number), address});
}

OpaqueKind opaque_kind(const llvm::Value* value) {
  if (call_of(value, "hlsgen.undefined.") != nullptr) return OpaqueKind::kUndefined;
  if (call_of(value, "hlsgen.index.") != nullptr) return OpaqueKind::kIndex;
  if (call_of(value, "hlsgen.table.") != nullptr) return OpaqueKind::kTable;
  return OpaqueKind::kNone;
}

unsigned site_of(const llvm::CallInst* call) {
  const bool is_index = opaque_kind(call) == OpaqueKind::kIndex;
  return static_cast<unsigned>(constant(call, is_index ? 2 : 0));
}
std::uint64_t count_of(const llvm::CallInst* call) { return constant(call, 1); }
unsigned table_of(const llvm::CallInst* call) { return static_cast<unsigned>(constant(call, 0)); }

}  // namespace hlsgen
