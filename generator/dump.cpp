#include "generator/dump.hpp"

#include <fmt/format.h>
#include <llvm/ADT/StringExtras.h>

namespace hlsgen {
namespace {

constexpr const char* kOperators[] = {
    "constant", "input", "register", "output_of", "add",    "sub",  "mul",  "and",  "or",
    "xor",      "not",   "shl",      "lshr",      "ashr",   "eq",   "ne",   "ult",  "ule",
    "slt",      "sle",   "mux",      "slice",     "concat", "zext", "sext", "table"};

std::string decimal(const llvm::APInt& value) { return llvm::toString(value, 10, false); }

std::string type_of(const Module& module, const Leaf& leaf) {
  if (leaf.enumeration >= 0) return module.enumerations[leaf.enumeration].name;
  return (leaf.is_signed ? "s" : "u") + std::to_string(leaf.width);
}

std::string node_text(const Design& design, const Module& module, NodeId id) {
  const Node& node = module.nodes[id];
  std::string text =
      fmt::format("  {} = {}.{}", id, kOperators[static_cast<std::size_t>(node.op)], node.width);
  switch (node.op) {
    case Op::kConstant:
      text += " " + decimal(node.value);
      break;
    case Op::kInput:
      text += " " + module.inputs[node.index].name;
      break;
    case Op::kRegister:
      text += " " + module.registers[node.index].leaf.name;
      break;
    case Op::kTable:
      text += " " + module.tables[node.index].name;
      break;
    case Op::kInstanceOutput: {
      const auto& instance = module.instances[node.index];
      text += " " + instance.name;
      for (const auto& child : design.modules) {
        if (child.name == instance.module) text += "." + child.outputs[node.port].leaf.name;
      }
      break;
    }
    default:
      break;
  }
  for (const NodeId in : node.in) text += fmt::format(" {}", in);
  if (node.op == Op::kSlice) text += fmt::format(" from {}", node.low);
  if (!node.name.empty()) text += "  ; " + node.name;
  if (!node.source.file.empty())
    text += fmt::format("  @{}:{}", node.source.file, node.source.line);
  return text + "\n";
}

}  // namespace

std::string dump(const Design& design) {
  std::string text;
  for (const auto& module : design.modules) {
    text += fmt::format("module {}  ; {} @{}:{}\n", module.name, module.cpp_class,
                        module.source.file, module.source.line);
    for (const auto& leaf : module.inputs) {
      text += fmt::format("  {} {} {}\n", leaf.parameter ? "parameter" : "in", type_of(module, leaf), leaf.name);
    }
    for (const auto& table : module.tables) {
      text += fmt::format("  table u{} {}[{}]\n", table.width, table.name, table.entries.size());
    }
    for (NodeId id = 0; id < module.nodes.size(); ++id) text += node_text(design, module, id);
    for (const auto& instance : module.instances) {
      text += fmt::format("  instance {} {} {}\n", instance.name, instance.module,
                          fmt::join(instance.inputs, " "));
    }
    for (const auto& output : module.outputs) {
      text += fmt::format("  out {} {} = {}\n", type_of(module, output.leaf), output.leaf.name,
                          output.value);
    }
    for (const auto& reg : module.registers) {
      text += fmt::format("  reg {} {} = {} reset {}\n", type_of(module, reg.leaf), reg.leaf.name,
                          reg.next, decimal(reg.reset));
    }
  }
  return text;
}

}  // namespace hlsgen
