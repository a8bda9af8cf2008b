// Current control and modulator of the sinusoidal drive in doubles, on what the blocks were given: the law of
// hls/sinusoidal/current_control.hpp and space_vector.hpp, sample by sample, with integrals of its own.
//
// What word lengths put into an on-time, in clocks: P clocks are a place of a voltage, dc volts in places of it into the period.
//
//     lasts     each axis: half a place cut off k_p e and half off x, and of x a half of 2^-12 a sample since it began; the rounded
//               words of k_p, k_i, w L and w K_E, times what they stand before; the rounded 1 / v_dc, 2^-12 of it; a sixteenth of
//               a clock cut three times, the dead time's word included
//     scatters  k_p e and x by what was cut; decoupling by three roundings; sine and cosine two places of the vector's length, and the
//               angle on which they are by a place and a half of 2^-16 turn; alpha and beta a rounding, the legs four; half a clock
//
// Left out is a leg whose wanted current is so near zero that a rounding gives it the other sign, which is twice the dead time; and
// one that is within its bound of the shortest pulse, which may be one or none.
//
// Doc: docs/report.md   Test: tests/testbench/sinusoidal_compare_test.cpp
#pragma once

#include "hls/sinusoidal/sinusoidal_top.hpp"
#include "model/design/design.hpp"
#include "model/design/sinusoidal/parameters.hpp"
#include "testbench/compare/differences.hpp"
#include "testbench/compare/rounding.hpp"

namespace steplock::sinusoidal {

class ControlShadow {
 public:
  ControlShadow(const design::Settings&, const design::sinusoidal::Parameters&);

  // Without regulation: integrals begin at 0.
  void rest() { x_gamma_ = x_delta_ = 0, samples_ = 0; }
  // A sample that is worked through; `before` is what the drive showed of the one before, whose speed and current regulate this one.
  void take(const SinusoidalTop::Out& out, const SinusoidalTop::Out& before);

  // Of the last sample: legs fixed less float, clocks, those in doubt left out.
  const std::vector<double>& clocks() const { return clocks_; }
  // The greatest of what lasts, and of the standard deviation, in the samples of which it was asked.
  Rounding error() const { return error_; }

 private:
  double axis(double& x, double error, double known, double limit) const;

  design::sinusoidal::Parameters p_;
  double current_, voltage_, speed_;                 // full scales: A and V of a phase's peak, electrical rad/s
  double period_, minimum_, lost_;                   // clocks
  double k_p_, k_i_, inductance_, emf_;              // relative errors of the words
  double x_gamma_ = 0, x_delta_ = 0;                 // V
  std::size_t samples_ = 0;
  std::vector<double> clocks_;
  Rounding error_;
};

}  // namespace steplock::sinusoidal
