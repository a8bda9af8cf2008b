// Back-EMF comparator logic: finds the zero crossing of the floating phase within a step.
//
//     after   = comparator of the floating phase, inverted when the crossing falls
//     valid   = `blanking` past the last chop edge and commutation, in a chop state to be sampled
//     filter  = up/down counter 0 .. samples, starts at `samples`, so that a clamp that looks like
//               "after" (freewheeling of the phase switched off) must end first: before_seen
//     place   = middle between the last sample "before" at counter 0 and the first one "after":
//               the filter's delay and any gap of blanking leave no bias
//
// Doc: docs/theory.md   Test: tests/model/reference/reference_bemf_test.cpp
#pragma once

#include "model/reference/commutation.hpp"

namespace steplock::reference {

constexpr bool crossing_rises(int step, bool reverse) { return (step % 2 == 1) != reverse; }

class Bemf {
 public:
  explicit Bemf(const design::BemfParameters& p) : p_(p) {}

  // `active`: the drive is being commutated; else nothing is sampled.  `phase`: turns of the step.
  void update(double t, const Pins& pins, Bridge bridge, double phase, bool reverse, bool active) {
    crossing_ = false;
    const bool commutated = bridge.step != bridge_.step;
    if (commutated) {
      ended_seen_ = before_seen_;
      if (on_ && !before_seen_) freewheel_ = 1;
    }
    if (commutated || !active) {
      counter_ = p_.samples;
      before_seen_ = done_ = false;
    }
    if (!active) freewheel_ = 0;
    on_ = active;
    if (commutated || bridge.chop != bridge_.chop || !active) valid_from_ = t + p_.blanking;
    bridge_ = bridge;
    active_ = active && !done_ &&
              (p_.sampling == design::Sampling::kBoth ||
               bridge.chop == (p_.sampling == design::Sampling::kOnTime));
    if (t >= next()) take(t, pins, phase, reverse);
  }
  double next() const {
    return active_ ? std::max(valid_from_, sampled_ + p_.sample_every) : kNever;
  }

  bool crossing() const { return crossing_; }       // found in this update
  double crossing_phase() const { return place_; }  // turns of the step
  // The level from before the crossing showed in the bridge's present step, or, if `step` is another one, in the one before.
  // (Beside a drive whose bridge this is, its commutations and the reference's are not at one instant.)
  bool before_seen(int step) const { return bridge_.step == step ? before_seen_ : ended_seen_; }
  double freewheel() const { return freewheel_; }  // turns of a step, where it last ended; 1: in the step that ended it did not

 private:
  void take(double t, const Pins& pins, double phase, bool reverse) {
    sampled_ = t;
    const bool level = pins.comparator[kFloating[bridge_.step]];
    const bool after = level == crossing_rises(bridge_.step, reverse);
    if (after) {
      if (counter_ == 0) first_after_ = phase;
      if (counter_ < p_.samples) ++counter_;
      if (counter_ == p_.samples && before_seen_) {
        crossing_ = done_ = true;
        active_ = false;
        place_ = (last_before_ + first_after_) / 2;
      }
      return;
    }
    if (counter_ > 0) --counter_;
    if (counter_ > 0) return;
    last_before_ = phase;
    if (!before_seen_) freewheel_ = phase;
    before_seen_ = true;
  }

  design::BemfParameters p_;
  double valid_from_ = 0, sampled_ = -kNever;
  double last_before_ = 0, first_after_ = 0, place_ = 0, freewheel_ = 0;
  int counter_ = 0;
  Bridge bridge_ = {.step = -1};  // so that the first step begins like any other
  bool on_ = false;  // the drive is being commutated
  bool active_ = false, before_seen_ = false, ended_seen_ = false, done_ = false, crossing_ = false;
};

}  // namespace steplock::reference
