#include "generator/machine/build.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/machine/code.hpp"
#include "generator/machine/format_unit.hpp"
#include "generator/machine/memory.hpp"

namespace hlsgen::machine {

namespace {

class Builder {
 public:
  Builder(const Program& p, const Order& order, const Frame& frame)
      : p_(p),
        order_(order),
        frame_(frame),
        sample_(*p.sample),
        out_(header(*p.sample)),
        nodes_(out_.nodes),
        code_(p, order) {}

  Built run() {
    make_control();
    make_memories();
    make_operands();
    make_sum();
    make_result();
    make_outputs();
    return {std::move(memories_), std::move(out_)};
  }

 private:
  static Module header(const Module& sample) {
    Module m = sample;
    m.nodes.clear();
    m.outputs.clear();
    m.registers.clear();
    m.tables.clear();
    return m;
  }

  const Value& value(ValueId v) const { return p_.values[v]; }
  unsigned width() const { return p_.word; }

  unsigned new_register(const std::string& name, unsigned bits, const std::string& comment,
                        std::optional<llvm::APInt> reset = std::nullopt) {
    Register r;
    r.leaf = {name, bits, false, -1, comment};
    r.reset = reset.value_or(llvm::APInt(bits, 0));
    out_.registers.push_back(r);
    return static_cast<unsigned>(out_.registers.size() - 1);
  }
  NodeId present(unsigned reg) {
    return nodes_.source_node(Op::kRegister, out_.registers[reg].leaf.width, reg);
  }
  NodeId resized(NodeId a, unsigned bits) {
    return nodes_.width(a) >= bits ? nodes_.slice(a, bits, 0) : nodes_.sext(a, bits);
  }
  NodeId field(unsigned f) { return code_.fields.read(nodes_, word_, f); }

  void make_control() {
    start_ = nodes_.source_node(Op::kInput, 1, static_cast<unsigned>(out_.inputs.size()));
    out_.inputs.push_back(frame_.start);
    const unsigned last = order_.clocks - 1;
    const unsigned bits = bits_for(order_.clocks);
    step_ = new_register("step", bits, "0: waiting for a start; the program's address");
    const NodeId step = present(step_);
    const auto at = [&](unsigned n) { return nodes_.compare(Op::kEq, step, nodes_.constant(bits, n)); };
    const NodeId waiting = at(0);
    ends_ = at(last);
    if (order_.early != 0) ready_ = at(order_.early - 1);
    const NodeId counted = nodes_.binary(Op::kAdd, step, nodes_.constant(bits, 1));
    const NodeId following = nodes_.mux(ends_, nodes_.constant(bits, 0), counted);
    out_.registers[step_].next = nodes_.mux(waiting, nodes_.zext(start_, bits), following);
    busy_ = nodes_.unary_not(waiting);
    active_ = new_register("active", 1, "the word is the program's");
    out_.registers[active_].next = busy_;
    fresh_ = new_register("fresh", 1, "no sample since the reset: registers read as such",
                          llvm::APInt(1, 1));
    out_.registers[fresh_].next =
        nodes_.binary(Op::kAnd, present(fresh_), nodes_.unary_not(ends_));
  }

  // Pads to all that the address can say.
  NodeId memory(const std::string& kind, const std::string& instance, unsigned bits,
                std::vector<llvm::APInt> contents, std::vector<NodeId> inputs) {
    const std::string name = sample_.name + "_" + kind;
    const bool known = std::any_of(memories_.begin(), memories_.end(),
                                   [&](const Module& m) { return m.name == name; });
    if (!known) {
      const unsigned address = nodes_.width(inputs[0]);
      contents.resize(std::size_t{1} << address, llvm::APInt(bits, 0));
      memories_.push_back(memory_module(name, sample_, std::move(contents), inputs.size() > 1));
    }
    out_.instances.push_back({instance, name, std::move(inputs)});
    return nodes_.source_node(Op::kInstanceOutput, bits,
                              static_cast<unsigned>(out_.instances.size() - 1), 0);
  }

  void make_memories() {
    word_ = memory("program", "program", code_.fields.bits(), code_.fields.words(), {present(step_)});
    result_ = new_register("result", width(), "in its format");
    std::vector<llvm::APInt> contents(order_.cells, llvm::APInt(width(), 0));
    for (ValueId v = 0; v < p_.values.size(); ++v)
      if (value(v).source == Source::kConstant && order_.cell_of[v])
        contents[*order_.cell_of[v]] = value(v).constant.trunc(width());
    for (unsigned r = 0; r < sample_.registers.size(); ++r) {
      const Register& reg = sample_.registers[r];
      contents[*order_.states[r] + 1] = reg.leaf.is_signed ? reg.reset.sextOrTrunc(width())
                                                           : reg.reset.zextOrTrunc(width());
    }
    const NodeId writes = nodes_.binary(Op::kAnd, field(code_.write), present(active_));
    nodes_.hint(writes, "writes");
    for (unsigned bank = kA; bank < kBanks; ++bank) {
      if (!code_.has_bank(bank)) continue;
      const NodeId low = nodes_.binary(
          Op::kOr, nodes_.bit(field(code_.read[bank]), 0),
          nodes_.binary(Op::kAnd, field(code_.old[bank]), present(fresh_)));
      const NodeId address = code_.address == 1 ? low
          : nodes_.concat({nodes_.slice(field(code_.read[bank]), code_.address - 1, 1), low});
      bank_[bank] = memory("numbers", fmt::format("numbers_{}", "abcd"[bank]), width(), contents,
                           {address, writes, field(code_.to), present(result_)});
    }
    if (!code_.has_entries) return;
    const unsigned bits = bits_for(p_.table.size());
    unsigned entry = 1;
    for (const Number& x : p_.table) entry = std::max(entry, x.getActiveBits());
    std::vector<llvm::APInt> entries;
    for (const Number& x : p_.table) entries.push_back(x.trunc(entry));
    entry_ = memory("table", "table", entry, entries, {resized(present(result_), bits)});
  }

  // Product, port and the early condition: what is made a clock before the sum.
  void make_operands() {
    if (!code_.inputs.empty()) {
      unsigned bits = 1;
      for (const unsigned i : code_.inputs)
        bits = std::max(bits, sample_.inputs[i].width + (sample_.inputs[i].is_signed ? 0 : 1));
      std::vector<NodeId> list;
      for (const unsigned i : code_.inputs) {
        const Leaf& leaf = sample_.inputs[i];
        const NodeId input = nodes_.source_node(Op::kInput, leaf.width, i);
        list.push_back(leaf.is_signed ? nodes_.sext(input, bits) : nodes_.zext(input, bits));
      }
      port_read_ = new_register("port", bits, "an input, held from start to done");
      out_.registers[port_read_].next = nodes_.choice(list, field(code_.port));
    }
    if (code_.has_bank(kC)) {
      const NodeId first = nodes_.mux(field(code_.factor_result), present(result_), bank_[kC]);
      nodes_.hint(first, "factor");
      early_ = new_register("condition", 1, "of a choice");
      out_.registers[early_].next = nodes_.bit(first, 0);
      if (!code_.has_products) return;
      const NodeId second = code_.inputs.empty() ? bank_[kD]
          : nodes_.mux(field(code_.factor_port), resized(present(port_read_), width()), bank_[kD]);
      nodes_.hint(second, "second_factor");
      const unsigned bits = p_.factor + p_.second_factor;
      product_ = new_register("product", bits, "of two factors");
      out_.registers[product_].next = nodes_.binary(
          Op::kMul, nodes_.sext(resized(first, p_.factor), bits),
          nodes_.sext(resized(second, p_.second_factor), bits));
    }
  }

  void make_sum() {
    sum_ = new_register("sum", p_.sum, "of two numbers");
    NodeId a_gate = field(code_.a_on), b_gate = field(code_.b_on);
    if (code_.has_conditions) {
      const NodeId read = code_.inputs.empty() ? present(early_) : nodes_.bit(present(port_read_), 0);
      const NodeId found = nodes_.choice({present(early_), nodes_.bit(present(result_), 0),
                                   nodes_.bit(present(sum_), p_.sum - 1), read}, field(code_.test));
      const NodeId test = nodes_.binary(Op::kXor, found, field(code_.unless));
      const NodeId always = nodes_.unary_not(field(code_.test_on));
      nodes_.hint(found, "tested");
      nodes_.hint(test, "holds");
      a_gate = nodes_.binary(Op::kAnd, a_gate, nodes_.binary(Op::kOr, always, test));
      b_gate = nodes_.binary(Op::kAnd, b_gate,
                             nodes_.binary(Op::kOr, always, nodes_.unary_not(test)));
    }
    const NodeId a_late = nodes_.mux(field(code_.a_sum), resized(present(sum_), p_.word), present(result_));
    NodeId a = resized(nodes_.mux(field(code_.a_new), a_late, bank_[kA]), p_.sum);
    const NodeId none = nodes_.constant(p_.sum, 0);
    NodeId b_late = nodes_.choice({code_.has_products ? resized(present(product_), p_.sum) : none,
                            resized(present(result_), p_.sum),
                            code_.inputs.empty() ? none : resized(present(port_read_), p_.sum),
                            code_.has_entries ? nodes_.zext(entry_, p_.sum) : none}, field(code_.b_from));
    NodeId b = nodes_.mux(field(code_.b_new), b_late, resized(bank_[kB], p_.sum));
    nodes_.hint(a_gate, "takes_a");
    nodes_.hint(b_gate, "takes_b");
    nodes_.hint(a_late, "recent_a");
    nodes_.hint(b_late, "recent_b");
    nodes_.hint(b, "operand_b");
    a = nodes_.binary(Op::kAnd, a, spread(a_gate));
    nodes_.hint(a, "gated_a");
    b = nodes_.binary(Op::kXor, nodes_.binary(Op::kAnd, b, spread(b_gate)), spread(field(code_.negate)));
    // The carry as a place below: adders have no other way in.
    const NodeId wide = nodes_.binary(Op::kAdd, nodes_.concat({a, nodes_.constant(1, 1)}),
                                      nodes_.concat({b, field(code_.carry)}));
    nodes_.hint(wide, "sum_and_carry");
    NodeId sum = nodes_.slice(wide, p_.sum, 1);
    if (code_.has_logic) {
      sum = nodes_.choice({sum, nodes_.binary(Op::kAnd, a, b), nodes_.binary(Op::kOr, a, b),
                    nodes_.binary(Op::kXor, a, b)}, field(code_.logic));
    }
    out_.registers[sum_].next = sum;
  }
  NodeId spread(NodeId bit) { return nodes_.sext(bit, p_.sum); }

  void make_result() {
    const FormatUnit unit(nodes_, code_.formats, out_.tables);
    const NodeId shifted = code_.most_shift == 0 ? present(sum_)
        : nodes_.shift(Op::kAshr, present(sum_), field(code_.shift));
    nodes_.hint(shifted, "shifted_down");
    out_.registers[result_].next =
        unit.make(present(sum_), shifted, width(), field(code_.format), field(code_.invert));
  }

  void make_outputs() {
    std::vector<unsigned> gathered;
    for (std::size_t g = 0; g < code_.groups.size(); ++g) {
      unsigned bits = 1;
      std::string name;
      for (std::size_t o = 0; o < p_.outputs.size(); ++o) {
        if (p_.outputs[o] != code_.groups[g]) continue;
        bits = std::max(bits, sample_.outputs[o].leaf.width);
        if (name.empty()) name = sample_.outputs[o].leaf.name;
      }
      gathered.push_back(new_register(name + ".new", std::min(bits, width()), "of this sample"));
      const NodeId shows = nodes_.compare(
          Op::kEq, field(code_.show), nodes_.constant(bits_for(code_.groups.size() + 1), g + 1));
      out_.registers[gathered[g]].next =
          nodes_.mux(shows, resized(present(result_), std::min(bits, width())),
                     present(gathered[g]));
    }
    for (std::size_t o = 0; o < p_.outputs.size(); ++o) {
      const Output& output = sample_.outputs[o];
      const unsigned reg = new_register(output.leaf.name + ".held", output.leaf.width,
                                        "until the next is done", frame_.output_resets[o]);
      out_.registers[reg].leaf.is_signed = output.leaf.is_signed;
      out_.registers[reg].leaf.enumeration = output.leaf.enumeration;
      const unsigned group = static_cast<unsigned>(code_.group_of.at(p_.outputs[o])) - 1;
      out_.registers[reg].next =
          nodes_.mux(p_.early[o] ? ready_ : ends_,
                     resized(present(gathered[group]), output.leaf.width), present(reg));
      out_.outputs.push_back({output.leaf, present(reg)});
    }
    const unsigned done = new_register("done", 1, "");
    out_.registers[done].next = ends_;
    const unsigned missed = new_register("missed", 1, "");
    out_.registers[missed].next = nodes_.binary(Op::kAnd, start_, busy_);
    out_.outputs.push_back({frame_.done, present(done)});
    out_.outputs.push_back({frame_.busy, busy_});
    out_.outputs.push_back({frame_.missed, present(missed)});
  }

  const Program& p_;
  const Order& order_;
  const Frame& frame_;
  const Module& sample_;
  Module out_;
  NodeBuilder nodes_;
  Code code_;
  std::vector<Module> memories_;

  NodeId start_ = kNone, word_ = kNone, ends_ = kNone, ready_ = kNone, busy_ = kNone, entry_ = kNone;
  NodeId bank_[kBanks] = {kNone, kNone, kNone, kNone};
  unsigned step_ = 0, active_ = 0, fresh_ = 0, port_read_ = 0, early_ = 0, product_ = 0;
  unsigned sum_ = 0, result_ = 0;
};

}  // namespace

Built build(const Program& program, const Order& order, const Frame& frame) {
  return Builder(program, order, frame).run();
}

}  // namespace hlsgen::machine
