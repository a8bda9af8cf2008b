// What follows the adder: a shifted sum cut to its format.
//
//     bits below the format's end    the sum's, or the nearest end's where a clamp does not fit
//     bits from there on             its sign, the cut's top bit, or 0
//     flags                          0 or 1
//
// Test: tests/generator/machine_test.cpp

#pragma once

#include "generator/dataflow/nodes.hpp"
#include "generator/machine/program.hpp"

#include <vector>

namespace hlsgen::machine {

class FormatUnit {
 public:
  FormatUnit(NodeBuilder& nodes, const std::vector<Format>& formats, std::vector<Table>& tables)
      : nodes_(nodes), formats_(formats), tables_(tables) {}

  // A number of `width` bits.
  NodeId make(NodeId sum, NodeId shifted, unsigned width, NodeId format, NodeId invert) const;

 private:
  NodeId fits(const Format& format, NodeId shifted) const;
  NodeId above(const Format& format, NodeId shifted) const;

  NodeBuilder& nodes_;
  const std::vector<Format>& formats_;
  std::vector<Table>& tables_;
};

}  // namespace hlsgen::machine
