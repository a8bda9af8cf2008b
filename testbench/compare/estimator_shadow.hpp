// The sinusoidal blocks drive, their estimator in doubles looks over their shoulder, sample by sample.
//
// Both see the same ADC codes and the pattern that the blocks put on the bridge, from the first sample of the start
// on.  From the set speed to the end of the load the estimated angle and the step to the next sample are compared, beside
// what word lengths allow, a bias and six standard deviations:
//
//     Delta i   scatters by gain times what legs and voltage are rounded by (a sixteenth of a clock; the current whose sign
//               tells the lost time, by a quarter of a place; two places), and by six roundings to 2^-16;
//               lasts: the rounded words of gain, decay and of the volts in a clock
//     step      Delta i times what the estimator makes of it, k_theta + k_speed / gain or k_theta + k_emf; lasts: the rounded
//               word of the EMF's speed, times the speed
//     current   of both axes, in the frame at the blocks' own angle: Clarke is cut (half a place lasts), sine and cosine are within two
//               places (that many of the current's length last), two roundings scatter
//     angle     the loop takes a = 2 (2 pi f) of an angle's error away per sample: what lasts ends at step / a, what scatters
//               at step / sqrt(2 a), f at its slowest; and the half place of 16 bits that sine and cosine do not see
//
// Doc: docs/report.md   Test: tests/testbench/sinusoidal_compare_test.cpp
#pragma once

#include <functional>
#include <optional>

#include "model/design/sinusoidal/parameters.hpp"
#include "testbench/drive/sinusoidal/run.hpp"

namespace steplock::sinusoidal {

// `blocks`: what a run of this drive came to, with the rtl or the fixed engine; it tells where the span is, and that part is
// run again.  `reference`: parameters of the estimator in doubles if not the design's, and `sense` the gain of its ADC of phase u,
// negative controls.
FloatErrors shadow_errors(const design::Settings&, const Result& blocks,
                          const std::function<bool(double done)>& progress = {},
                          const std::optional<design::sinusoidal::Parameters>& reference = {}, double sense = 1);

}  // namespace steplock::sinusoidal
