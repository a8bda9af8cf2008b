// A memory as a module of its own: a word read at every clock, one written, contents from the start.
//
//     always_ff @(posedge clk) begin
//       if (write_i) words[write_address_i] <= write_data_i;
//       data_o <= words[address_i];
//     end
//
// Both printers write these lines, and synthesis makes block RAM of them.  Who uses it does not read
// a word in the clock in which it is written; without that promise Yosys adds two registers for each bit.
// No reset: the contents stay.
//
// Test: tests/generator/machine_test.cpp

#pragma once

#include "generator/netlist.hpp"

namespace hlsgen {

// It is a module without nodes, whose table is what it holds from the start.
bool is_memory(const Module& module);

// Ports: address, and for one that is written write, write_address, write_data; data.
Module memory_module(const std::string& name, const Module& of, std::vector<llvm::APInt> contents,
                     bool is_written);

std::string print_memory(const Module& memory);

}  // namespace hlsgen
