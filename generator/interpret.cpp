#include "generator/interpret.hpp"

#include <optional>
#include <stdexcept>

#include "generator/machine/memory.hpp"
#include "generator/passes/evaluate.hpp"

namespace hlsgen {
namespace {

const Module& module_called(const Design& design, const std::string& name) {
  for (const auto& module : design.modules) {
    if (module.name == name) return module;
  }
  throw std::invalid_argument("no module called " + name);
}

}  // namespace

// One module with its state and those within it.
class Interpreter::Cell {
 public:
  Cell(const Design& design, const Module& module) : module_(module) {
    for (const auto& instance : module.instances) {
      children_.push_back(std::make_unique<Cell>(design, module_called(design, instance.module)));
    }
    reset();
  }

  void reset() {
    if (is_memory(module_) && words_.empty()) {  // the words outlast a reset
      words_ = module_.tables[0].entries;
      ports_ = memory_ports(module_);
      read_ = words_[0];
      if (ports_.read) read_.flipAllBits();  // before the first read it is anybody's guess
    }
    state_.clear();
    for (const auto& reg : module_.registers) state_.push_back(reg.reset);
    for (auto& child : children_) child->reset();
  }

  std::vector<llvm::APInt> clock(const std::vector<llvm::APInt>& inputs) {
    if (is_memory(module_)) return {access(inputs)};
    inputs_ = &inputs;
    values_.assign(module_.nodes.size(), std::nullopt);
    child_outputs_.assign(children_.size(), std::nullopt);
    std::vector<llvm::APInt> outputs;
    for (const auto& output : module_.outputs) outputs.push_back(value(output.value));
    std::vector<llvm::APInt> next;
    for (const auto& reg : module_.registers) next.push_back(value(reg.next));
    for (std::size_t i = 0; i < children_.size(); ++i) outputs_of_child(i);
    state_ = std::move(next);
    return outputs;
  }

 private:
  llvm::APInt access(const std::vector<llvm::APInt>& in) {
    const llvm::APInt shown = read_;
    if (!ports_.read || in[*ports_.read].getBoolValue()) {
      read_ = words_[in[ports_.address].getZExtValue()];
    }
    if (ports_.write) write(words_[in[*ports_.write_address].getZExtValue()], in);
    return shown;
  }

  void write(llvm::APInt& word, const std::vector<llvm::APInt>& in) const {
    const llvm::APInt& lanes = in[*ports_.write];
    const unsigned width = word.getBitWidth() / lanes.getBitWidth();
    for (unsigned lane = 0; lane < lanes.getBitWidth(); ++lane) {
      if (!lanes[lane]) continue;
      word.insertBits(in[*ports_.write_data].extractBits(width, lane * width), lane * width);
    }
  }

  // On demand, because the outputs of an instance wait for its inputs.
  const llvm::APInt& value(NodeId id) {
    auto& known = values_[id];
    if (!known) known = compute(module_.nodes[id]);
    return *known;
  }

  llvm::APInt compute(const Node& node) {
    switch (node.op) {
      case Op::kConstant:
        return node.value;
      case Op::kInput:
        return (*inputs_)[node.index];
      case Op::kRegister:
        return state_[node.index];
      case Op::kInstanceOutput:
        return outputs_of_child(node.index)[node.port];
      default:
        break;
    }
    std::vector<llvm::APInt> in;
    for (const NodeId operand : node.in) in.push_back(value(operand));
    return evaluate(module_, node, in);
  }

  const std::vector<llvm::APInt>& outputs_of_child(std::size_t i) {
    if (!child_outputs_[i]) {
      std::vector<llvm::APInt> in;
      for (const NodeId operand : module_.instances[i].inputs) in.push_back(value(operand));
      child_outputs_[i] = children_[i]->clock(in);
    }
    return *child_outputs_[i];
  }

  const Module& module_;
  std::vector<std::unique_ptr<Cell>> children_;
  std::vector<llvm::APInt> state_;
  std::vector<llvm::APInt> words_;  // of a memory
  MemoryPorts ports_;
  llvm::APInt read_;
  const std::vector<llvm::APInt>* inputs_ = nullptr;
  std::vector<std::optional<llvm::APInt>> values_;
  std::vector<std::optional<std::vector<llvm::APInt>>> child_outputs_;
};

Interpreter::Interpreter(const Design& design, const std::string& module)
    : top_(std::make_unique<Cell>(
          design, module.empty() ? design.modules.back() : module_called(design, module))) {}
Interpreter::~Interpreter() = default;

void Interpreter::reset() { top_->reset(); }

std::vector<llvm::APInt> Interpreter::clock(const std::vector<llvm::APInt>& inputs) {
  return top_->clock(inputs);
}

}  // namespace hlsgen
