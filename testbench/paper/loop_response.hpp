// The phase-locked loop's open-loop response, measured: the rotor's phase is modulated by a handful
// of small tones at once, and the phase at which the drive commutates is searched for them.
//
//     T(j omega) = (phase of the commutations) / (phase of the rotor)        closed loop
//     H(j omega) = T / (1 - T)                                               open loop, Eqs. (2)-(4)
//
// Test: tests/testbench/loop_response_test.cpp
#pragma once

#include <complex>
#include <functional>
#include <vector>

#include "testbench/drive/six_step/run.hpp"

namespace steplock {

struct LoopPoint {
  double omega = 0;  // rad/s
  std::complex<double> closed, open;
  double gain_db() const { return 20 * std::log10(std::abs(open)); }
  double phase_deg() const;  // from -360 to 0
};

struct LoopExperiment {
  double rpm = 0;               // mechanical, of the rotor
  double tone_deg = 0.5;        // electrical, of each tone
  double lowest = 8, highest = 450;  // rad/s
  int tones = 12;
  double settle_s = 2, measure_s = 8;
  EngineKind engine = EngineKind::kRtl;
};

// Throws std::runtime_error if the drive does not hold the lock.
std::vector<LoopPoint> measure_loop(const design::Settings&, const LoopExperiment&);

struct Crossover {
  double omega = 0, margin_deg = 0;  // rad/s; phase margin
};
// Between the two measured points around 0 dB, on straight lines over log frequency.
Crossover crossover(const std::vector<LoopPoint>&);

// Which tones fit the phases of these commutations (turns against seconds), beside a steady turning.
std::vector<std::complex<double>> tones_in(const std::vector<double>& times,
                                           const std::vector<double>& turns,
                                           const std::vector<double>& omegas);

}  // namespace steplock
