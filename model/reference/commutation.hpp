// Which gate should conduct, and the guard that lets it: dead time, shoot-through, minimum pulse.
//
//     step      0    1    2    3    4    5      align   pre-align   brake
//     high      U    U    V    V    W    W      U V     U           -
//     low       V    W    W    U    U    V      W       W           U V W (while chop is on)
//     floats    W    V    U    W    V    U
//
// Doc: docs/theory.md   Test: tests/model/reference/reference_commutation_test.cpp
#pragma once

#include <algorithm>

#include "model/reference/pwm.hpp"
#include "model/reference/signals.hpp"

namespace steplock::reference {

enum class Mode { kOff, kDrive, kPreAlign, kAlign, kBrake };

inline constexpr std::array<int, 6> kHigh = {0, 0, 1, 1, 2, 2}, kLow = {1, 2, 2, 0, 0, 1},
                                    kFloating = {2, 1, 0, 2, 1, 0};

constexpr Gates gates_wanted(Mode mode, int step, bool chop, bool complementary) {
  Gates g = {};
  const auto source = [&](int phase) {
    g[2 * phase] = chop;
    g[2 * phase + 1] = complementary && !chop;
  };
  const auto sink = [&](int phase) { g[2 * phase + 1] = true; };
  switch (mode) {
    case Mode::kOff:
      break;
    case Mode::kDrive:
      source(kHigh[step]), sink(kLow[step]);
      break;
    case Mode::kPreAlign:
      source(kHigh[1]), sink(kLow[1]);
      break;
    case Mode::kAlign:
      source(0), source(1), sink(2);
      break;
    case Mode::kBrake:
      g = {false, chop, false, chop, false, chop};
      break;
  }
  return g;
}

class GateGuard {
 public:
  explicit GateGuard(const design::PwmParameters& p) : dead_(p.dead_time), minimum_(p.minimum) {}

  void update(double t, const Gates& wanted, bool enable) {
    next_ = kNever;
    for (int gate = 0; gate < 6; ++gate) {
      const int other = gate ^ 1;
      const bool want = enable && wanted[gate] && !wanted[other];
      if (!want) asked_[gate] = kNever;
      if (want && asked_[gate] == kNever) asked_[gate] = t;
      if (on_[gate] && !want) {
        if (enable && t < since_[gate] + minimum_)
          next_ = std::min(next_, since_[gate] + minimum_);
        else
          on_[gate] = false, since_[gate] = t;
      }
    }
    for (int gate = 0; gate < 6; ++gate) {
      const int other = gate ^ 1;
      if (on_[gate] || on_[other] || !enable || !wanted[gate] || wanted[other]) continue;
      // since_ of a gate that is off is when it went off.  Every request waits, also after a long pause.
      const double free = std::max({since_[gate], since_[other], asked_[gate]}) + dead_;
      if (t < free)
        next_ = std::min(next_, free);
      else
        on_[gate] = true, since_[gate] = t;
    }
  }
  double next() const { return next_; }
  const Gates& gates() const { return on_; }

 private:
  double dead_, minimum_, next_ = kNever;
  Gates on_ = {};
  std::array<double, 6> since_ = {};
  std::array<double, 6> asked_ = {kNever, kNever, kNever, kNever, kNever, kNever};
};

}  // namespace steplock::reference
