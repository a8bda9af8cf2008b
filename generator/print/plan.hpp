// Which values become wires of their own, which are written where they are used, and which muxes
// read better as `case`.
//
//     used more than once, or named in C++, or too long   ->  a wire
//     s == 0 ? a : s == 1 ? b : s == 2 ? c : d            ->  a case
//
// Test: tests/generator/backend_print_test.cpp

#pragma once

#include "generator/netlist.hpp"
#include "generator/print/decide.hpp"

#include <map>
#include <optional>
#include <vector>

namespace hlsgen {

struct CaseChain {
  struct Arm {
    std::vector<llvm::APInt> labels;
    NodeId value;
  };
  NodeId selector = kNone;
  std::vector<Arm> arms;
  NodeId otherwise = kNone;
};

struct Plan {
  std::vector<unsigned> uses;  // 0: no one reads the node
  std::vector<bool> wire;      // printed as a wire
  std::vector<int> enumeration;  // of the value, or -1
  std::map<NodeId, CaseChain> cases;
};

// One side of a product, seen through its extension: the multiplier is as wide as the values are.
struct Factor {
  NodeId value = kNone;
  unsigned width = 1;
  bool is_signed = false;  // extended by its sign
};
Factor factor(const Module& module, NodeId operand);

// `clocked` is what the registers do.
Plan plan(const Module& module, const Branch& clocked);

// Uses and enumerations alone; the passes need them as well.
// With `clocked`, its reads count instead of the registers' next values.
std::vector<unsigned> count_uses(const Module& module,
                                 const std::map<NodeId, CaseChain>& cases = {},
                                 const Branch* clocked = nullptr);
std::vector<int> infer_enumerations(const Module& module);

// The chain that starts at this mux, if it has three arms at least.
std::optional<CaseChain> find_case(const Module& module, const std::vector<unsigned>& uses,
                                   NodeId head, std::vector<NodeId>* inner);

}  // namespace hlsgen
