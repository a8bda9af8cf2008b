// A module of the netlist as a syntax tree that every tool accepts.
//
// Test: tests/generator/backend_print_test.cpp

#pragma once

#include "generator/netlist.hpp"
#include "generator/print/syntax.hpp"

namespace hlsgen {

syntax::Text legalise(const Design& design, const Module& module);

// The bits of inputs, wires and registers that nothing reads, for Verilator's peace.
std::vector<syntax::Expr> find_unused(const syntax::Text& text);

}  // namespace hlsgen
