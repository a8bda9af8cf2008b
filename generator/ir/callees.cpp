#include "generator/ir/callees.hpp"

#include <llvm/Demangle/Demangle.h>
#include <llvm/IR/InstIterator.h>
#include <llvm/IR/Instructions.h>
#include <llvm/IR/IntrinsicInst.h>
#include <llvm/Support/Path.h>

#include <algorithm>
#include <set>

#include "generator/refusal.hpp"

namespace hlsgen {
namespace {

using llvm::dyn_cast;
using llvm::isa;

bool is_heap(llvm::StringRef name) {
  return name.startswith("_Znw") || name.startswith("_Zna") || name.startswith("_Zdl") ||
         name.startswith("_Zda") || name == "malloc" || name == "calloc" || name == "realloc" ||
         name == "free";
}

class Walk {
 public:
  explicit Walk(const Blocks& blocks) : blocks_(blocks) {}

  void function(llvm::Function& function) {
    if (!done_.insert(&function).second) return;
    path_.push_back(&function);
    for (auto& instruction : llvm::instructions(function)) {
      if (!isa<llvm::DbgInfoIntrinsic>(instruction)) check(instruction);
    }
    path_.pop_back();
  }

 private:
  // Inside the standard library a line says little: the call that led there says more.
  [[noreturn]] void refuse(const llvm::Instruction& at, const std::string& what,
                           const std::string& mend) const {
    SourceLine where = source_of(at);
    for (auto call = calls_.rbegin(); call != calls_.rend(); ++call) {
      if (!llvm::sys::path::is_absolute(where.file)) break;
      where = source_of(**call);
    }
    throw Refusal(where, what, mend);
  }

  void check(llvm::Instruction& at) {
    if (at.getType()->isFPOrFPVectorTy() ||
        std::any_of(at.op_begin(), at.op_end(),
                    [](const llvm::Use& use) { return use->getType()->isFPOrFPVectorTy(); })) {
      refuse(at, "floating point", "use fixed point (UInt<W>, Int<W>)");
    }
    if (at.isVolatile())
      refuse(at, "volatile access", "read pins through In, write them through Out");
    if (at.isAtomic()) refuse(at, "atomic access", "a block is one thread: drop the atomic");
    if (isa<llvm::InvokeInst, llvm::ResumeInst, llvm::LandingPadInst>(at)) {
      refuse(at, "exceptions", "report errors in Out");
    }
    const auto* variable = dyn_cast<llvm::AllocaInst>(&at);
    if (variable != nullptr && !isa<llvm::ConstantInt>(variable->getArraySize())) {
      refuse(at, "an array whose size is not constant", "give it a constant size");
    }
    for (const auto& operand : at.operands()) check_constant(at, operand);
    if (auto* call = dyn_cast<llvm::CallInst>(&at)) check_call(*call);
  }

  void check_constant(const llvm::Instruction& at, const llvm::Value* value) {
    if (const auto* global = dyn_cast<llvm::GlobalVariable>(value)) {
      if (!global->isConstant()) {
        refuse(at, "state outside the registers: '" + readable(*global) + "' is static or global",
               "make it a member of the block, or constexpr");
      }
      if (!global->hasInitializer()) {
        refuse(at, "the value of '" + readable(*global) + "' is not known here",
               "make it constexpr and define it in a header");
      }
    } else if (const auto* expression = dyn_cast<llvm::ConstantExpr>(value)) {
      for (const auto& operand : expression->operands()) check_constant(at, operand);
    }
  }

  void check_call(llvm::CallInst& call) {
    if (call.isInlineAsm()) refuse(call, "assembler", "say it in C++");
    auto* callee = call.getCalledFunction();
    if (callee == nullptr) {
      refuse(call, "a call through a pointer (virtual, or pointer to function)",
             "choose the function by a template argument");
    }
    if (callee->isIntrinsic() || blocks_.is_tick(callee)) return;
    const std::string name = readable(*callee);
    if (is_heap(callee->getName())) {
      refuse(call, "memory from the heap ('" + name + "')", "use a member or a std::array");
    }
    const auto name_starts = [&](const char* text) { return callee->getName().startswith(text); };
    if (name_starts("__atomic_")) {
      refuse(call, "atomic access", "a block is one thread: drop the atomic");
    }
    if (name_starts("__cxa_guard")) {
      refuse(call, "state outside the registers: a static local", "make it a member of the block");
    }
    if (callee->isDeclaration()) {
      refuse(call, "the body of '" + name + "' is not known here", "define it in a header");
    }
    if (std::find(path_.begin(), path_.end(), callee) != path_.end()) {
      refuse(call, "recursion: '" + name + "' calls itself",
             "write it as a loop with a constant bound");
    }
    calls_.push_back(&call);
    function(*callee);
    calls_.pop_back();
  }

  static std::string readable(const llvm::GlobalValue& value) {
    return llvm::demangle(value.getName().str());
  }

  const Blocks& blocks_;
  std::set<const llvm::Function*> done_;
  std::vector<const llvm::Function*> path_;
  std::vector<const llvm::CallInst*> calls_;
};

}  // namespace

void check_callees(llvm::Function& function, const Blocks& blocks) {
  Walk(blocks).function(function);
}

}  // namespace hlsgen
