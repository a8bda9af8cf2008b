// The reference's phase detector, loop filter and speed control beside the blocks' laws, update by update, on what a run gave
// the blocks (law_inputs.hpp): so near that a coefficient which is one percent off shows.
//
// Both get the same inputs and the same coefficients, those that the words stand for.  So all that is between them is what a
// word drops of a product, and that adds up as these equations say (q: a last place of the law's values):
//
//     loop       p  = e' f            is off by   ep = q + |e'| 2^-28 + f (2^-22 + delay ey) + |e'| ey
//                x += ki p                        ex += q + ki ep
//                v  = x + kp p                    ev = ex + q + kp ep
//                y += pole (v - y)                ey = (1 - pole) ey + pole ev + 2 q
//     speed      reference, by the slew           er += one place in each tick downwards
//                integral += ki e                 ei += 2^-31 + ki (er + one place)
//                duty = integral + kp e           ed = 2 2^-15 + ei + kp (er + one place)
//                duty, held by slew or limit      ed = max(that of above, the one before + 2^-15)
//                duty, at rest at a bound         ed = max(that of above, the one before - slew)
//     detector   error = expected - crossing      0; without a crossing, of a rotor that lags, 2^-16
//
// In its first tick of control the law may hold the integral still, for a bound that the duty met before: ei += ki |e|.
// And so where the duty met a bound in one of the two alone, by no more than their error.
// After kWindow updates the reference begins anew from the law's state, and what adds up with it; and where one of the two has
// found the rotor at a lower set speed a tick before the other, by no more than their error.
//
// Per second (LoopForm) the reference solves the circuit exactly, and the law moves its integral at the tick's beginning: the output
// is apart from the circuit's by d = r d + move (r + (1 - r) / ln r) besides, r = 1 - pole, which is taken off; at a limit ex += move,
// ey += |d| + move.
//
// Doc: docs/report.md   Test: tests/testbench/law_errors_test.cpp
#pragma once

#include <string>
#include <vector>

#include "model/design/parameters.hpp"
#include "testbench/compare/law_inputs.hpp"

namespace steplock {

struct LawError {
  std::string signal, unit;
  std::size_t updates = 0;
  std::size_t disturbed = 0;  // in which an input changed while the block was at work, which the law takes for whole
  std::size_t unlike = 0;     // not disturbed, nor any before in their span, and the law did not do what the block did
  double worst = 0, bound = 0, at_s = 0;  // at the update whose error is the greatest part of its bound
  double of_bound() const { return worst == 0 ? 0 : bound == 0 ? 1e9 : worst / bound; }
  bool within() const { return of_bound() <= 1; }
};

// Detector, loop filter, speed control.  `reference`: its parameters.
std::vector<LawError> law_errors(const LawInputs&, const design::Parameters& reference, double clock_hz);

}  // namespace steplock
