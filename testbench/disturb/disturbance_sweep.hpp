// Many disturbed runs of sinusoidal drives, as sweep() does those of the six-step drives: in processes, resumed where they were stopped,
// each the same whatever the machine and the order.  runs.csv has one column more, `drive_reason`: that of the fault, or of the last failed
// attempt, in the sinusoidal drive's terms.
//
// Doc: docs/sweep.md   Test: tests/testbench/sinusoidal_disturbance_test.cpp
#pragma once

#include <filesystem>

#include "testbench/sweep/sweep.hpp"

namespace steplock::sinusoidal {

// Throws BadInput for a shard, or a folder that holds other runs.
SweepEnd sweep_disturbances(const SweepSetup&, const std::vector<DriveFile>&, const SweepOptions&, const std::filesystem::path& folder);

std::string disturbed_line(const Row&);  // of runs.csv, without the newline
// Throws BadInput, `file:line: what; how to mend`.
Row disturbed_row_of(const std::string& text, const std::string& path, int line);

}  // namespace steplock::sinusoidal
