// A drawn start of a sinusoidal drive: the counterpart of what drawn_run.cpp does with a six-step one,
// behind the same drawn_run() and simulate().
//
// Doc: docs/sweep.md   Test: tests/testbench/sinusoidal_sweep_test.cpp
#pragma once

#include "testbench/sweep/drawn_run.hpp"

namespace steplock::sinusoidal {

// Twice the longest way to a latched fault or to set speed that the words allow.
double longest_start(const design::Settings&);

DrawnResult simulate_start(const DrawnRun&, const SimulateOptions&);

}  // namespace steplock::sinusoidal
