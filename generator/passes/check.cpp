// Structural invariants of a netlist; see backend.hpp.

#include "generator/backend.hpp"
#include "generator/machine/memory.hpp"
#include "generator/names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <set>

namespace hlsgen {
namespace {

class Checker {
 public:
  Checker(const Design& design, const std::map<std::string, const Module*>& children)
      : design_(design), children_(children) {}

  void check(const Module& module) {
    module_ = &module;
    check_ports();
    check_state();
    seen_outputs_.assign(module.instances.size(), kNone);
    if (is_memory(module)) return;
    for (NodeId id = 0; id < module.nodes.size(); ++id) check_node(id);
    for (const Output& o : module.outputs)
      expect_value(o.value, o.leaf.width, "output " + o.leaf.name);
    for (const Register& r : module.registers)
      expect_value(r.next, r.leaf.width, "register " + r.leaf.name);
    check_instances();
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw NetlistError(fmt::format("module {}: {}", module_->name, what));
  }
  void expect(bool holds, const std::string& what) const {
    if (!holds) fail(what);
  }
  void expect_value(NodeId value, unsigned width, const std::string& where) const {
    expect(value < module_->nodes.size(), where + " has no value");
    expect(module_->nodes[value].width == width,
           fmt::format("{} is {} bits wide, its value {}", where, width,
                       module_->nodes[value].width));
  }

  void check_ports() const {
    std::set<std::string> names;
    const auto add = [&](std::string name) {
      std::transform(name.begin(), name.end(), name.begin(),
                     [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
      expect(names.insert(name).second, "two ports are called " + name);
    };
    if (is_clocked(design_, *module_)) {
      add(std::string(kClockPort));
      add(std::string(kResetPort));
    }
    for (const Leaf& leaf : module_->inputs) add(port_name(leaf, Direction::kIn));
    for (const Output& o : module_->outputs) add(port_name(o.leaf, Direction::kOut));
  }

  void check_state() const {
    for (const Register& r : module_->registers)
      expect(r.reset.getBitWidth() == r.leaf.width, "reset of " + r.leaf.name + " has other width");
    for (const Table& t : module_->tables) {
      expect(!t.entries.empty(), "table " + t.name + " is empty");
      for (const llvm::APInt& e : t.entries)
        expect(e.getBitWidth() == t.width, "an entry of table " + t.name + " has other width");
    }
  }

  void check_node(NodeId id) {
    const Node& n = module_->nodes[id];
    const std::string where = fmt::format("node {} {}", id, n.name);
    expect(n.width >= 1, where + ": no width");
    for (const NodeId operand : n.in)
      expect(operand < id, where + ": an operand stands after it");
    expect(shape_holds(n, id), where + ": widths or operands do not fit operator " +
                                   std::to_string(static_cast<int>(n.op)));
  }

  unsigned in(const Node& n, std::size_t i) const { return module_->nodes[n.in[i]].width; }

  bool shape_holds(const Node& n, NodeId id) {
    const auto operands = [&](std::size_t count) { return n.in.size() == count; };
    switch (n.op) {
      case Op::kConstant:
        return operands(0) && n.value.getBitWidth() == n.width;
      case Op::kInput:
        return operands(0) && n.index < module_->inputs.size() &&
               n.width == module_->inputs[n.index].width;
      case Op::kRegister:
        return operands(0) && n.index < module_->registers.size() &&
               n.width == module_->registers[n.index].leaf.width;
      case Op::kInstanceOutput:
        return operands(0) && instance_output_holds(n, id);
      case Op::kAdd: case Op::kSub: case Op::kMul: case Op::kAnd: case Op::kOr: case Op::kXor:
        return operands(2) && in(n, 0) == n.width && in(n, 1) == n.width;
      case Op::kNot:
        return operands(1) && in(n, 0) == n.width;
      case Op::kShl: case Op::kLshr: case Op::kAshr:
        return operands(2) && in(n, 0) == n.width;
      case Op::kEq: case Op::kNe: case Op::kUlt: case Op::kUle: case Op::kSlt: case Op::kSle:
        return operands(2) && in(n, 0) == in(n, 1) && n.width == 1;
      case Op::kMux:
        return operands(3) && in(n, 0) == 1 && in(n, 1) == n.width && in(n, 2) == n.width;
      case Op::kSlice:
        return operands(1) && n.low + n.width <= in(n, 0);
      case Op::kConcat: {
        unsigned sum = 0;
        for (std::size_t i = 0; i < n.in.size(); ++i) sum += in(n, i);
        return !n.in.empty() && sum == n.width;
      }
      case Op::kZext: case Op::kSext:
        return operands(1) && in(n, 0) <= n.width;
      case Op::kTable:
        return operands(1) && n.index < module_->tables.size() &&
               n.width == module_->tables[n.index].width;
    }
    return false;
  }

  bool instance_output_holds(const Node& n, NodeId id) {
    if (n.index >= module_->instances.size()) return false;
    const Module* child = child_of(module_->instances[n.index]);
    if (seen_outputs_[n.index] == kNone) seen_outputs_[n.index] = id;
    return n.port < child->outputs.size() && n.width == child->outputs[n.port].leaf.width;
  }

  const Module* child_of(const Instance& instance) const {
    const auto child = children_.find(instance.module);
    if (child == children_.end())
      fail("instance " + instance.name + " is of unknown module " + instance.module);
    return child->second;
  }

  void check_instances() const {
    for (std::size_t i = 0; i < module_->instances.size(); ++i) {
      const Instance& instance = module_->instances[i];
      const Module* child = child_of(instance);
      expect(instance.inputs.size() == child->inputs.size(),
             "instance " + instance.name + " has unconnected inputs");
      for (std::size_t k = 0; k < instance.inputs.size(); ++k) {
        expect_value(instance.inputs[k], child->inputs[k].width,
                     instance.name + "." + child->inputs[k].name);
        expect(instance.inputs[k] < seen_outputs_[i],
               "instance " + instance.name + " has an output before its inputs");
      }
    }
  }

  const Design& design_;
  const std::map<std::string, const Module*>& children_;
  const Module* module_ = nullptr;
  std::vector<NodeId> seen_outputs_;  // first node that reads the instance
};

}  // namespace

void check(const Design& design) {
  std::map<std::string, const Module*> earlier;
  for (const Module& module : design.modules) {
    Checker(design, earlier).check(module);
    if (!earlier.emplace(module.name, &module).second)
      throw NetlistError("two modules are called " + module.name);
  }
}

bool is_clocked(const Design& design, const Module& module) {
  if (!module.registers.empty() || is_memory(module)) return true;
  return std::any_of(module.instances.begin(), module.instances.end(), [&](const Instance& i) {
    return std::any_of(design.modules.begin(), design.modules.end(), [&](const Module& m) {
      return m.name == i.module && is_clocked(design, m);
    });
  });
}

}  // namespace hlsgen
