#include "generator/print/write_module.hpp"

#include "generator/names.hpp"
#include "generator/print/synchronisers.hpp"
#include "generator/print/write_expression.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace hlsgen {
namespace {

using syntax::Block;
using syntax::Expr;
using syntax::Statement;

class Writer {
 public:
  std::string run(const syntax::Text& t) {
    for (const std::string& line : t.header) out_ += line.empty() ? "//\n" : "// " + disarm(line) + "\n";
    out_ += "\n";
    ports(t);
    for (const auto& [name, value] : t.constants)
      line(1, fmt::format("localparam logic {}{} = {};", write_range(value.width), name,
                          write_flat(value)));
    if (!t.constants.empty()) out_ += "\n";
    declare_registers(t.registers);
    if (!t.registers.empty()) out_ += "\n";
    for (const syntax::Item& item : t.items)
      std::visit([this](const auto& i) { write(i); }, item);
    if (!t.items.empty()) out_ += "\n";
    if (!t.updates.statements.empty()) registers(t);
    for (const auto& [port, value] : t.assigns)
      out_ += write_assignment(2, "assign " + port + " =", value);
    if (!t.unused.empty()) unused(t.unused);
    out_ += "endmodule\n";
    return std::move(out_);
  }

 private:
  void line(unsigned level, const std::string& text) {
    out_ += std::string(2 * static_cast<std::size_t>(level), ' ') + text + "\n";
  }

  void ports(const syntax::Text& t) {
    struct Port {
      std::string direction, range, name, comment;
    };
    std::vector<Port> list;
    if (t.clocked) {
      list.push_back({"input ", "", std::string(kClockPort), ""});
      list.push_back({"input ", "", std::string(kResetPort), "synchronous, active high"});
    }
    for (const syntax::Signal& s : t.inputs)
      list.push_back({"input ", write_range(s.width), s.name, s.comment});
    for (const syntax::Signal& s : t.outputs)
      list.push_back({"output", write_range(s.width), s.name, s.comment});
    std::size_t widest = 0;
    for (const Port& p : list) widest = std::max(widest, p.range.size());

    out_ += "module " + t.name;
    if (!t.parameters.empty()) {
      out_ += " #(\n";
      for (std::size_t i = 0; i < t.parameters.size(); ++i)
        line(2, fmt::format("parameter logic {} = 1'b{:d}{}{}", t.parameters[i].name, t.parameters[i].value,
                            i + 1 == t.parameters.size() ? "" : ",",
                            write_comment(t.parameters[i].comment)));
      out_ += ")";
    }
    out_ += " (\n";
    for (std::size_t i = 0; i < list.size(); ++i)
      line(2, fmt::format("{} logic {:<{}}{}{}{}", list[i].direction, list[i].range, widest,
                          list[i].name, i + 1 == list.size() ? "" : ",",
                          write_comment(list[i].comment)));
    out_ += ");\n";
  }

  void write(const syntax::Wire& w) {
    out_ += write_assignment(2, fmt::format("wire {}{} =", write_range(w.width), w.name), w.value,
                             w.comment);
  }

  void write(const syntax::Cell& c) {
    out_ += "\n";
    for (const auto& o : c.outputs)
      line(1, fmt::format("wire {}{};", write_range(o.width), o.wire));
    std::string parameters;
    for (const auto& [parameter, value] : c.parameters)
      parameters += fmt::format("{}.{}({})", parameters.empty() ? "" : ", ", parameter, write_flat(value));
    if (!parameters.empty()) parameters = "#(" + parameters + ") ";
    line(1, c.module + " " + parameters + c.name + " (");
    std::vector<std::string> pins;
    if (c.clocked) {
      pins.push_back(fmt::format(".{0}({0})", kClockPort));
      pins.push_back(fmt::format(".{0}({0})", kResetPort));
    }
    for (const auto& [port, value] : c.inputs)
      pins.push_back(fmt::format(
          ".{}({})", port,
          write_wrapped(value, static_cast<unsigned>(port.size()) + 6, 8)));
    for (const auto& o : c.outputs) pins.push_back(fmt::format(".{}({})", o.port, o.wire));
    for (std::size_t i = 0; i < pins.size(); ++i)
      line(3, pins[i] + (i + 1 == pins.size() ? "" : ","));
    line(1, ");");
    out_ += "\n";
  }

  void write(const syntax::Case& c) {
    out_ += "\n";
    for (const auto& t : c.targets)
      line(1, fmt::format("logic {}{};{}", write_range(t.width), t.name, write_comment(c.comment)));
    line(1, "always_comb begin");
    case_of_values(c, 2);
    line(1, "end");
    out_ += "\n";
  }

  void case_of_values(const syntax::Case& c, unsigned level) {
    line(level, "case (" + write_flat(c.selector) + ")");
    for (const syntax::Case::Arm& arm : c.arms) {
      const std::string head = labels(arm.labels, level + 1) + ":";
      if (c.targets.size() == 1) {
        out_ += write_assignment(2 * (level + 1), head + " " + c.targets[0].name + " =",
                                 arm.values[0]);
        continue;
      }
      line(level + 1, head + " begin");
      for (std::size_t i = 0; i < c.targets.size(); ++i)
        out_ += write_assignment(2 * (level + 2), c.targets[i].name + " =", arm.values[i]);
      line(level + 1, "end");
    }
    line(level, "endcase");
  }

  // In as many lines as it takes; the rest of the last one is the caller's.
  static std::string labels(const std::vector<Expr>& list, unsigned level) {
    if (list.empty()) return level == 0 ? "" : "default";
    const std::string start(2 * static_cast<std::size_t>(level), ' ');
    constexpr std::size_t kCloser = 8;  // ": begin"
    std::string out;
    std::size_t column = start.size();
    for (const Expr& label : list) {
      const std::string text = write_flat(label);
      if (!out.empty()) {
        const bool fits = level == 0 || column + 2 + text.size() + kCloser <= kColumns;
        out += fits ? ", " : ",\n" + start;
        column = fits ? column + 2 : start.size();
      }
      out += text;
      column += text.size();
    }
    return out;
  }

  // Neighbours that synchronise share one declaration, which carries their marks.
  void declare_registers(const std::vector<syntax::Signal>& list) {
    const auto alike = [&](std::size_t a, std::size_t b) {
      return b < list.size() && list[a].synchronises && list[b].synchronises &&
             list[a].width == list[b].width;
    };
    for (std::size_t i = 0; i < list.size(); ++i) {
      const syntax::Signal& r = list[i];
      const bool goes_on = i > 0 && alike(i - 1, i), more = alike(i, i + 1);
      const std::string type = (r.is_signed ? "logic signed " : "logic ") + write_range(r.width);
      if (r.synchronises && !goes_on) line(1, kSynchroniserMarks);
      if (more && !goes_on) line(1, type.substr(0, type.size() - 1));
      line(goes_on || more ? 3 : 1, fmt::format("{}{}{}{}", goes_on || more ? "" : type, r.name,
                                                more ? "," : ";", write_comment(r.comment)));
    }
  }

  void registers(const syntax::Text& t) {
    line(1, fmt::format("always_ff @(posedge {}) begin", kClockPort));
    // The reset comes last and wins: so a simulator that reads each register before it writes it needs
    // no second copy of it (Verilator runs the drive a tenth faster).
    body(t.updates, 2);
    line(2, fmt::format("if ({}) begin", kResetPort));
    body(t.resets, 3);
    line(2, "end");
    line(1, "end");
    out_ += "\n";
  }

  void body(const Block& block, unsigned level) {
    for (const syntax::Item& item : block.locals) declare(item, level);
    for (const syntax::Item& item : block.locals) {
      if (const auto* wire = std::get_if<syntax::Wire>(&item))
        out_ += write_assignment(2 * level, wire->name + " =", wire->value, wire->comment);
      if (const auto* c = std::get_if<syntax::Case>(&item)) case_of_values(*c, level);
    }
    for (const Statement& s : block.statements) {
      if (!s.target.empty()) {
        out_ += write_assignment(2 * level, s.target + " <=", s.value, s.comment);
      } else if (!s.arms.empty()) {
        case_of_blocks(s, level);
      } else {
        out_ += std::string(2 * static_cast<std::size_t>(level), ' ');
        branch(s, level);
      }
    }
  }

  void declare(const syntax::Item& item, unsigned level) {
    const auto one = [&](const std::string& name, unsigned width, const std::string& comment) {
      line(level, fmt::format("logic {}{};{}", write_range(width), name, write_comment(comment)));
    };
    if (const auto* wire = std::get_if<syntax::Wire>(&item)) one(wire->name, wire->width, "");
    if (const auto* c = std::get_if<syntax::Case>(&item))
      for (const auto& t : c->targets) one(t.name, t.width, c->comment);
  }

  // The indent is written already: it may stand behind an else.
  void branch(const Statement& s, unsigned level) {
    const std::string start(2 * static_cast<std::size_t>(level), ' ');
    out_ += "if (" + write_wrapped(s.value, 2 * level + 14, 2 * level + 4) + ") begin" +
            write_comment(s.comment) + "\n";
    body(s.then, level + 1);
    out_ += start + "end";
    const Block& other = s.otherwise;
    if (other.locals.empty() && other.statements.size() == 1 && other.statements[0].is_if()) {
      out_ += " else ";
      branch(other.statements[0], level);
      return;
    }
    if (!other.statements.empty()) {
      out_ += " else begin\n";
      body(other, level + 1);
      out_ += start + "end";
    }
    out_ += "\n";
  }

  void case_of_blocks(const Statement& s, unsigned level) {
    line(level, "case (" + write_flat(s.value) + ")");
    for (const Statement::Arm& arm : s.arms) {
      const std::string head = labels(arm.labels, level + 1) + ":";
      const std::vector<Statement>& list = arm.block.statements;
      if (list.empty()) {
        line(level + 1, head + " ;");
      } else if (list.size() == 1 && arm.block.locals.empty() && !list[0].target.empty()) {
        out_ += write_assignment(2 * (level + 1), head + " " + list[0].target + " <=",
                                 list[0].value, list[0].comment);
      } else {
        line(level + 1, head + " begin" + write_comment(labels(arm.rest, 0)));
        body(arm.block, level + 2);
        line(level + 1, "end");
      }
    }
    line(level, "endcase");
  }

  void unused(const std::vector<Expr>& signals) {
    std::vector<Expr> parts = signals;
    parts.insert(parts.begin(), syntax::literal(llvm::APInt(1, 0)));
    out_ += "\n";
    line(1, "// What nothing reads, for the linters.");
    out_ += write_assignment(2, "wire unused =",
                             syntax::unary("&", syntax::concat(std::move(parts)), 1));
  }

  std::string out_;
};

}  // namespace

std::string write_module(const syntax::Text& text) {
  std::string s = Writer().run(text);
  // Items bring their own blank lines; two in a row say nothing more.
  for (std::size_t at = 0; (at = s.find("\n\n\n", at)) != std::string::npos;) s.erase(at, 1);
  for (std::size_t at = 0; (at = s.find(");\n\n", at)) != std::string::npos; ++at) {
    if (at != 0 && s[at - 1] == '\n') s.erase(at + 3, 1);  // right behind the ports
  }
  return s;
}

}  // namespace hlsgen
