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

MemoryPorts memory_ports(const Module& m) {
  MemoryPorts ports;
  for (unsigned i = 0; i < m.inputs.size(); ++i) {
    const std::string& name = m.inputs[i].name;
    if (name == "address") ports.address = i;
    if (name == "read") ports.read = i;
    if (name == "write") ports.write = i;
    if (name == "write_address") ports.write_address = i;
    if (name == "write_data") ports.write_data = i;
  }
  return ports;
}

std::string print_memory(const Module& m) {
  const auto& contents = m.tables[0].entries;
  const unsigned width = contents[0].getBitWidth();
  const MemoryPorts ports = memory_ports(m);
  std::string out = fmt::format("// {}: of {}, printed by hlsgen from {}:{}.\n\n", m.name,
                                m.cpp_class, m.source.file, m.source.line);
  const auto port = [&](const char* direction, const Leaf& leaf, const char* tail, bool is_last) {
    const std::string range = leaf.width == 1 ? "" : fmt::format("[{}:0] ", leaf.width - 1);
    const std::string comment = leaf.comment.empty() ? "" : "  // " + leaf.comment;
    out += fmt::format("    {} logic {}{}{}{}{}\n", direction, range, leaf.name, tail,
                       is_last ? "" : ",", comment);
  };
  out += fmt::format("module {} (\n", m.name);
  port("input ", {"clk", 1, false, -1, ""}, "", false);
  port("input ", {"rst", 1, false, -1, "the words stay"}, "", false);
  for (const Leaf& leaf : m.inputs) port("input ", leaf, "_i", false);
  port("output", m.outputs[0].leaf, "_o", true);
  out += ");\n";
  out += fmt::format("  (* no_rw_check *)\n  logic [{}:0] words [0:{}];\n\n", width - 1,
                     contents.size() - 1);
  out += "  initial begin\n";
  for (std::size_t i = 0; i < contents.size(); ++i)
    out += fmt::format("    words[{}] = {}'h{};\n", i, width,
                       llvm::toString(contents[i], 16, false, false));
  out += "  end\n\n  always_ff @(posedge clk) begin\n";
  const unsigned lanes = ports.write ? m.inputs[*ports.write].width : 0;
  if (lanes == 1) out += "    if (write_i) words[write_address_i] <= write_data_i;\n";
  for (unsigned lane = 0; lanes > 1 && lane < lanes; ++lane) {
    const unsigned low = lane * (width / lanes), high = low + width / lanes - 1;
    out += fmt::format("    if (write_i[{}]) words[write_address_i][{}:{}] <= write_data_i[{}:{}];\n",
                       lane, high, low, high, low);
  }
  out += fmt::format("    {}data_o <= words[address_i];\n", ports.read ? "if (read_i) " : "");
  out += "  end\n\n  wire unused = &{1'b0, rst};\nendmodule\n";
  return out;
}

}  // namespace hlsgen
