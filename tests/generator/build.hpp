// Netlists by hand, for tests of the back end.

#pragma once

#include "generator/netlist.hpp"

#include <string>
#include <utility>

namespace hlsgen::test {

class Build {
 public:
  explicit Build(std::string name) {
    m.name = std::move(name);
    m.cpp_class = "test::Block";
    m.source = {"hls/test/block.hpp", 10};
  }

  NodeId add(Node n) {
    m.nodes.push_back(std::move(n));
    return static_cast<NodeId>(m.nodes.size() - 1);
  }
  unsigned width(NodeId id) const { return m.nodes[id].width; }

  NodeId input(const std::string& name, unsigned w, bool is_signed = false, int enumeration = -1) {
    m.inputs.push_back({name, w, is_signed, enumeration, ""});
    return source(Op::kInput, w, m.inputs.size() - 1);
  }
  NodeId reg(const std::string& name, unsigned w, std::uint64_t reset = 0, int enumeration = -1) {
    m.registers.push_back({{name, w, false, enumeration, ""}, llvm::APInt(w, reset), kNone, {}});
    return source(Op::kRegister, w, m.registers.size() - 1);
  }
  void next(NodeId reg, NodeId value) { m.registers[m.nodes[reg].index].next = value; }
  void output(const std::string& name, NodeId value, int enumeration = -1) {
    m.outputs.push_back({{name, width(value), false, enumeration, ""}, value});
  }

  NodeId constant(unsigned w, std::uint64_t value) {
    Node n;
    n.width = w;
    n.value = llvm::APInt(w, value);
    return add(n);
  }
  NodeId op(Op o, NodeId a, NodeId b) {
    Node n;
    n.op = o;
    n.width = o >= Op::kEq && o <= Op::kSle ? 1 : width(a);
    n.in = {a, b};
    return add(n);
  }
  NodeId inv(NodeId a) {
    Node n;
    n.op = Op::kNot;
    n.width = width(a);
    n.in = {a};
    return add(n);
  }
  NodeId mux(NodeId c, NodeId a, NodeId b) {
    Node n;
    n.op = Op::kMux;
    n.width = width(a);
    n.in = {c, a, b};
    return add(n);
  }
  NodeId slice(NodeId a, unsigned high, unsigned low) {
    Node n;
    n.op = Op::kSlice;
    n.width = high - low + 1;
    n.low = low;
    n.in = {a};
    return add(n);
  }
  NodeId concat(std::vector<NodeId> parts) {
    Node n;
    n.op = Op::kConcat;
    n.width = 0;
    for (const NodeId p : parts) n.width += width(p);
    n.in = std::move(parts);
    return add(n);
  }
  NodeId extend(Op o, NodeId a, unsigned w) {
    Node n;
    n.op = o;
    n.width = w;
    n.in = {a};
    return add(n);
  }
  NodeId zext(NodeId a, unsigned w) { return extend(Op::kZext, a, w); }
  NodeId sext(NodeId a, unsigned w) { return extend(Op::kSext, a, w); }
  NodeId table(unsigned w, const std::vector<std::uint64_t>& entries, NodeId address) {
    Table t{"table", w, {}};
    for (const std::uint64_t e : entries) t.entries.emplace_back(w, e);
    m.tables.push_back(std::move(t));
    Node n;
    n.op = Op::kTable;
    n.width = w;
    n.index = static_cast<unsigned>(m.tables.size() - 1);
    n.in = {address};
    return add(n);
  }
  NodeId instance_output(unsigned index, unsigned port, unsigned w) {
    Node n;
    n.op = Op::kInstanceOutput;
    n.width = w;
    n.index = index;
    n.port = port;
    return add(n);
  }
  NodeId named(NodeId id, const std::string& name, unsigned line = 0) {
    m.nodes[id].name = name;
    m.nodes[id].source = {m.source.file, line};
    return id;
  }

  Module m;

 private:
  NodeId source(Op o, unsigned w, std::size_t index) {
    Node n;
    n.op = o;
    n.width = w;
    n.index = static_cast<unsigned>(index);
    return add(n);
  }
};

}  // namespace hlsgen::test
