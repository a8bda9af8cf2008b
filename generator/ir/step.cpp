#include "generator/ir/step.hpp"

#include <llvm/IR/MDBuilder.h>

#include <algorithm>

namespace hlsgen {
namespace {

llvm::GlobalVariable* new_global(llvm::Module& module, const std::string& name, unsigned width) {
  return new llvm::GlobalVariable(module, llvm::IntegerType::get(module.getContext(), width), false,
                                  llvm::GlobalValue::ExternalLinkage, nullptr, name);
}

// A struct with exactly the leaves, so that later passes find the numbers by offset.
llvm::Type* memory_of(llvm::Module& module, const Layout& layout) {
  auto& context = module.getContext();
  std::vector<llvm::Type*> elements;
  std::uint64_t end = 0;
  const auto pad_to = [&](std::uint64_t offset) {
    if (offset <= end) return;
    elements.push_back(llvm::ArrayType::get(llvm::Type::getInt8Ty(context), offset - end));
    end = offset;
  };
  for (const auto& place : layout.leaves) {
    pad_to(place.offset);
    elements.push_back(llvm::IntegerType::get(context, place.storage_bits));
    end = place.offset + module.getDataLayout().getTypeAllocSize(elements.back());
  }
  pad_to(layout.size);
  return llvm::StructType::get(context, elements, /*isPacked=*/true);
}

llvm::Value* address(llvm::IRBuilder<>& builder, llvm::Value* base, std::uint64_t offset) {
  if (offset == 0) return base;
  return builder.CreateConstInBoundsGEP1_64(builder.getInt8Ty(), base, offset);
}

llvm::Function* new_function(llvm::Module& module, const std::string& name) {
  auto* type = llvm::FunctionType::get(llvm::Type::getVoidTy(module.getContext()), false);
  auto* function = llvm::Function::Create(type, llvm::GlobalValue::ExternalLinkage, name, module);
  llvm::BasicBlock::Create(module.getContext(), "entry", function);
  return function;
}

llvm::AllocaInst* new_memory(llvm::IRBuilder<>& builder, const Layout& layout, const char* name) {
  auto& module = *builder.GetInsertBlock()->getModule();
  auto* memory = builder.CreateAlloca(memory_of(module, layout), nullptr, name);
  memory->setAlignment(llvm::Align(16));
  return memory;
}

void call(llvm::IRBuilder<>& builder, llvm::Function* function,
          llvm::ArrayRef<llvm::Value*> arguments) {
  auto* call = builder.CreateCall(function, arguments);
  call->setCallingConv(function->getCallingConv());
  call->setAttributes(function->getAttributes());
}

Layout sorted_by_offset(Layout layout) {
  std::stable_sort(layout.leaves.begin(), layout.leaves.end(),
                   [](const auto& a, const auto& b) { return a.offset < b.offset; });
  return layout;
}

void append_leaves(const Block& block, const Blocks& blocks, const std::string& prefix,
                   std::uint64_t offset, Layout& all) {
  for (auto place : block.state.leaves) {
    place.leaf.name = prefix + place.leaf.name;
    place.offset += offset;
    all.leaves.push_back(place);
  }
  for (const auto& instance : block.state.instances) {
    append_leaves(blocks.of(instance.type), blocks, prefix + instance.name + ".",
                  offset + instance.offset, all);
  }
}

std::uint64_t enumerators_of(const LeafPlace& place) {
  if (place.enumeration == nullptr) return 0;
  std::uint64_t largest = 0;
  for (const auto& value : enumeration_of(place.enumeration).values) {
    largest = std::max(largest, value.second);
  }
  return largest + 1;
}

}  // namespace

Layout whole_state(const Block& block, const Blocks& blocks) {
  Layout all;
  all.size = block.state.size;
  append_leaves(block, blocks, "", 0, all);
  return sorted_by_offset(all);
}

void store_leaf(llvm::IRBuilder<>& builder, const LeafPlace& place, llvm::Value* base,
                llvm::Value* exact) {
  builder.CreateStore(builder.CreateZExt(exact, builder.getIntNTy(place.storage_bits)),
                      address(builder, base, place.offset));
}

llvm::Value* load_leaf(llvm::IRBuilder<>& builder, const LeafPlace& place, llvm::Value* base,
                       std::uint64_t enumerators, Opaque& opaque) {
  llvm::Value* value = builder.CreateLoad(builder.getIntNTy(place.storage_bits),
                                          address(builder, base, place.offset));
  const bool narrower = place.leaf.width < place.storage_bits;
  if (place.enumeration != nullptr && (narrower || enumerators != 0)) {
    if (enumerators == 0) enumerators = std::uint64_t{1} << place.leaf.width;
    value = opaque.index(
        builder, value, enumerators,
        {place.source, "'" + place.leaf.name + "' may take a value that is no enumerator",
         "compute enumerators by switch or if, or limit the value first", place.leaf.name});
  }
  return builder.CreateTrunc(value, builder.getIntNTy(place.leaf.width));
}

Step build_step(llvm::Module& module, const Block& block, const Blocks& blocks,
                const std::vector<bool>& wide, Opaque& opaque) {
  Step step;
  step.function = new_function(module, "step." + block.module);
  llvm::IRBuilder<> builder(&step.function->getEntryBlock());
  const auto all = whole_state(block, blocks);
  step.state = new_memory(builder, all, "hlsgen.state");
  auto* in = new_memory(builder, sorted_by_offset(block.in), "hlsgen.in");
  auto* out = new_memory(builder, sorted_by_offset(block.out), "hlsgen.out");

  for (const auto& place : block.in.leaves) {
    step.inputs.push_back(new_global(module, "in." + place.leaf.name, place.leaf.width));
    auto* value = builder.CreateLoad(builder.getIntNTy(place.leaf.width), step.inputs.back());
    store_leaf(builder, place, in, value);
  }
  for (const auto& place : block.out.leaves) {
    store_leaf(builder, place, out,
               opaque.undefined(
                   builder, builder.getIntNTy(place.leaf.width),
                   {place.source, "output '" + place.leaf.name + "' may be left without a value",
                    "write a default value behind the member"}));
  }
  for (std::size_t i = 0; i < block.state.leaves.size(); ++i) {
    const auto& place = block.state.leaves[i];
    step.registers.push_back(new_global(module, "reg." + place.leaf.name, place.leaf.width));
    auto* value = builder.CreateLoad(builder.getIntNTy(place.leaf.width), step.registers.back());
    const auto count = enumerators_of(place);
    if (count != 0 && !wide[i] && count < std::uint64_t{1} << place.leaf.width) {
      value->setMetadata(
          llvm::LLVMContext::MD_range,
          llvm::MDBuilder(module.getContext())
              .createRange(llvm::APInt(place.leaf.width, 0), llvm::APInt(place.leaf.width, count)));
    }
    store_leaf(builder, place, step.state, value);
  }
  for (const auto& place : block.state.instances) {
    StepInstance instance{&place, &blocks.of(place.type), {}, {}, {}, {}};
    auto* memory = address(builder, step.state, place.offset);
    for (const auto& child : whole_state(*instance.block, blocks).leaves) {
      auto* mark = opaque.undefined(builder, builder.getIntNTy(child.leaf.width),
                                    {place.source,
                                     "the block reads register '" + child.leaf.name +
                                         "' of its instance '" + place.name + "'",
                                     "make it an output of that block"});
      instance.marks.push_back(site_of(mark));
      store_leaf(builder, child, memory, mark);
    }
    step.instances.push_back(std::move(instance));
  }

  call(builder, block.tick, {out, step.state, in});

  for (std::size_t i = 0; i < block.state.leaves.size(); ++i) {
    const auto& place = block.state.leaves[i];
    auto* value =
        load_leaf(builder, place, step.state, wide[i] ? 0 : enumerators_of(place), opaque);
    step.nexts.push_back(new_global(module, "next." + place.leaf.name, place.leaf.width));
    builder.CreateStore(value, step.nexts.back());
  }
  for (const auto& place : block.out.leaves) {
    step.outputs.push_back(new_global(module, "out." + place.leaf.name, place.leaf.width));
    builder.CreateStore(load_leaf(builder, place, out, 0, opaque), step.outputs.back());
  }
  for (auto& instance : step.instances) {
    auto* memory = address(builder, step.state, instance.place->offset);
    for (auto child : whole_state(*instance.block, blocks).leaves) {
      child.enumeration = nullptr;  // the mark is no enumerator, and need not prove to be one
      instance.kept.push_back(new_global(module, "kept." + child.leaf.name, child.leaf.width));
      builder.CreateStore(load_leaf(builder, child, memory, 0, opaque), instance.kept.back());
    }
  }
  builder.CreateRetVoid();
  return step;
}

Step build_reset(llvm::Module& module, const Blocks& blocks, const Layout& all, Opaque& opaque) {
  Step step;
  step.function = new_function(module, "reset");
  llvm::IRBuilder<> builder(&step.function->getEntryBlock());
  step.state = new_memory(builder, all, "hlsgen.state");
  for (const auto& place : all.leaves) {
    store_leaf(
        builder, place, step.state,
        opaque.undefined(builder, builder.getIntNTy(place.leaf.width),
                         {place.source, "register '" + place.leaf.name + "' has no default value",
                          "write one behind the member; it is the reset value"}));
  }
  call(builder, blocks.reset, {step.state});
  for (const auto& place : all.leaves) {
    step.nexts.push_back(new_global(module, "reset." + place.leaf.name, place.leaf.width));
    builder.CreateStore(load_leaf(builder, place, step.state, 0, opaque), step.nexts.back());
  }
  builder.CreateRetVoid();
  return step;
}

}  // namespace hlsgen
