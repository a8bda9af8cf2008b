#include "generator/print/legalise.hpp"

#include "generator/backend.hpp"
#include "generator/names.hpp"
#include "generator/print/expressions.hpp"
#include "generator/print/identifiers.hpp"
#include "generator/print/place.hpp"
#include "generator/print/synchronisers.hpp"
#include "generator/print/wire_names.hpp"

#include <fmt/format.h>

namespace hlsgen {
namespace {

using syntax::Expr;

class Legaliser {
 public:
  Legaliser(const Design& design, const Module& module)
      : design_(design),
        m_(module),
        clocked_(decide(m_)),
        names_(design, m_),
        plan_(plan(m_, clocked_)),
        expressions_(m_, plan_, [this](NodeId id) { return name_of(id); }, name_enumerators()) {
    name_instance_outputs();
    wires_ = wire_names(m_, plan_, names_);
    place_wires(m_, plan_, clocked_);
    mark_locals(clocked_);
  }

  syntax::Text run() {
    write_frame();
    for (NodeId id = 0; id < m_.nodes.size(); ++id) {
      const Node& n = m_.nodes[id];
      if (plan_.uses[id] == 0) continue;
      if (n.op == Op::kInstanceOutput) write_cell(n.index);
      else if (plan_.wire[id] && !local_[id]) write_wire(id, text_.items);
    }
    for (unsigned i = 0; i < m_.instances.size(); ++i) write_cell(i);
    write_registers();
    for (std::size_t o = 0; o < m_.outputs.size(); ++o)
      text_.assigns.emplace_back(names_.outputs[o],
                                 stored(m_.outputs[o].value, m_.outputs[o].leaf));
    for (std::size_t e = 0; e < m_.enumerations.size(); ++e) {
      syntax::Enumerators all;
      for (std::size_t v = 0; v < m_.enumerations[e].values.size(); ++v)
        all.emplace_back(expressions_.enumerator({static_cast<int>(e), v}),
                         syntax::literal(llvm::APInt(m_.enumerations[e].width, m_.enumerations[e].values[v].second)));
      text_.enumerations.push_back(std::move(all));
    }
    for (const Expressions::Used& u : expressions_.used_enumerators())
      text_.constants.push_back(text_.enumerations[u.enumeration][u.value]);
    find_sets();
    return std::move(text_);
  }

 private:
  std::string at_line(const SourceLine& s) const {
    if (s.line == 0) return "";
    if (s.file == m_.source.file) return fmt::format("line {}", s.line);
    return fmt::format("{}:{}", s.file.substr(s.file.rfind('/') + 1), s.line);
  }

  std::vector<std::vector<std::string>> name_enumerators() {
    std::vector<std::vector<std::string>> all;
    for (const Enumeration& e : m_.enumerations) {
      all.emplace_back();
      for (const auto& [name, value] : e.values)
        all.back().push_back(names_.pool.take(e.name + "_" + name));
    }
    return all;
  }

  std::string name_of(NodeId id) const {
    const Node& n = m_.nodes[id];
    switch (n.op) {
      case Op::kInput: return names_.inputs[n.index];
      case Op::kRegister: return names_.registers[n.index];
      case Op::kInstanceOutput: return instance_outputs_[n.index][n.port];
      default: return wires_[id];
    }
  }

  void name_instance_outputs() {
    std::vector<std::vector<bool>> read;
    for (const Instance& i : m_.instances)
      read.emplace_back(module_of(design_, i).outputs.size(), false);
    for (NodeId id = 0; id < m_.nodes.size(); ++id) {
      const Node& n = m_.nodes[id];
      if (n.op == Op::kInstanceOutput && plan_.uses[id] > 0) read[n.index][n.port] = true;
    }
    for (std::size_t i = 0; i < m_.instances.size(); ++i) {
      const Module& child = module_of(design_, m_.instances[i]);
      instance_outputs_.emplace_back();
      for (std::size_t o = 0; o < child.outputs.size(); ++o)
        instance_outputs_[i].push_back(
            names_.pool.take((read[i][o] ? "" : "unused_") + names_.instances[i] + "_" +
                             flat_name(child.outputs[o].leaf.name)));
    }
  }

  // What has a bit for each value of an enumeration: such ports and registers, and the values that go there bit by bit.
  void find_sets() {
    std::vector<int> set(m_.nodes.size(), -1);
    for (NodeId id = 0; id < m_.nodes.size(); ++id) {
      const Node& n = m_.nodes[id];
      if (n.op == Op::kInput) set[id] = m_.inputs[n.index].set_of;
      if (n.op == Op::kRegister) set[id] = m_.registers[n.index].leaf.set_of;
    }
    const auto goes = [&set](NodeId id, int to) {
      if (set[id] < 0) set[id] = to;
    };
    for (const Register& r : m_.registers) goes(r.next, r.leaf.set_of);
    for (const Output& o : m_.outputs) goes(o.value, o.leaf.set_of);
    for (NodeId id = m_.nodes.size(); id-- > 0;) {
      const Node& n = m_.nodes[id];
      if (set[id] < 0) continue;
      if (n.op == Op::kOr || n.op == Op::kAnd || n.op == Op::kZext || n.op == Op::kNot)
        for (const NodeId operand : n.in) goes(operand, set[id]);
      if (n.op == Op::kMux) goes(n.in[1], set[id]), goes(n.in[2], set[id]);
      if (n.op == Op::kConcat) goes(n.in.back(), set[id]);
      const bool source = n.op == Op::kInput || n.op == Op::kRegister || n.op == Op::kInstanceOutput;
      if (n.width > 1 && plan_.uses[id] > 0 && (source || plan_.wire[id])) text_.sets.emplace(name_of(id), set[id]);
    }
  }

  void write_frame() {
    text_.header = {
        fmt::format("{}: {}, generated by hlsgen from {}:{}.", m_.name, m_.cpp_class, m_.source.file,
                    m_.source.line),
        "Do not edit: change the C++ and run hlsgen again."};
    text_.header.insert(text_.header.begin() + 1, m_.remarks.begin(), m_.remarks.end());
    if (!m_.contract.empty()) text_.header.emplace_back();
    text_.header.insert(text_.header.end(), m_.contract.begin(), m_.contract.end());
    text_.name = m_.name;
    text_.clocked = is_clocked(design_, m_);
    for (std::size_t i = 0; i < m_.inputs.size(); ++i) {
      const Leaf& leaf = m_.inputs[i];
      (leaf.parameter ? text_.parameters : text_.inputs)
          .push_back({names_.inputs[i], leaf.width, leaf.comment, false, leaf.parameter.value_or(false)});
    }
    for (std::size_t i = 0; i < m_.outputs.size(); ++i)
      text_.outputs.push_back(
          {names_.outputs[i], m_.outputs[i].leaf.width, m_.outputs[i].leaf.comment});
    const std::vector<bool> synchronises = find_synchronisers(m_);
    for (std::size_t i = 0; i < m_.registers.size(); ++i)
      text_.registers.push_back({names_.registers[i], m_.registers[i].leaf.width,
                                 m_.registers[i].leaf.comment, synchronises[i], false, is_signed(m_.registers[i].leaf)});
  }

  void write_cell(unsigned index) {
    if (written_[index]) return;
    written_[index] = true;
    const Instance& instance = m_.instances[index];
    const Module& child = module_of(design_, instance);
    const FixedNames ports(design_, child);
    syntax::Cell cell{child.name, names_.instances[index], is_clocked(design_, child), {}, {}, {}};
    for (std::size_t i = 0; i < ports.inputs.size(); ++i)
      (child.inputs[i].parameter ? cell.parameters : cell.inputs)
          .emplace_back(ports.inputs[i],
                        expressions_.use(instance.inputs[i], child_enumeration(child, i)));
    for (std::size_t o = 0; o < ports.outputs.size(); ++o)
      cell.outputs.push_back(
          {ports.outputs[o], instance_outputs_[index][o], child.outputs[o].leaf.width});
    text_.items.emplace_back(std::move(cell));
  }

  // The child's enumeration, if this module knows it under the same name.
  int child_enumeration(const Module& child, std::size_t input) const {
    const int theirs = child.inputs[input].enumeration;
    if (theirs < 0) return -1;
    for (std::size_t e = 0; e < m_.enumerations.size(); ++e)
      if (m_.enumerations[e].name == child.enumerations[theirs].name &&
          m_.enumerations[e].values == child.enumerations[theirs].values)
        return static_cast<int>(e);
    return -1;
  }

  void write_wire(NodeId id, std::vector<syntax::Item>& items) {
    const Node& n = m_.nodes[id];
    if (n.op == Op::kTable) return write_table(id);
    const auto chain = plan_.cases.find(id);
    if (chain != plan_.cases.end()) return write_case(id, chain->second, items);
    Expr value = expressions_.define(id);
    if (value.width == n.width) {
      // The name of a variable is found in the source without its line.
      const bool found = !n.name.empty() && n.source.file == m_.source.file;
      items.emplace_back(
          syntax::Wire{wires_[id], n.width, value, found ? "" : at_line(n.source)});
      return;
    }
    // A product is computed as wide as its factors ask, then cut or extended.
    const std::string full = names_.pool.take(wires_[id] + "_full");
    const bool is_signed = syntax::is_signed(value);
    const Expr product = syntax::name(full, value.width);
    text_.items.emplace_back(syntax::Wire{full, value.width, value, at_line(n.source)});
    if (value.width > n.width) {
      value = syntax::select(product, n.width - 1, 0);
    } else {
      const unsigned more = n.width - value.width;
      const Expr sign = syntax::select(product, value.width - 1, value.width - 1);
      value = syntax::concat({is_signed ? syntax::replicate(more, sign)
                                        : syntax::literal(llvm::APInt(more, 0)),
                              product});
    }
    text_.items.emplace_back(syntax::Wire{wires_[id], n.width, value, ""});
  }

  void write_case(NodeId id, const CaseChain& chain, std::vector<syntax::Item>& items) {
    const Node& n = m_.nodes[id];
    const int selector = plan_.enumeration[chain.selector], result = plan_.enumeration[id];
    syntax::Case c{{{wires_[id], n.width}}, expressions_.use(chain.selector), {}, at_line(n.source)};
    for (const CaseChain::Arm& arm : chain.arms) {
      syntax::Case::Arm printed;
      for (const llvm::APInt& label : arm.labels)
        printed.labels.push_back(expressions_.constant(label, selector, Expr::Base::kDecimal));
      printed.values.push_back(expressions_.use(arm.value, result));
      c.arms.push_back(std::move(printed));
    }
    c.arms.push_back({{}, {expressions_.use(chain.otherwise, result)}});
    items.emplace_back(std::move(c));
  }

  void write_table(NodeId id) {
    const Node& n = m_.nodes[id];
    const Table& table = m_.tables[n.index];
    const Expr address = expressions_.use(n.in[0]);
    syntax::Case c{{{wires_[id], n.width}}, address, {}, table.name};
    for (std::size_t i = 0; i < table.entries.size(); ++i) {
      const bool reachable = address.width >= 64 || (i >> address.width) == 0;
      if (!reachable || i + 1 == table.entries.size()) break;
      c.arms.push_back({{syntax::literal(llvm::APInt(address.width, i))},
                        {syntax::literal(table.entries[i])}});
    }
    c.arms.push_back({{}, {syntax::literal(table.entries.back())}});
    text_.items.emplace_back(std::move(c));
  }

  // What goes into a leaf: constants are spelled as its enumerators, or with its sign.
  Expr stored(NodeId value, const Leaf& leaf) {
    Expr e = expressions_.use(value, leaf.enumeration);
    if (leaf.is_signed) spell_signed(e);
    return e;
  }
  static void spell_signed(Expr& e) {
    if (e.is(Expr::Kind::kLiteral)) e.base = Expr::Base::kSignedDecimal;
    if (!e.is(Expr::Kind::kConditional)) return;
    spell_signed(e.operands[1]);
    spell_signed(e.operands[2]);
  }

  void mark_locals(const Branch& block) {
    for (const NodeId id : block.wires) local_[id] = true;
    for (const Decision& step : block.steps)
      for (const Decision::Arm& arm : step.arms) mark_locals(arm.block);
  }

  void write_registers() {
    for (std::size_t i = 0; i < m_.registers.size(); ++i) {
      const Register& r = m_.registers[i];
      const auto base = r.leaf.is_signed ? Expr::Base::kSignedDecimal : Expr::Base::kDecimal;
      syntax::Statement s;
      s.target = names_.registers[i];
      s.value = expressions_.constant(r.reset, r.leaf.enumeration, base);
      text_.resets.statements.push_back(std::move(s));
    }
    text_.updates = write_block(clocked_, true);
  }

  // Inside of branches the lines of the source would say less than they take.
  syntax::Block write_block(const Branch& block, bool outermost) {
    syntax::Block out;
    for (const NodeId id : block.wires) write_wire(id, out.locals);
    for (const Decision& step : block.steps) {
      out.statements.push_back(write_step(step));
      if (!outermost) out.statements.back().comment.clear();
    }
    return out;
  }

  syntax::Statement write_step(const Decision& step) {
    syntax::Statement s;
    if (step.arms.empty()) {
      s.target = names_.registers[step.reg];
      s.value = expressions_.use(step.value, m_.registers[step.reg].leaf.enumeration);
      s.comment = at_line(m_.nodes[step.value].source);
      return s;
    }
    s.value = expressions_.use(step.selector);
    if (m_.nodes[step.selector].width == 1) {
      s.then = write_block(step.arms[0].block, false);
      s.otherwise = write_block(step.arms[1].block, false);
      return s;
    }
    const int enumeration = plan_.enumeration[step.selector];
    for (const Decision::Arm& arm : step.arms) {
      syntax::Statement::Arm printed;
      for (const llvm::APInt& label : arm.labels)
        printed.labels.push_back(expressions_.constant(label, enumeration, Expr::Base::kDecimal));
      for (const llvm::APInt& label : arm.rest) {
        const auto found = expressions_.find_enumerator(label, enumeration);
        printed.rest.push_back(found ? syntax::name(expressions_.enumerator(*found), 1)
                                     : syntax::literal(label));
      }
      printed.block = write_block(arm.block, false);
      s.arms.push_back(std::move(printed));
    }
    return s;
  }

  const Design& design_;
  Module m_;       // a copy, to which decide() adds
  Branch clocked_;  // what the registers do
  FixedNames names_;
  Plan plan_;
  Expressions expressions_;
  std::vector<std::vector<std::string>> instance_outputs_;
  std::vector<std::string> wires_;
  std::vector<bool> local_ = std::vector<bool>(m_.nodes.size(), false);  // stands in a branch
  std::vector<bool> written_ = std::vector<bool>(m_.instances.size(), false);
  syntax::Text text_;
};

}  // namespace

syntax::Text legalise(const Design& design, const Module& module) {
  return Legaliser(design, module).run();
}

}  // namespace hlsgen
