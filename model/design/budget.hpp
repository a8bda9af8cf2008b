// Error budget: what sampling and rounding put in, and how far apart two drives of one design may
// then be: quantisation variance in, bound out.  `steplock compare` and the tests take their limits
// from it.  All at the set speed, in lock.
//
//     var(place)  = sum of width^2 / 12 over what blurs a crossing's place: sample interval,
//                   blind gap at each PWM edge, comparator noise, synchroniser, the 16-bit phase
//     var(phase)  = var(place) * mean |H / (1 + H)|^2     the VCO's phase, hence each commutation
//     var(error)  = var(place) * mean |1 / (1 + H)|^2     what the phase detector shows
//     var(freq)   = var(place) * mean |(z - 1) H / (1 + H)|^2, per crossing interval
//     duty        : kp * frequency, and one clock of the PWM period; drives whose duty acts on nothing
//                   also part at random, by ki * frequency per look at it (`apart`)
//     mean speed  : one step of the speed control's input (frequency >> shift)
//
// A bound is what bias leaves plus six standard deviations.
//
// Doc: docs/design.md   Test: tests/model/design/error_budget_test.cpp
#pragma once

#include <algorithm>

#include "model/design/design.hpp"
#include "model/design/config.hpp"

namespace steplock::design {

struct BudgetRow {
  std::string name, unit;
  double rms = 0, bound = 0;
  double bias = 0;  // the part of the bound that does not scatter
  double rms_allowed() const { return std::min(bound, bias + rms); }
};

struct Budget {
  std::vector<BudgetRow> in;  // each in turns of a step; bound is half its width
  BudgetRow phase_error;      // degrees electrical, at the detector
  BudgetRow commutation;      // degrees electrical, of each commutation
  BudgetRow instant;          // s, of each commutation
  BudgetRow frequency;        // rpm, mechanical, momentary
  BudgetRow mean_speed;       // rpm, mechanical, averaged
  BudgetRow duty;             // fraction
  std::vector<BudgetRow> out() const {
    return {phase_error, commutation, instant, frequency, mean_speed, duty};
  }
};

// `apart_s`: how long nothing has held the two integrals of speed control together.  That is no time for
// two drives with a motor each, and all its time for a reference that looks over a drive's shoulder.
Budget error_budget(const Settings&, const Design&, const Config&, double apart_s = 0);

// Means over all frequencies of a loop that is sampled once per `interval`.
struct NoiseGains {
  double phase = 0;      // |H / (1 + H)|^2
  double error = 0;      // |1 / (1 + H)|^2
  double frequency = 0;  // |(z - 1) H / (1 + H)|^2
};
NoiseGains noise_gains(const Response& open_loop, double interval);

}  // namespace steplock::design
