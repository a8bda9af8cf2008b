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
#include <string>

#include "testbench/drive_file/drive_file.hpp"

namespace steplock {

enum ExitCode { kWell = 0, kFailed = 1, kBadInput = 2, kBroken = 3, kInterrupted = 130 };

void add_run_command(CLI::App&, int& exit_code);
void add_sweep_command(CLI::App&, int& exit_code);
void add_merge_command(CLI::App&, int& exit_code);
void add_compare_command(CLI::App&, int& exit_code);
void add_design_command(CLI::App&, int& exit_code);
void add_paper_command(CLI::App&, int& exit_code);
void add_range_command(CLI::App&, int& exit_code);
void add_envelope_command(CLI::App&, int& exit_code);
void add_plant_command(CLI::App&, int& exit_code);
void add_keys_command(CLI::App&, int& exit_code);

}  // namespace steplock
