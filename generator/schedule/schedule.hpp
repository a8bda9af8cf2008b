// A sample's worth of logic, spread over clocks: the flat netlist of a tick in, an ordinary module
// out.
//
//     optimise -> split_products -> order -> keep -> bind -> build
//
// Test: tests/generator/schedule_test.cpp

#pragma once

#include "generator/schedule/build.hpp"

#include <string>

namespace hlsgen {

// What a schedule came to.
struct ScheduleReport {
  std::string module;
  SourceLine source;        // of the block
  Budget budget;
  unsigned operations = 0;  // that compute: no wiring
  unsigned products = 0;
  unsigned entries = 0;     // read from large tables
  unsigned clocks = 0;      // from start to done
  unsigned early = 0;       // from start to the early outputs of a program
  unsigned bound = 0;       // no order takes fewer
  unsigned registers = 0;   // bits, all of them
  unsigned kept = 0;        // bits of these that keep values between steps
  unsigned instructions = 0;  // of a program
  unsigned word = 0;          // bits of its numbers
  unsigned sum = 0;           // bits of its adder
  unsigned cells = 0;         // of the memory
  unsigned levels = 0;      // look-up tables in a row at most, estimated

  std::vector<std::string> lines() const;
};

struct Scheduled {
  std::vector<Module> memories;  // that the module is made of
  Module module;
  ScheduleReport report;
};

// Nodes that compute: no wiring.
unsigned count_operations(const Module& module);

Scheduled schedule(Module sample, const Budget& budget, const scheduling::Frame& frame);

}  // namespace hlsgen
