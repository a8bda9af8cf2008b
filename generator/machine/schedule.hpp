// A sample as a program on one datapath: the flat netlist of a tick in, an ordinary module and its
// memories out.
//
//     expand_shifts -> lower -> fuse -> legalise -> order -> build
//
// Test: tests/generator/machine_test.cpp

#pragma once

#include <string>
#include <vector>

#include "generator/machine/budget.hpp"
#include "generator/netlist.hpp"

namespace hlsgen {

// What stands around the sample: ports that it does not have, and what its outputs show at first.
struct Frame {
  Leaf start, done, busy, missed;
  std::vector<llvm::APInt> output_resets;
  std::vector<bool> early = {};  // per output; none: none is
};

// What a schedule came to.
struct ScheduleReport {
  std::string module;
  SourceLine source;        // of the block
  Budget budget;
  unsigned operations = 0;  // that compute: no wiring
  unsigned products = 0;
  unsigned entries = 0;     // read from large tables
  unsigned clocks = 0;      // from start to done
  unsigned early = 0;       // from start to the early outputs
  unsigned bound = 0;       // no order takes fewer
  unsigned registers = 0;   // bits, all of them
  unsigned instructions = 0;
  unsigned word = 0;        // bits of the program's numbers
  unsigned sum = 0;         // bits of its adder
  unsigned cells = 0;       // of the memory

  std::vector<std::string> lines() const;
};

struct Scheduled {
  std::vector<Module> memories;  // that the module is made of
  Module module;
  ScheduleReport report;
};

Scheduled schedule(Module sample, const Budget& budget, const Frame& frame);

}  // namespace hlsgen
