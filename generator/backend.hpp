// The back end: netlist in, SystemVerilog out.
//
//     check -> optimise -> check -> print_module, print_plain, print_file_list
//
// The two printers share nothing but the spelling of ports, registers and instances, so that a proof
// of their equality (tools/prove_print) says something about each.
//
// Doc: docs/generator.md   Test: tests/generator/backend_print_test.cpp, backend_pass_test.cpp

#pragma once

#include "generator/netlist.hpp"

#include <stdexcept>
#include <string>

namespace hlsgen {

// An invariant of the netlist does not hold: a fault of hlsgen itself, or two names of the source
// that become one.  The message names module and node.
struct NetlistError : std::logic_error {
  using std::logic_error::logic_error;
};

// Operands exist, stand before their users and have the widths their operator asks for; registers,
// outputs and instances are complete; no two ports share a name.
void check(const Design& design);

// Rewrites every module into one that behaves the same and synthesizes smaller.
void optimise(Design& design);

// Whether the module has ports for clock and reset: it, or a child, has registers.
bool is_clocked(const Design& design, const Module& module);

// For people: lint-clean, in the common subset of Yosys 0.23, Icarus 11 and Verilator 5.006.
std::string print_module(const Design& design, const Module& module);

// For proofs: one wire per node, nothing inlined.
std::string print_plain(const Design& design, const Module& module);

// What rtl/<top>.f holds: the files of the design, children first, relative to the root.
std::string print_file_list(const Design& design);

}  // namespace hlsgen
