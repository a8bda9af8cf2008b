// Runs a netlist, clock by clock: the oracle between the C++ and the printed SystemVerilog.
//
// Doc: docs/generator.md   Test: tests/generator/frontend/design_test.cpp

#pragma once

#include <memory>
#include <vector>

#include "generator/netlist.hpp"

namespace hlsgen {

class Interpreter {
 public:
  // Of the design's top, or of the module called so.  The design must outlive the interpreter.
  explicit Interpreter(const Design& design, const std::string& module = {});
  ~Interpreter();

  void reset();

  // Outputs for these inputs in the present state, which then moves on.
  std::vector<llvm::APInt> clock(const std::vector<llvm::APInt>& inputs);

 private:
  class Cell;
  std::unique_ptr<Cell> top_;
};

}  // namespace hlsgen
