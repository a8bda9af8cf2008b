// C++ in, netlist out: clang, then one step function per block, then data flow.
//
//     compile -> find_blocks -> check_callees -> reset values
//     per block: build_step, inline_calls, mark_variables, insert_guards, unroll_loops,
//     cut_instances,
//                expand_accesses, LLVM's simplifications, prove_guards, convert, perhaps schedule
//
// Doc: docs/generator.md   Test: tests/generator/frontend/design_test.cpp

#pragma once

#include <string>

#include "generator/cpp/compile.hpp"
#include "generator/netlist.hpp"
#include "generator/machine/schedule.hpp"

namespace hlsgen {

struct FrontEndOptions {
  CompileOptions compile;
  std::string top;  // class or module name; empty when the source names only one
  bool any_clocks = false;  // of schedules, whatever the source says
};

struct FrontEndResult {
  Design design;
  std::vector<std::string> read;  // every file of the project that went into it
  std::vector<ScheduleReport> schedules;
};

// Throws Refusal.
FrontEndResult build_design(const FrontEndOptions& options);

}  // namespace hlsgen
