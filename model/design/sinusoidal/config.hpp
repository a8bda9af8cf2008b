// The register words of the fixed-point sinusoidal drive, from what its blocks are set to in SI
// units.
//
// A word is found by its name, which is that of hls/sinusoidal/config.hpp: "speed.k_p".  Each is the nearest one; WordRow
// keeps what was wanted and what the word means.  Those of pilot pulses are there where a start has some.
//
//     full scales   current  range I of the ADC, of a phase's peak: sqrt(3/2) I of a vector
//                   voltage  range U of the ADC, likewise
//                   speed    W = 2 pi / (16 T) electrical rad/s: 1/16 turn per sample
//     times         PWM periods
//
// Doc: docs/sinusoidal.md   Test: tests/model/design/sinusoidal_config_test.cpp
#pragma once

#include "model/design/sinusoidal/design.hpp"
#include "model/design/config.hpp"

namespace steplock::design::sinusoidal {

struct Quantised {
  Config config;
  std::vector<WordRow> rows;
  // What the blocks cannot do, and words that do not fit: "speed.k_p needs 81234; at most 32767".
  std::vector<std::string> problems;
};

Quantised quantise(const Settings&);

// The target's word for another set speed.
Word target_word(const Settings&, double rpm);

// Clocks of dead time that the gate guard never undercuts.
inline constexpr int kDeadTimeFloor = 12;

// Clocks of a sample, in which the arithmetic takes nothing new: the least of a PWM period.
inline constexpr int kSampleClocks = 477;

}  // namespace steplock::design::sinusoidal
