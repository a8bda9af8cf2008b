// Runs a sweep, or one shard of it, into a folder:
//
//     setup.json   what the sweep is                 runs.csv   a line per run, as it ends
//     sweep.json   the statistics                    sweep.html with plots
//
// Lines are appended whole and flushed; whatever stops the program, the lines stay, and resuming does
// only what is missing.  At the end they are put in the order of their index: the folder is the same
// whether the sweep was done at once, in parts, or by others (merge).
//
// Doc: docs/sweep.md   Test: tests/testbench/sweep_test.cpp
#pragma once

#include <filesystem>
#include <functional>

#include "testbench/sweep/row.hpp"
#include "testbench/sweep/setup.hpp"

namespace steplock {

struct SweepOptions {
  Shard shard = {};
  int jobs = 1;
  bool resume = false;
  // Runs done of those to do, now and then; false stops the sweep.
  std::function<bool(std::uint64_t done, std::uint64_t all)> progress = {};
};

struct SweepEnd {
  std::vector<Row> rows;     // all in the folder, in the order of their index
  std::uint64_t done = 0;    // by this call
  bool interrupted = false;
};

SweepEnd sweep(const SweepSetup&, const std::vector<DriveFile>&, const SweepOptions&,
               const std::filesystem::path& folder);

// What the folders hold, together, into another folder; their drives need not be here.
SweepEnd merge_sweeps(const std::vector<std::filesystem::path>& parts,
                      const std::filesystem::path& folder, SweepSetup& setup);

// One run, as the sweep makes it: simulated, and repeated beside the RTL if its seed says so.
// Nothing if go_on() became false.
std::optional<Row> make_row(std::uint64_t index, const std::string& drive, const design::Settings&,
                            RunSeed, const std::function<bool()>& go_on = {});

}  // namespace steplock
