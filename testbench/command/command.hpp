// The sub-commands of `steplock`.  Each adds itself to the command line and, when chosen, sets the
// exit code.
//
//     0 done, and all is well          1 done, but the run failed or a comparison differs
//     2 bad input or bad usage         3 something else went wrong (disk full, gnuplot missing)
//     130 stopped by Ctrl-C; what was simulated is on disk
//
// Doc: docs/steplock.md   Test: tests/testbench/command_test.cpp
#pragma once

#include <CLI/CLI.hpp>
#include <map>
#include <string>
#include <vector>

#include "testbench/drive_file/drive_file.hpp"
#include "testbench/run/run_options.hpp"

namespace steplock {

enum ExitCode { kWell = 0, kFailed = 1, kBadInput = 2, kBroken = 3, kInterrupted = 130 };

// --engine takes one of these by its name.
inline CLI::Validator engine_among(const std::vector<EngineKind>& kinds) {
  std::map<std::string, EngineKind> names;
  std::string shown;
  for (const EngineKind kind : kinds) {
    names[name_of(kind)] = kind;
    shown += (shown.empty() ? "" : "|") + std::string(name_of(kind));
  }
  CLI::Validator validator = CLI::CheckedTransformer(names, CLI::ignore_case);
  return validator.description(shown);
}

void add_run_command(CLI::App&, int& exit_code);
void add_sweep_command(CLI::App&, int& exit_code);
void add_merge_command(CLI::App&, int& exit_code);
void add_compare_command(CLI::App&, int& exit_code);
void add_coefficients_command(CLI::App&, int& exit_code);
void add_design_command(CLI::App&, int& exit_code);
void add_paper_command(CLI::App&, int& exit_code);
void add_range_command(CLI::App&, int& exit_code);
void add_envelope_command(CLI::App&, int& exit_code);
void add_gallery_command(CLI::App&, int& exit_code);
void add_hold_command(CLI::App&, int& exit_code);
void add_plant_command(CLI::App&, int& exit_code);
void add_keys_command(CLI::App&, int& exit_code);
void add_new_command(CLI::App&, int& exit_code);
void add_motors_command(CLI::App&, int& exit_code);
void add_registers_command(CLI::App&, int& exit_code);
void add_report_command(CLI::App&, int& exit_code);

}  // namespace steplock
