#include "generator/ir/instances.hpp"

#include <llvm/IR/Dominators.h>
#include <llvm/IR/InstIterator.h>

#include <algorithm>

#include "generator/refusal.hpp"

namespace hlsgen {
namespace {

using llvm::dyn_cast;

struct Call {
  llvm::CallInst* call = nullptr;
  StepInstance* instance = nullptr;
};

StepInstance& instance_of(llvm::CallInst& call, Step& step) {
  const auto& data = call.getModule()->getDataLayout();
  llvm::APInt offset(64, 0);
  const auto* base = call.getArgOperand(1)->stripAndAccumulateConstantOffsets(data, offset, true);
  for (auto& instance : step.instances) {
    if (base == step.state && offset == instance.place->offset &&
        call.getCalledFunction() == instance.block->tick) {
      return instance;
    }
  }
  throw Refusal(source_of(call), "a tick of a block that is not a member, or not known which",
                "make each block a member and tick it by name or by a constant index");
}

const llvm::BasicBlock* end_of(const llvm::Function& function) {
  for (const auto& block : function) {
    if (llvm::isa<llvm::ReturnInst>(block.getTerminator())) return &block;
  }
  return nullptr;
}

std::vector<Call> calls_in(Step& step, const Blocks& blocks) {
  std::vector<Call> calls;
  llvm::DominatorTree dominators(*step.function);
  const auto* end = end_of(*step.function);
  for (auto& instruction : llvm::instructions(*step.function)) {
    auto* call = dyn_cast<llvm::CallInst>(&instruction);
    if (call == nullptr || !blocks.is_tick(call->getCalledFunction())) continue;
    auto& instance = instance_of(*call, step);
    for (const auto& earlier : calls) {
      if (earlier.instance != &instance) continue;
      throw Refusal(source_of(*call), "'" + instance.place->name + "' is ticked more than once",
                    "tick it once, with an In chosen before");
    }
    if (!dominators.dominates(call->getParent(), end)) {
      throw Refusal(source_of(*call), "'" + instance.place->name + "' is ticked under a condition",
                    "tick it in every clock, and say in its In what is to happen");
    }
    calls.push_back({call, &instance});
  }
  for (const auto& instance : step.instances) {
    const bool found = std::any_of(calls.begin(), calls.end(),
                                   [&](const Call& c) { return c.instance == &instance; });
    if (found) continue;
    throw Refusal(instance.place->source, "'" + instance.place->name + "' is never ticked",
                  "call its tick once in every clock");
  }
  std::sort(calls.begin(), calls.end(),
            [&](const Call& a, const Call& b) { return dominators.dominates(a.call, b.call); });
  return calls;
}

llvm::GlobalVariable* new_global(llvm::Module& module, const std::string& name, unsigned width) {
  return new llvm::GlobalVariable(module, llvm::IntegerType::get(module.getContext(), width), false,
                                  llvm::GlobalValue::ExternalLinkage, nullptr, name);
}

void cut(const Call& at, Opaque& opaque) {
  auto& module = *at.call->getModule();
  auto& instance = *at.instance;
  llvm::IRBuilder<> builder(at.call);
  for (const auto& place : instance.block->in.leaves) {
    auto* value = load_leaf(builder, place, at.call->getArgOperand(2), 0, opaque);
    instance.inputs.push_back(
        new_global(module, instance.place->name + ".in." + place.leaf.name, place.leaf.width));
    builder.CreateStore(value, instance.inputs.back());
  }
  for (const auto& place : instance.block->out.leaves) {
    instance.outputs.push_back(
        new_global(module, instance.place->name + ".out." + place.leaf.name, place.leaf.width));
    auto* value = builder.CreateLoad(builder.getIntNTy(place.leaf.width), instance.outputs.back());
    store_leaf(builder, place, at.call->getArgOperand(0), value);
  }
  at.call->eraseFromParent();
}

}  // namespace

void cut_instances(Step& step, const Blocks& blocks, Opaque& opaque) {
  std::vector<StepInstance> in_order;
  for (const auto& call : calls_in(step, blocks)) {
    cut(call, opaque);
    in_order.push_back(*call.instance);
  }
  step.instances = std::move(in_order);
}

void check_instances(Step& step, const Block& block) {
  for (auto& instance : step.instances) {
    for (std::size_t i = 0; i < instance.kept.size(); ++i) {
      auto* store = llvm::cast<llvm::StoreInst>(*instance.kept[i]->user_begin());
      const auto* mark = dyn_cast<llvm::CallInst>(store->getValueOperand());
      if (mark == nullptr || opaque_kind(mark) != OpaqueKind::kUndefined ||
          site_of(mark) != instance.marks[i]) {
        throw Refusal(
            instance.place->source,
            block.cpp_class + " writes registers of its instance '" + instance.place->name + "'",
            "say in its In what is to happen");
      }
      store->eraseFromParent();
    }
  }
}

}  // namespace hlsgen
