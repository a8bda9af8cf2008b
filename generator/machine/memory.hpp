// A memory as a module of its own: a word read, one written, contents from the start.
//
//     always_ff @(posedge clk) begin
//       if (write_i) words[write_address_i] <= write_data_i;      if (write_i[0]) words[...][7:0] <= ...
//       data_o <= words[address_i];                               if (read_i) data_o <= ...
//     end
//
// Both printers write these lines, and synthesis makes block RAM of them.  Who uses it does not read
// a word in the clock in which it is written; without that promise Yosys adds two registers for each bit.
// No reset: the contents stay.
//
// There are two sources: the program of a schedule, and steplock::Memory (cpp/memory_class.hpp).  Only the
// latter reads on demand, and writes in lanes.
//
// Test: tests/generator/machine_test.cpp, tests/generator/frontend/memory_test.cpp

#pragma once

#include <optional>

#include "generator/netlist.hpp"

namespace hlsgen {

// It is a module without nodes, whose table is what it holds from the start.
bool is_memory(const Module& module);

// Which input is what, by its name.
struct MemoryPorts {
  unsigned address = 0;
  std::optional<unsigned> read;  // else in every clock
  std::optional<unsigned> write, write_address, write_data;  // all or none
};
MemoryPorts memory_ports(const Module& memory);

// Ports: address, and for one that is written write, write_address, write_data; data.
Module memory_module(const std::string& name, const Module& of, std::vector<llvm::APInt> contents,
                     bool is_written);

std::string print_memory(const Module& memory);

}  // namespace hlsgen
