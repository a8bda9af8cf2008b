// How a drawn run of either kind is simulated: its timeline, and on until its outcome is clear.
//
// Test: tests/testbench/sweep_test.cpp
#pragma once

#include <algorithm>

#include "testbench/sweep/drawn_run.hpp"

namespace steplock {

// `run` rises, and nothing else, until the limit.
Timeline start_timeline(const design::Settings&, double limit_s);
WitnessSettings witness_settings(const DrawnRun&);

// Whole tenths of a millisecond at a time, so that a run ends at the same clock whoever watches it.
template <class Simulation, class Decided>
void run_until(Simulation& simulation, std::uint64_t end, double clock_hz, DrawnResult& result,
               const SimulateOptions& options, const Decided& decided) {
  const auto chunk = static_cast<std::uint64_t>(1e-4 * clock_hz);
  while (simulation.clock() < end && !decided() && !result.stopped) {
    simulation.run_until(std::min(end, simulation.clock() + chunk));
    result.stopped = options.go_on && !options.go_on();
  }
}

}  // namespace steplock
