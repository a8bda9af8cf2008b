#include "generator/dataflow/convert.hpp"

#include <llvm/IR/DebugInfo.h>
#include <llvm/IR/InstIterator.h>
#include <llvm/IR/IntrinsicInst.h>

#include <algorithm>

#include "generator/cpp/comments.hpp"
#include "generator/dataflow/control.hpp"
#include "generator/dataflow/instructions.hpp"
#include "generator/dataflow/intrinsics.hpp"
#include "generator/dataflow/reach.hpp"
#include "generator/dataflow/variables.hpp"
#include "generator/names.hpp"
#include "generator/refusal.hpp"

namespace hlsgen {
namespace {

using llvm::dyn_cast;

class Converter {
 public:
  // With `marks`, marks are inputs beyond the block's own, and their sites are listed there;
  // without, they are values that do not matter.
  Converter(const Step& step, const Block& block, const Opaque& opaque,
            std::vector<unsigned>* marks)
      : marks_(marks),
        step_(step),
        block_(block),
        opaque_(opaque),
        nodes_(module_.nodes),
        control_(*step.function, nodes_, [this](const llvm::Value* v) { return value(v); }),
        variables_(variable_names(*step.function)),
        parameters_(parameter_names(*step.function)),
        inverses_(inverse_names(*step.function)) {}

  Module run() {
    module_.name = block_.module;
    module_.cpp_class = block_.cpp_class;
    module_.source = block_.source;
    module_.contract = contract_of(block_.source.file);
    refuse_memory();
    add_sources();
    add_sinks();
    return std::move(module_);
  }

 private:
  // Whatever could not be promoted has an address that matters.
  void refuse_memory() const {
    for (auto& at : llvm::instructions(*step_.function)) {
      auto* variable = dyn_cast<llvm::AllocaInst>(&at);
      if (variable == nullptr) continue;
      std::string name = variable->getName().str();
      SourceLine where = source_of(at);
      for (auto* declaration : llvm::FindDbgDeclareUses(variable)) {
        name = declaration->getVariable()->getName().str();
        where = source_of(*declaration);
      }
      for (const auto* user : variable->users()) {  // where it happens says more than the variable
        const auto* use = dyn_cast<llvm::Instruction>(user);
        if (use != nullptr && use->getDebugLoc()) where = source_of(*use);
      }
      const bool is_state = variable == step_.state;
      throw Refusal(
          where,
          is_state ? "the address of a register escapes" : "the address of '" + name + "' escapes",
          "hold values and indices instead of pointers");
    }
  }

  Leaf leaf_of(const LeafPlace& place) {
    Leaf leaf = place.leaf;
    leaf.enumeration = enumeration_at(place.enumeration);
    leaf.set_of = enumeration_at(place.set_of);
    return leaf;
  }
  int enumeration_at(const llvm::DICompositeType* type) {
    if (type == nullptr) return -1;
    const auto enumeration = enumeration_of(type);
    auto& all = module_.enumerations;
    const auto known = std::find_if(all.begin(), all.end(), [&](const Enumeration& e) {
      return e.name == enumeration.name && e.values == enumeration.values;
    });
    const int at = static_cast<int>(known - all.begin());
    if (known == all.end()) all.push_back(enumeration);
    return at;
  }

  void add_sources() {
    for (std::size_t i = 0; i < step_.inputs.size(); ++i) {
      module_.inputs.push_back(leaf_of(block_.in.leaves[i]));
      add_source(step_.inputs[i], Op::kInput, i, 0);
    }
    for (std::size_t i = 0; i < step_.registers.size(); ++i) {
      const auto& place = block_.state.leaves[i];
      module_.registers.push_back({leaf_of(place), block_.reset[i], kNone, place.source});
      add_source(step_.registers[i], Op::kRegister, i, 0);
    }
    for (std::size_t i = 0; i < step_.instances.size(); ++i) {
      const auto& instance = step_.instances[i];
      module_.instances.push_back({instance.place->name, instance.block->module, {}});
      for (std::size_t port = 0; port < instance.outputs.size(); ++port) {
        add_source(instance.outputs[port], Op::kInstanceOutput, i, port);
      }
    }
  }

  void add_source(const llvm::GlobalVariable* global, Op op, std::size_t index, std::size_t port) {
    sources_[global] = {op, static_cast<unsigned>(index), static_cast<unsigned>(port)};
  }

  void add_sinks() {
    // In the order of the clock: what instances are given, what comes out, what is kept.
    for (std::size_t i = 0; i < step_.instances.size(); ++i) {
      const auto& instance = step_.instances[i];
      for (std::size_t k = 0; k < instance.inputs.size(); ++k) {
        const LeafPlace& place = instance.block->in.leaves[k];
        const NodeId node = sink(instance.inputs[k], place);
        if (place.leaf.parameter) require_fixed(node, *instance.place, place);
        module_.instances[i].inputs.push_back(node);
      }
    }
    for (std::size_t i = 0; i < step_.outputs.size(); ++i) {
      const auto& place = block_.out.leaves[i];
      module_.outputs.push_back({leaf_of(place), sink(step_.outputs[i], place)});
    }
    for (std::size_t i = 0; i < step_.nexts.size(); ++i) {
      module_.registers[i].next = sink(step_.nexts[i], block_.state.leaves[i]);
    }
  }

  void require_fixed(NodeId id, const InstancePlace& instance, const LeafPlace& place) const {
    const Node& node = module_.nodes[id];
    if (node.op == Op::kConstant) return;
    if (node.op == Op::kInput && module_.inputs[node.index].parameter) return;
    throw Refusal(instance.source,
                  "parameter '" + place.leaf.name + "' of '" + instance.name + "' is computed",
                  "give it a parameter of this block as it is, or a constant");
  }

  NodeId sink(const llvm::GlobalVariable* global, const LeafPlace& place) {
    const auto* store = llvm::cast<llvm::StoreInst>(*global->user_begin());
    const NodeId node = value(store->getValueOperand());
    if (node != kNone) return node;
    throw Refusal(place.source, "'" + place.leaf.name + "' depends on what C++ leaves undefined",
                  "look for shifts by the width or more, and for missing returns");
  }

  NodeId value(const llvm::Value* v) {
    if (const auto* constant = dyn_cast<llvm::ConstantInt>(v)) {
      return nodes_.constant(constant->getValue());
    }
    if (llvm::isa<llvm::UndefValue>(v)) return kNone;  // poison is one of them
    if (const auto* global = dyn_cast<llvm::GlobalVariable>(v)) return source(*global);
    const auto known = values_.find(v);
    if (known != values_.end()) return known->second;
    const auto* at = dyn_cast<llvm::Instruction>(v);
    const bool is_choice = v->getType()->isPointerTy() && at != nullptr &&
                           llvm::isa<llvm::PHINode, llvm::SelectInst>(at);
    if (at == nullptr || (!v->getType()->isIntegerTy() && !is_choice)) {
      throw Refusal(at == nullptr ? block_.source : source_of(*at),
                    "the value of a pointer is used as a number", "use an index");
    }
    const NodeId node = convert(*at);
    values_[v] = node;
    if (node != kNone) give_name(node, *at);
    return node;
  }

  void give_name(NodeId node, const llvm::Instruction& at) {
    const auto variable = variables_.find(&at);
    const auto parameter = parameters_.find(&at);
    if (variable != variables_.end()) {
      nodes_.name(node, flat_name(variable->second));
    } else if (is_returned(at)) {
      nodes_.returned(node, function_of(at));
    } else if (parameter != parameters_.end()) {
      nodes_.name(node, flat_name(parameter->second));
    }
    const auto inverse = inverses_.find(&at);
    if (inverse != inverses_.end() && at.getType()->isIntegerTy(1)) nodes_.hint(node, "not_" + flat_name(inverse->second));
  }

  NodeId convert(const llvm::Instruction& at) {
    if (at.getType()->isIntegerTy() && at.getType()->getIntegerBitWidth() > 2 * 128) {
      throw Refusal(source_of(at), "a number of more than 256 bits", "split it");
    }
    if (const auto* load = dyn_cast<llvm::LoadInst>(&at)) return loaded(*load);
    if (const auto* phi = dyn_cast<llvm::PHINode>(&at)) {
      const Located located(*this, at);
      return control_.phi(*phi);
    }
    const auto* call = dyn_cast<llvm::CallInst>(&at);
    if (opaque_kind(&at) == OpaqueKind::kUndefined) return mark(*call);
    if (const auto* part = dyn_cast<llvm::ExtractValueInst>(&at)) {
      if (const auto* pair = dyn_cast<llvm::WithOverflowInst>(part->getAggregateOperand())) {
        return overflow(*pair, part->getIndices().front() == 1, at);
      }
    }
    std::vector<NodeId> in;
    const bool is_table = opaque_kind(&at) == OpaqueKind::kTable;
    for (const auto& operand : at.operands()) {
      if (call != nullptr && !call->isDataOperand(&operand)) continue;
      const bool has_value = operand->getType()->isIntegerTy() || llvm::isa<llvm::SelectInst>(at);
      in.push_back(has_value ? value(operand) : kNone);
    }
    const Located located(*this, at);
    if (is_table) return table(*call, in[1]);
    if (llvm::isa<llvm::SelectInst>(at)) {
      if (in[1] == kNone || in[2] == kNone) return in[1] == kNone ? in[2] : in[1];
      if (in[0] == kNone) return in[1];
    }
    for (std::size_t i = 0; i < in.size(); ++i) {
      const auto* operand = at.getOperand(static_cast<unsigned>(i));
      if (in[i] == kNone && operand->getType()->isIntegerTy()) return kNone;
    }
    return instruction(nodes_, at, in);
  }

  NodeId overflow(const llvm::WithOverflowInst& pair, bool flag, const llvm::Instruction& at) {
    const NodeId a = value(pair.getLHS());
    const NodeId b = value(pair.getRHS());
    const Located located(*this, at);
    return a == kNone || b == kNone ? kNone : with_overflow(nodes_, pair, flag, a, b);
  }

  // LLVM turns a choice of two sources into a choice of their addresses: it converts alike.
  NodeId loaded(const llvm::LoadInst& load) {
    const auto* pointer = load.getPointerOperand();
    if (llvm::isa<llvm::GlobalVariable, llvm::PHINode, llvm::SelectInst>(pointer)) {
      return value(pointer);
    }
    throw Refusal(source_of(load), "it is not known at compile time what is read here",
                  "choose between values instead of between pointers");
  }

  NodeId source(const llvm::GlobalVariable& global) {
    const auto found = sources_.find(&global);
    if (found == sources_.end()) {
      throw Refusal(block_.source, "it is not known at compile time what is read",
                    "choose between values instead of between pointers");
    }
    return nodes_.source_node(found->second.op, global.getValueType()->getIntegerBitWidth(),
                              found->second.index, found->second.port);
  }

  NodeId mark(const llvm::CallInst& call) {
    if (marks_ == nullptr) return kNone;
    marks_->push_back(site_of(&call));
    const auto number = module_.inputs.size() + marks_->size() - 1;
    return nodes_.source_node(Op::kInput, call.getType()->getIntegerBitWidth(),
                              static_cast<unsigned>(number));
  }

  // Tables of the program, numbered within the module as they are met, and as narrow as their
  // entries.
  NodeId table(const llvm::CallInst& call, NodeId address) {
    const unsigned number = table_of(&call);
    const auto known = std::find(tables_.begin(), tables_.end(), number);
    const auto index = static_cast<unsigned>(known - tables_.begin());
    if (known == tables_.end()) {
      tables_.push_back(number);
      module_.tables.push_back(opaque_.tables()[number]);
      auto& table = module_.tables.back();
      unsigned as_unsigned = 1;
      unsigned as_signed = 1;
      for (const auto& entry : table.entries) {
        as_unsigned = std::max(as_unsigned, entry.getActiveBits());
        as_signed = std::max(as_signed, entry.getSignificantBits());
      }
      table.width = std::min(as_unsigned, as_signed);
      for (auto& entry : table.entries) entry = entry.trunc(table.width);
      table_signed_.push_back(as_signed < as_unsigned);
    }
    const unsigned width = call.getType()->getIntegerBitWidth();
    const NodeId entry = nodes_.table(module_.tables[index].width, address, index);
    return table_signed_[index] ? nodes_.sext(entry, width) : nodes_.zext(entry, width);
  }

  // Nodes made while it lives carry the instruction's line.
  struct Located {
    Located(Converter& converter, const llvm::Instruction& at)
        : nodes(converter.nodes_), before(nodes.source()), function(nodes.function()) {
      const auto* line = at.getDebugLoc().get();
      if (line != nullptr) nodes.set_source(source_of_equation(line), function_of(at));
    }
    ~Located() { nodes.set_source(before, function); }
    NodeBuilder& nodes;
    SourceLine before;
    std::string function;
  };

  struct Source {
    Op op;
    unsigned index, port;
  };

  std::vector<unsigned>* marks_;
  const Step& step_;
  const Block& block_;
  const Opaque& opaque_;
  Module module_;
  NodeBuilder nodes_;
  Control control_;
  ValueNames variables_;
  ValueNames parameters_;
  ValueNames inverses_;
  std::map<const llvm::GlobalVariable*, Source> sources_;
  std::map<const llvm::Value*, NodeId> values_;
  std::vector<unsigned> tables_;
  std::vector<bool> table_signed_;
};

}  // namespace

Module convert(const Step& step, const Block& block, const Opaque& opaque) {
  std::vector<unsigned> marks;
  const auto module = Converter(step, block, opaque, &marks).run();
  if (marks.empty()) return module;
  if (const auto reached = Reach(module).find()) {
    const auto& site = opaque.site(marks[*reached]);
    throw Refusal(site.where, site.what, site.mend);
  }
  return Converter(step, block, opaque, nullptr).run();
}

}  // namespace hlsgen
