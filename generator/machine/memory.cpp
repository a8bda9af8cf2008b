#include "generator/machine/memory.hpp"

#include <fmt/format.h>
#include <llvm/ADT/StringExtras.h>

namespace hlsgen {

bool is_memory(const Module& m) { return m.nodes.empty() && !m.tables.empty(); }

Module memory_module(const std::string& name, const Module& of, std::vector<llvm::APInt> contents,
                     bool is_written) {
  Module m;
  m.name = name;
  m.cpp_class = of.cpp_class;
  m.source = of.source;
  const unsigned width = contents[0].getBitWidth();
  const unsigned address = llvm::Log2_64_Ceil(contents.size());
  m.inputs.push_back({"address", address, false, -1, ""});
  if (is_written) {
    m.inputs.push_back({"write", 1, false, -1, ""});
    m.inputs.push_back({"write_address", address, false, -1, ""});
    m.inputs.push_back({"write_data", width, false, -1, ""});
  }
  m.outputs.push_back({{"data", width, false, -1, "of the address one clock before"}, kNone});
  m.tables.push_back({"words", width, std::move(contents)});
  return m;
}

std::string print_memory(const Module& m) {
  const auto& contents = m.tables[0].entries;
  const unsigned width = contents[0].getBitWidth(), address = m.inputs[0].width;
  const bool is_written = m.inputs.size() > 1;
  std::string out = fmt::format("// {}: of {}, printed by hlsgen from {}:{}.\n\n", m.name,
                                m.cpp_class, m.source.file, m.source.line);
  const auto port = [&](const char* direction, unsigned bits, const char* name, const char* end) {
    const std::string range = bits == 1 ? "" : fmt::format("[{}:0] ", bits - 1);
    out += fmt::format("    {} logic {}{}{}\n", direction, range, name, end);
  };
  out += fmt::format("module {} (\n", m.name);
  port("input ", 1, "clk", ",");
  port("input ", 1, "rst", ",  // the words stay");
  port("input ", address, "address_i", ",");
  if (is_written) {
    port("input ", 1, "write_i", ",");
    port("input ", address, "write_address_i", ",");
    port("input ", width, "write_data_i", ",");
  }
  port("output", width, "data_o", "  // of the address one clock before");
  out += ");\n";
  out += fmt::format("  (* no_rw_check *)\n  logic [{}:0] words [0:{}];\n\n", width - 1,
                     contents.size() - 1);
  out += "  initial begin\n";
  for (std::size_t i = 0; i < contents.size(); ++i)
    out += fmt::format("    words[{}] = {}'h{};\n", i, width,
                       llvm::toString(contents[i], 16, false, false));
  out += "  end\n\n  always_ff @(posedge clk) begin\n";
  if (is_written) out += "    if (write_i) words[write_address_i] <= write_data_i;\n";
  out += "    data_o <= words[address_i];\n  end\n\n  wire unused = &{1'b0, rst};\nendmodule\n";
  return out;
}

}  // namespace hlsgen
