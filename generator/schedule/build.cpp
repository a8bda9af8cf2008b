#include "generator/schedule/build.hpp"

#include <fmt/format.h>

#include <map>

#include "generator/schedule/steps.hpp"

namespace hlsgen::scheduling {
namespace {

class Builder {
 public:
  Builder(const Operations& ops, const Order& order, const Keeping& k, const Binding& b,
          const Frame& frame)
      : ops_(ops),
        order_(order),
        k_(k),
        b_(b),
        frame_(frame),
        old_(ops.module),
        out_(header(ops.module)),
        nodes_(out_.nodes),
        steps_(nodes_, order.last),
        value_(old_.nodes.size(), kNone) {}

  Module run() {
    make_sources();
    make_units();
    for (NodeId id = 0; id < old_.nodes.size(); ++id) make(id);
    for (Unit& unit : units_) finish(unit);
    finish_kept();
    finish_registers();
    make_outputs();
    make_control();
    return std::move(out_);
  }

 private:
  struct Port {
    unsigned reg;
    std::vector<Load> loads;
  };
  struct Unit {
    unsigned pool = 0, number = 0;
    std::vector<Port> ports;  // of a multiplier: two factors; of a table: what it shows
    unsigned result = 0;      // register
    unsigned result_width = 0;
    std::vector<Load> addresses;
    SourceLine source;
  };

  static Module header(const Module& old) {
    Module m = old;
    m.nodes.clear();
    m.outputs.clear();
    return m;
  }

  unsigned new_register(const std::string& name, unsigned width, const std::string& comment,
                        const llvm::APInt& reset) {
    Register r;
    r.leaf.name = name;
    r.leaf.width = width;
    r.leaf.comment = comment;
    r.reset = reset;
    out_.registers.push_back(r);
    return static_cast<unsigned>(out_.registers.size() - 1);
  }
  unsigned new_register(const std::string& name, unsigned width, const std::string& comment) {
    return new_register(name, width, comment, llvm::APInt(width, 0));
  }
  NodeId present(unsigned reg) {
    return nodes_.source_node(Op::kRegister, out_.registers[reg].leaf.width, reg);
  }

  void make_sources() {
    start_ = nodes_.source_node(Op::kInput, 1, static_cast<unsigned>(out_.inputs.size()));
    out_.inputs.push_back(frame_.start);
    step_ = new_register("step", steps_.width(), "0: waiting for a start");
    steps_.count_in(present(step_));
    for (const Shared& shared : b_.registers)
      kept_.push_back(
          new_register(name_of(shared), shared.width, times_of(shared)));
  }

  // After what it holds longest of what has a name.
  std::string name_of(const Shared& shared) const {
    std::string name;
    unsigned longest = 0;
    for (const NodeId id : shared.values) {
      const unsigned steps = k_.until[id] - k_.from[id] + 1;
      if (old_.nodes[id].name.empty() || steps <= longest) continue;
      name = old_.nodes[id].name + ".";
      longest = steps;
    }
    return fmt::format("{}kept.{}", name, kept_.size());
  }

  // "steps 3-7 error, 9-12"
  std::string times_of(const Shared& shared) const {
    std::string text = "in steps";
    for (const NodeId id : shared.values) {
      text += fmt::format("{} {}-{}", text == "in steps" ? "" : ",", k_.from[id] + 1, k_.until[id]);
      if (!old_.nodes[id].name.empty()) text += " " + old_.nodes[id].name;
    }
    return text;
  }

  NodeId resized(NodeId a, unsigned width) {
    return nodes_.width(a) >= width ? nodes_.slice(a, width, 0) : nodes_.sext(a, width);
  }

  // Registers of the units; their width is that of what they are given.
  void make_units() {
    std::map<std::pair<unsigned, unsigned>, std::size_t> known;
    unit_of_.assign(old_.nodes.size(), 0);
    for (NodeId id = 0; id < old_.nodes.size(); ++id) {
      if (!ops_.lives[id] || !ops_.is_unit(id)) continue;
      const auto key = std::pair(ops_.pool(id), order_.unit[id]);
      const auto [entry, is_new] = known.emplace(key, units_.size());
      if (is_new) units_.push_back(new_unit(key.first, key.second));
      unit_of_[id] = entry->second;
    }
  }

  Unit new_unit(unsigned pool, unsigned number) {
    Unit unit;
    unit.pool = pool;
    unit.number = number;
    if (pool != 0) {
      const Table& table = old_.tables[pool - 1];
      unit.result_width = table.width;
      unit.result = new_register(table.name + "_entry", table.width, "of the table, shared");
      return unit;
    }
    const std::string suffix = ops_.budget.multipliers > 1 ? fmt::format("_{}", number) : "";
    const unsigned widths[] = {ops_.budget.width, ops_.budget.second_width};
    for (unsigned i = 0; i < 2; ++i)
      unit.ports.push_back({new_register(fmt::format("factor_{}{}", i == 0 ? "a" : "b", suffix),
                                         widths[i], "of the shared multiplier"),
                            {}});
    unit.result_width = widths[0] + widths[1];
    unit.result = new_register("product" + suffix, unit.result_width, "of the factors before");
    return unit;
  }

  // The value of the old module as a reader in that step sees it.
  NodeId read(NodeId id, unsigned step) {
    if (k_.way(id, step) == Way::kDirect) return value_[id];
    if (k_.early_of[id] != 0) return present(k_.early_of[id] - 1);
    return nodes_.slice(present(kept_[b_.place[id]]), old_.nodes[id].width, 0);
  }

  void make(NodeId id) {
    const Node& n = old_.nodes[id];
    const bool is_source = n.op == Op::kConstant || n.op == Op::kInput || n.op == Op::kRegister;
    if (!ops_.lives[id] || (!is_source && k_.times[id].none())) return;
    nodes_.set_source(n.source, n.function);
    if (ops_.is_unit(id)) {
      make_unit_value(id);
    } else if (n.op == Op::kConstant) {
      value_[id] = nodes_.constant(n.value);
    } else if (is_source) {
      value_[id] = nodes_.source_node(n.op, n.width, n.index);
    } else {
      Node copy = n;
      const auto step = static_cast<unsigned>(k_.times[id].find_first());
      for (NodeId& operand : copy.in) operand = read(operand, step);
      out_.nodes.push_back(std::move(copy));
      value_[id] = static_cast<NodeId>(out_.nodes.size() - 1);
    }
  }

  void make_unit_value(NodeId id) {
    Unit& unit = units_[unit_of_[id]];
    const Node& n = old_.nodes[id];
    const unsigned step = order_.issue[id];
    unit.source = n.source;
    if (unit.pool != 0) {
      unit.addresses.push_back({step, read(n.in[0], step)});
      value_[id] = present(unit.result);
      return;
    }
    for (unsigned i = 0; i < 2; ++i) {
      const NodeId factor = read(n.in[b_.exchanged[id] ? 1 - i : i], step);
      Port& port = unit.ports[i];
      port.loads.push_back({step, resized(factor, out_.registers[port.reg].leaf.width)});
    }
    value_[id] = resized(present(unit.result), n.width);
  }

  void finish(Unit& unit) {
    nodes_.set_source(unit.source);
    if (unit.pool != 0) {
      const NodeId entry =
          nodes_.table(unit.result_width, steps_.chosen(unit.addresses), unit.pool - 1);
      out_.registers[unit.result].next =
          nodes_.mux(steps_.any_of(unit.addresses), entry, present(unit.result));
      return;
    }
    for (const Port& port : unit.ports) {
      out_.registers[port.reg].next =
          nodes_.mux(steps_.any_of(port.loads), steps_.chosen(port.loads), present(port.reg));
    }
    out_.registers[unit.result].next =
        nodes_.binary(Op::kMul, nodes_.sext(present(unit.ports[0].reg), unit.result_width),
                      nodes_.sext(present(unit.ports[1].reg), unit.result_width));
  }

  void finish_kept() {
    nodes_.set_source({});
    for (std::size_t r = 0; r < kept_.size(); ++r) {
      std::vector<Load> loads;
      for (const NodeId id : b_.registers[r].values)
        loads.push_back({k_.from[id], nodes_.zext(value_[id], b_.registers[r].width)});
      out_.registers[kept_[r]].next =
          nodes_.mux(steps_.any_of(loads), steps_.chosen(loads), present(kept_[r]));
    }
  }

  void finish_registers() {
    for (unsigned r = 0; r < old_.registers.size(); ++r) {
      const NodeId next = old_.registers[r].next;
      const bool early = k_.early[r];
      const unsigned step = early ? order_.step[next] : order_.last;
      const NodeId value = early ? value_[next] : read(next, step);
      out_.registers[r].next = nodes_.mux(steps_.at(step), value, present(r));
    }
  }

  // A register of the block that takes the same value at the same time serves as the output's.
  void make_outputs() {
    for (std::size_t o = 0; o < old_.outputs.size(); ++o) {
      const Output& output = old_.outputs[o];
      unsigned reg = 0;
      const auto serves = [&](unsigned r) {
        const Register& candidate = old_.registers[r];
        return candidate.next == output.value && !k_.early[r] &&
               candidate.reset == frame_.output_resets[o];
      };
      while (reg < old_.registers.size() && !serves(reg)) ++reg;
      if (reg == old_.registers.size()) {
        reg = new_register(output.leaf.name + ".held", output.leaf.width, "until the next is done",
                           frame_.output_resets[o]);
        out_.registers[reg].leaf.is_signed = output.leaf.is_signed;
        out_.registers[reg].leaf.enumeration = output.leaf.enumeration;
        out_.registers[reg].next =
            nodes_.mux(steps_.at(order_.last), read(output.value, order_.last), present(reg));
      }
      out_.outputs.push_back({output.leaf, present(reg)});
    }
  }

  void make_control() {
    const unsigned width = steps_.width();
    const NodeId step = present(step_);
    const NodeId waiting = steps_.at(0);
    const NodeId counted = nodes_.binary(Op::kAdd, step, nodes_.constant(width, 1));
    const NodeId following = nodes_.mux(steps_.at(order_.last), nodes_.constant(width, 0), counted);
    out_.registers[step_].next = nodes_.mux(waiting, nodes_.zext(start_, width), following);
    const NodeId busy = nodes_.unary_not(waiting);
    const unsigned done = new_register("done", 1, "");
    out_.registers[done].next = steps_.at(order_.last);
    const unsigned missed = new_register("missed", 1, "");
    out_.registers[missed].next = nodes_.binary(Op::kAnd, start_, busy);
    out_.outputs.push_back({frame_.done, present(done)});
    out_.outputs.push_back({frame_.busy, busy});
    out_.outputs.push_back({frame_.missed, present(missed)});
  }

  const Operations& ops_;
  const Order& order_;
  const Keeping& k_;
  const Binding& b_;
  const Frame& frame_;
  const Module& old_;
  Module out_;
  NodeBuilder nodes_;
  Steps steps_;
  std::vector<NodeId> value_;  // per old node, as computed
  std::vector<std::size_t> unit_of_;
  std::vector<Unit> units_;
  std::vector<unsigned> kept_;  // registers
  NodeId start_ = kNone;
  unsigned step_ = 0;
};

}  // namespace

Module build(const Operations& operations, const Order& order, const Keeping& keeping,
             const Binding& binding, const Frame& frame) {
  return Builder(operations, order, keeping, binding, frame).run();
}

}  // namespace hlsgen::scheduling
