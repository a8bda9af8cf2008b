// Speed regulator of the sinusoidal drive in doubles, on the steps of the angle that the blocks made: the law of
// hls/sinusoidal/speed_regulator.hpp, sample by sample.  The smoothed speed is its own from the first sample on; its integral begins
// where the reference has come to the set speed, as what the blocks ask for then leaves over.
//
// What word lengths put into the wanted current, in places of it:
//
//     lasts     half a place cut off k_p e and half off the integral, and as much again where it began; the rounded words of k_p and
//               k_i, times what they stand before; that of the filter, times how far a step is from the smoothed speed, times k_p
//     scatters  both cuts; k_p times a rounding of the error to 2^-19
//
// and into the speed: half a place that is cut off what is shown, the filter's word, 2^-27 over the filter.
//
// Doc: docs/report.md   Test: tests/testbench/sinusoidal_compare_test.cpp
#pragma once

#include "hls/sinusoidal/sinusoidal_top.hpp"
#include "model/design/design.hpp"
#include "model/design/sinusoidal/parameters.hpp"
#include "testbench/compare/differences.hpp"
#include "testbench/compare/rounding.hpp"

namespace steplock::sinusoidal {

class SpeedShadow {
 public:
  SpeedShadow(const design::Settings&, const design::sinusoidal::Parameters&);

  // Without regulation.
  void rest() { speed_ = arrived_s_ = 0, begun_ = false; }
  // `shown`: a sample whose step, in turns, the next one's angle has told; `span`: it is to be compared; `way`: 1 or -1.
  void take(const SinusoidalTop::Out& shown, double step, int way, bool span);

  const Differences& speed() const { return speeds_; }      // r/min
  const Differences& current() const { return currents_; }  // A of a phase's peak
  Rounding speed_error() const;
  Rounding current_error() const;

 private:
  design::sinusoidal::SpeedRegulator p_;
  double period_, filter_, target_, rpm_;  // rpm_: of an electrical rad/s
  double place_speed_, place_current_;     // of s0.15
  double k_p_, k_i_, filter_error_;        // relative errors of the words
  double speed_ = 0, integral_ = 0;        // rad/s and A in the wanted direction
  double arrived_s_ = 0;
  bool begun_ = false;
  double behind_ = 0, by_k_p_ = 0, by_k_i_ = 0;  // the greatest: rad/s, A, A
  Differences speeds_, currents_;
};

}  // namespace steplock::sinusoidal
