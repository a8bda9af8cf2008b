// The same netlist, printed as plainly as can be: one wire per node, operators as they are.  Shares
// with the readable printer the names of ports, registers and instances, and nothing else.

#include "generator/backend.hpp"
#include "generator/machine/memory.hpp"
#include "generator/print/identifiers.hpp"

#include <fmt/format.h>
#include <llvm/ADT/SmallString.h>

namespace hlsgen {
namespace {

class Plain {
 public:
  Plain(const Design& design, const Module& module)
      : design_(design), m_(module), names_(design, module), prefix_("n") {
    const auto clashes = [&] {
      for (const auto* list : {&names_.inputs, &names_.outputs, &names_.registers,
                               &names_.instances})
        for (const std::string& name : *list)
          if (name.rfind(prefix_, 0) == 0) return true;
      return false;
    };
    while (clashes()) prefix_ += "_";
  }

  std::string run() {
    std::string parameters;
    for (std::size_t i = 0; i < m_.inputs.size(); ++i)
      if (m_.inputs[i].parameter)
        parameters += fmt::format("{}parameter {} = {:d}", parameters.empty() ? "" : ", ",
                                  names_.inputs[i], *m_.inputs[i].parameter);
    if (!parameters.empty()) parameters = "#(" + parameters + ") ";
    out_ += fmt::format("module {} {}(\n", m_.name, parameters);
    std::string comma;
    const auto port = [&](const char* kind, unsigned width, const std::string& name) {
      out_ += fmt::format("{}  {} [{}:0] {}", comma, kind, width - 1, name);
      comma = ",\n";
    };
    clocked_ = is_clocked(design_, m_);
    if (clocked_) {
      port("input", 1, "clk");
      port("input", 1, "rst");
    }
    for (std::size_t i = 0; i < m_.inputs.size(); ++i)
      if (!m_.inputs[i].parameter) port("input", m_.inputs[i].width, names_.inputs[i]);
    for (std::size_t i = 0; i < m_.outputs.size(); ++i)
      port("output", m_.outputs[i].leaf.width, names_.outputs[i]);
    out_ += "\n);\n";
    for (std::size_t i = 0; i < m_.registers.size(); ++i)
      out_ += fmt::format("  reg [{}:0] {};\n", m_.registers[i].leaf.width - 1,
                          names_.registers[i]);
    for (NodeId id = 0; id < m_.nodes.size(); ++id)
      out_ += fmt::format("  wire [{}:0] {};\n", m_.nodes[id].width - 1, wire(id));
    for (NodeId id = 0; id < m_.nodes.size(); ++id) write_node(id);
    for (std::size_t i = 0; i < m_.instances.size(); ++i) write_instance(i);
    for (std::size_t i = 0; i < m_.registers.size(); ++i)
      out_ += fmt::format("  always @(posedge clk) if (rst) {0} <= {1}; else {0} <= {2};\n",
                          names_.registers[i], bits(m_.registers[i].reset),
                          wire(m_.registers[i].next));
    for (std::size_t i = 0; i < m_.outputs.size(); ++i)
      out_ += fmt::format("  assign {} = {};\n", names_.outputs[i], wire(m_.outputs[i].value));
    return out_ + "endmodule\n";
  }

 private:
  std::string wire(NodeId id) const { return prefix_ + std::to_string(id); }

  static std::string bits(const llvm::APInt& value) {
    llvm::SmallString<160> s;
    value.toString(s, 2, /*Signed=*/false, /*formatAsCLiteral=*/false);
    return fmt::format("{}'b{}", value.getBitWidth(), s.str().str());
  }

  void write_node(NodeId id) {
    const Node& n = m_.nodes[id];
    if (n.op == Op::kInstanceOutput) return;  // driven by the instance
    if (n.op == Op::kTable) return write_table(id);
    out_ += fmt::format("  assign {} = {};\n", wire(id), value(n));
  }

  std::string value(const Node& n) const {
    const auto in = [&](std::size_t i) { return wire(n.in[i]); };
    const auto infix = [&](const char* op) { return in(0) + " " + op + " " + in(1); };
    const auto infix_signed = [&](const char* op) {
      return fmt::format("$signed({}) {} $signed({})", in(0), op, in(1));
    };
    switch (n.op) {
      case Op::kConstant: return bits(n.value);
      case Op::kInput: return names_.inputs[n.index];
      case Op::kRegister: return names_.registers[n.index];
      case Op::kAdd: return infix("+");
      case Op::kSub: return infix("-");
      case Op::kMul: {
        // Signed where a factor is, as a narrow multiplier would be: the proof needs the same shape.
        const bool is_signed =
            m_.nodes[n.in[0]].op == Op::kSext || m_.nodes[n.in[1]].op == Op::kSext;
        return is_signed ? infix_signed("*") : infix("*");
      }
      case Op::kAnd: return infix("&");
      case Op::kOr: return infix("|");
      case Op::kXor: return infix("^");
      case Op::kNot: return "~" + in(0);
      case Op::kShl: return infix("<<");
      case Op::kLshr: return infix(">>");
      case Op::kAshr: return fmt::format("$signed({}) >>> {}", in(0), in(1));
      case Op::kEq: return infix("==");
      case Op::kNe: return infix("!=");
      case Op::kUlt: return infix("<");
      case Op::kUle: return infix("<=");
      case Op::kSlt: return infix_signed("<");
      case Op::kSle: return infix_signed("<=");
      case Op::kMux: return fmt::format("{} ? {} : {}", in(0), in(1), in(2));
      case Op::kSlice: return fmt::format("{}[{}:{}]", in(0), n.low + n.width - 1, n.low);
      case Op::kConcat: {
        std::string s;
        for (std::size_t i = 0; i < n.in.size(); ++i) s += (i == 0 ? "{" : ", ") + in(i);
        return s + "}";
      }
      case Op::kZext: return in(0);
      case Op::kSext: return fmt::format("$signed({})", in(0));
      case Op::kInstanceOutput: case Op::kTable: break;
    }
    throw NetlistError("module " + m_.name + ": a node has no expression");
  }

  void write_table(NodeId id) {
    const Node& n = m_.nodes[id];
    const Table& t = m_.tables[n.index];
    const unsigned address = m_.nodes[n.in[0]].width;
    out_ += fmt::format("  reg [{}:0] {}_entry;\n  always @* case ({})\n", t.width - 1, wire(id),
                        wire(n.in[0]));
    for (std::size_t i = 0; i + 1 < t.entries.size(); ++i)
      if (address >= 64 || (i >> address) == 0)
        out_ += fmt::format("    {}: {}_entry = {};\n", bits(llvm::APInt(address, i)), wire(id),
                            bits(t.entries[i]));
    out_ += fmt::format("    default: {}_entry = {};\n  endcase\n", wire(id),
                        bits(t.entries.back()));
    out_ += fmt::format("  assign {0} = {0}_entry;\n", wire(id));
  }

  void write_instance(std::size_t index) {
    const Instance& instance = m_.instances[index];
    const Module& child = module_of(design_, instance);
    const FixedNames ports(design_, child);
    std::string pins = is_clocked(design_, child) ? ".clk(clk), .rst(rst)" : "";
    const auto pin = [&](const std::string& port, const std::string& signal) {
      pins += fmt::format("{}.{}({})", pins.empty() ? "" : ", ", port, signal);
    };
    std::string parameters;
    for (std::size_t i = 0; i < ports.inputs.size(); ++i) {
      if (!child.inputs[i].parameter) {
        pin(ports.inputs[i], wire(instance.inputs[i]));
        continue;
      }
      // Not by way of a wire: a parameter wants what is known before there are any.
      parameters += fmt::format("{}.{}({})", parameters.empty() ? "#(" : ", ", ports.inputs[i],
                                value(m_.nodes[instance.inputs[i]]));
    }
    if (!parameters.empty()) parameters += ") ";
    std::vector<NodeId> first(ports.outputs.size(), kNone);
    for (NodeId id = 0; id < m_.nodes.size(); ++id) {
      const Node& n = m_.nodes[id];
      if (n.op != Op::kInstanceOutput || n.index != index) continue;
      if (first[n.port] == kNone) {
        first[n.port] = id;
        pin(ports.outputs[n.port], wire(id));
      } else {
        out_ += fmt::format("  assign {} = {};\n", wire(id), wire(first[n.port]));
      }
    }
    out_ += fmt::format("  {} {}{} ({});\n", child.name, parameters, names_.instances[index], pins);
  }

  const Design& design_;
  const Module& m_;
  FixedNames names_;
  std::string prefix_, out_;
  bool clocked_ = false;
};

}  // namespace

std::string print_plain(const Design& design, const Module& module) {
  if (is_memory(module)) return print_memory(module);
  return Plain(design, module).run();
}

}  // namespace hlsgen
