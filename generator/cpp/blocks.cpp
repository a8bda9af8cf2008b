#include "generator/cpp/blocks.hpp"

#include <llvm/BinaryFormat/Dwarf.h>
#include <llvm/IR/Constants.h>

#include <map>

#include "generator/cpp/memory_class.hpp"
#include "generator/cpp/scheduled.hpp"
#include "generator/names.hpp"
#include "generator/refusal.hpp"

namespace hlsgen {
namespace {

using llvm::dyn_cast;

std::string base_name(const llvm::DICompositeType* type) {
  return type->getName().take_until([](char c) { return c == '<'; }).str();
}

std::string qualified_name(const llvm::DICompositeType* type) {
  std::string name = type->getName().str();
  for (const auto* scope = type->getScope(); scope != nullptr; scope = scope->getScope()) {
    if (!scope->getName().empty() && !llvm::isa<llvm::DIFile>(scope)) {
      name = scope->getName().str() + "::" + name;
    }
  }
  return name;
}

std::string value_in_name(const llvm::DITemplateValueParameter* parameter) {
  const auto* constant =
      llvm::mdconst::dyn_extract_or_null<llvm::ConstantInt>(parameter->getValue());
  if (constant == nullptr) return "x";
  const auto* enumeration = class_of(parameter->getType());
  if (enumeration != nullptr) {
    for (const auto& [name, value] : enumeration_of(enumeration).values) {
      const bool marked = name.size() > 1 && name[0] == 'k' && std::isupper(name[1]) != 0;
      if (value == constant->getZExtValue()) return snake_case(marked ? name.substr(1) : name);
    }
  }
  if (constant->getBitWidth() == 1) return constant->isZero() ? "false" : "true";
  const auto value = constant->getSExtValue();
  return value < 0 ? "m" + std::to_string(-value) : std::to_string(value);
}

std::string module_name(const llvm::DICompositeType* type) {
  std::string name = snake_case(base_name(type));
  for (const auto* parameter : type->getTemplateParams()) {
    if (parameter->isDefault()) continue;
    if (const auto* value = dyn_cast<llvm::DITemplateValueParameter>(parameter)) {
      name += "_" + value_in_name(value);
    } else if (const auto* argument = class_of(parameter->getType())) {
      name += "_" + module_name(argument);
    } else if (parameter->getType() != nullptr) {
      name += "_" + snake_case(parameter->getType()->getName().str());
    }
  }
  return name;
}

// A schedule is called after what it works through, a memory after what it holds.
std::string module_of(const llvm::DICompositeType* type) {
  if (const auto* contents = contents_of(type)) return module_name(contents);
  const auto scheduled = scheduled_class(type);
  return module_name(scheduled ? scheduled->sample : type);
}

const llvm::DICompositeType* parameter_class(const llvm::DISubprogram* method, unsigned position) {
  const auto types = method->getType()->getTypeArray();
  if (types.size() <= position) return nullptr;
  const llvm::DIType* type = types[position];
  const auto* reference = llvm::dyn_cast_or_null<llvm::DIDerivedType>(type);
  const bool by_reference =
      reference != nullptr && reference->getTag() == llvm::dwarf::DW_TAG_reference_type;
  return class_of(by_reference ? reference->getBaseType() : type);
}

class Finder {
 public:
  Finder(llvm::Module& module, Blocks& blocks) : module_(module), blocks_(blocks) {}

  void add(const llvm::DICompositeType* type, bool has_module = true) {
    const auto known = blocks_.index.find(type);
    if (known != blocks_.index.end()) {
      auto& block = blocks_.order[known->second];
      if (has_module && !block.has_module) claim_module(block);
      return;
    }
    Block block;
    block.type = type;
    block.cpp_class = qualified_name(type);
    block.source = source_line(type->getFile(), type->getLine());
    find_tick(block);
    if (const auto scheduled = scheduled_class(type)) {
      block.sample = scheduled->sample;
      block.budget = scheduled->budget;
    }
    block.module = module_of(type);
    block.state = has_module ? lay_out(type) : flat_layout(type);
    refuse_parameters(block.state);
    for (const auto& instance : block.state.instances) {
      add(instance.type, block.sample == nullptr);
    }
    if (has_module) claim_module(block);
    blocks_.index[type] = blocks_.order.size();
    blocks_.order.push_back(std::move(block));
  }

 private:
  void claim_module(Block& block) const {
    for (const auto& other : blocks_.order) {
      if (!other.has_module || other.module != block.module) continue;
      const bool is_own = other.sample == block.type || block.sample == other.type;
      throw Refusal(block.sample != nullptr ? blocks_.of(block.sample).source : block.source,
                    "both " + other.cpp_class + " and " + block.cpp_class +
                        " would be printed as module '" + block.module + "'",
                    is_own ? "use the block under a schedule or by itself, not both"
                           : "rename one of the classes");
    }
    claim_ports(block, block.in, Direction::kIn);
    claim_ports(block, block.out, Direction::kOut);
    block.has_module = true;
  }

  // Verilog tools may take names that differ in case for one.
  static void claim_ports(const Block& block, const Layout& layout, Direction direction) {
    std::map<std::string, const LeafPlace*> taken;
    for (const auto& place : layout.leaves) {
      const auto port = llvm::StringRef(port_name(place.leaf, direction)).lower();
      const auto [first, is_new] = taken.emplace(port, &place);
      if (is_new) continue;
      const LeafPlace& other = *first->second;
      // The handshake stands behind the block's own ports.
      const bool is_handshake = block.sample != nullptr && place.source.file != other.source.file;
      throw Refusal(is_handshake ? other.source : place.source,
                    is_handshake ? "'" + other.leaf.name + "' would be printed as port '" + port +
                                       "', which a schedule needs for its handshake"
                                 : "both '" + other.leaf.name + "' and '" + place.leaf.name +
                                       "' would be printed as port '" + port + "'",
                    is_handshake ? "rename it" : "rename one of them");
    }
  }

  void find_tick(Block& block) {
    const auto* declaration = tick_of(block.type);
    if (declaration == nullptr) {
      throw Refusal(block.source, block.cpp_class + " has no tick", "write Out tick(const In&)");
    }
    const auto line = source_line(declaration->getFile(), declaration->getLine());
    const auto* out = class_of(declaration->getType()->getTypeArray()[0]);
    const auto* in = parameter_class(declaration, 2);  // after the result and `this`
    if (in == nullptr || out == nullptr || declaration->getType()->getTypeArray().size() != 3) {
      throw Refusal(line, "tick is not of the form of a block", "write Out tick(const In&)");
    }
    block.tick = module_.getFunction(declaration->getLinkageName());
    if (block.tick == nullptr || block.tick->isDeclaration()) {
      throw Refusal(line, "nobody calls the tick of " + block.cpp_class,
                    "call it once in the tick of the block that has it as a member");
    }
    if (!block.tick->hasStructRetAttr() || block.tick->arg_size() != 3) {
      throw Refusal(line, "tick is not of the form of a block", "write Out tick(const In&)");
    }
    block.in = lay_out(in);
    block.out = lay_out(out);
    for (const Layout* ports : {&block.in, &block.out}) {
      if (ports->instances.empty()) continue;
      throw Refusal(ports->instances[0].source, "a block as a port",
                    "pass its Out, and keep the block as a member");
    }
    refuse_parameters(block.out);
  }

  static void refuse_parameters(const Layout& layout) {
    for (const auto& place : layout.leaves) {
      if (!place.leaf.parameter) continue;
      throw Refusal(place.source, "parameter '" + place.leaf.name + "' is no member of an In",
                    "make it a bool, and take parameters by In");
    }
  }

  llvm::Module& module_;
  Blocks& blocks_;
};

const llvm::DICompositeType* synthesized_class(const llvm::Function& function) {
  const auto* subprogram = function.getSubprogram();
  if (subprogram == nullptr || subprogram->getName() != "reset") return nullptr;
  const auto* scope = llvm::dyn_cast_or_null<llvm::DICompositeType>(subprogram->getScope());
  if (scope == nullptr || base_name(scope) != "Synthesize") return nullptr;
  if (scope->getTemplateParams().size() != 1) return nullptr;
  return class_of(scope->getTemplateParams()[0]->getType());
}

}  // namespace

bool Blocks::is_tick(const llvm::Function* function) const {
  for (const auto& block : order) {
    if (block.tick == function) return true;
  }
  return false;
}

Blocks find_blocks(llvm::Module& module, const std::string& source, const std::string& name) {
  std::vector<std::pair<const llvm::DICompositeType*, llvm::Function*>> tops;
  for (auto& function : module) {
    const auto* type = synthesized_class(function);
    if (type == nullptr) continue;
    const bool chosen = name.empty() || name == module_of(type) || name == base_name(type);
    if (chosen) tops.emplace_back(type, &function);
  }
  if (tops.empty()) {
    throw Refusal({source, 1}, name.empty() ? "no top" : "no top called '" + name + "'",
                  "name one by `template struct steplock::Synthesize<Class>;`");
  }
  if (tops.size() > 1) {
    throw Refusal({source, 1}, "several tops", "choose one by --top NAME");
  }
  Blocks blocks;
  blocks.reset = tops[0].second;
  Finder(module, blocks).add(tops[0].first);
  return blocks;
}

}  // namespace hlsgen
