// One run of a sinusoidal drive that meets a disturbance: drawn and judged as those of the six-step drives (sweep/disturbance.hpp), of the
// kinds that have no comparator in them.
//
// Doc: docs/sweep.md   Test: tests/testbench/sinusoidal_disturbance_test.cpp
#pragma once

#include "testbench/sweep/drawn_run.hpp"
#include "testbench/sweep/row.hpp"

namespace steplock::sinusoidal {

// Its load, bus, set speed, inertia and windings are disturbed; comparators, and the freewheeling that hides a crossing, are six-step's.
bool meets(Trouble);
// Of the seeds that run `index` of a sweep might have, the first whose disturbance it meets.
RunSeed disturbed_seed(const design::Settings& file, const SweepKind&, std::uint64_t index);

// The reason of the latched fault, or of the last failed attempt after the disturbance, stands in the row's findings.sinusoidal_reason.
DrawnResult simulate_disturbed(const DrawnRun&, const SimulateOptions& = {});
// Nothing if go_on() became false.
std::optional<Row> disturbed_row(std::uint64_t index, const std::string& drive, const design::Settings& file, RunSeed,
                                 const std::function<bool()>& go_on = {});

}  // namespace steplock::sinusoidal
