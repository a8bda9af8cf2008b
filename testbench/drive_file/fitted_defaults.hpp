// Defaults that a motor of this size cannot use, fitted to it where the file is silent; each is named under `assumed`.
//
//     inverter.bus_resistance_ohm   where the limit's current would take more than a fifth of the bus through it: a tenth
//     control.pwm_hz                more than its default where a step at the set speed is shorter than 0.7 periods: 50 kHz at most
//     control.blanking_s,           where blanking and the samples of a crossing take more than a tenth of such a step: that tenth, but
//     control.sample_every_s        no less than dead time and delay, and 0.2 us between two samples
//     control.limit_blanking_s      likewise, but no less than 1 us: the off-time after a cut grows with it
//
// The dead time is the bridge's, whatever the motor: it is never shortened.  docs/range.md tells what part of a step the comparators
// may take.
//
// Doc: docs/design.md   Test: tests/testbench/fitted_defaults_test.cpp
#pragma once

#include "testbench/drive_file/sheet_terms.hpp"

namespace steplock {

// Of a six-step drive.  `lines` are the keys that the file gives; those fitted are added.
void fit_defaults(design::Settings&, Lines& lines);

}  // namespace steplock
