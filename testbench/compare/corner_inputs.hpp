// Inputs that a run seldom gives: crossings that freewheeling hides, a loop driven to either end of its frequencies, a speed
// control to either end of its duty.  What answers is the block (detector) or its law, which it equals bit for bit.
//
// Doc: docs/report.md   Test: tests/testbench/law_errors_test.cpp
#pragma once

#include "testbench/compare/law_inputs.hpp"

namespace steplock {

LawInputs corner_inputs(const SixStepConfig&, double clock_hz);

}  // namespace steplock
