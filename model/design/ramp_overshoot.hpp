// How far a speed can pass its target at the end of a ramp, and after a load has come: a PI control of a motor that is one
// pole.
//
//     f' = gain duty - pole f          duty = ki integral(e) + kp e,   e = reference - f
//     s^2 + (pole + kp gain) s + ki gain
//
// A reference that rises with slope 1 for ever leaves the error
//
//     e(t) = c (1 - exp(-d t) (cosh q t + (d - 1/c) sinh(q t) / q)),   c = pole / w^2,  w^2 = ki gain,
//                                                                      d = (pole + kp gain) / 2,  q^2 = d^2 - w^2
//
// and one that stops after T is this one less the same, begun T later: f passes its target by e(t - T) - e(t).  So no ramp,
// however long, passes by more than what e falls after its first maximum; one of half a period does.
//
// A load that comes when the reference and the speed were equal, and that decelerates by 1, leaves
//
//     e(t) = exp(-d t) sinh(q t) / q
//
// which an imaginary q takes below zero: what the integral gathered in the dip makes the speed pass its target.
//
// Doc: docs/design.md   Test: tests/model/design/ramp_overshoot_test.cpp
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace steplock::design {

struct SpeedLoop {
  double gain = 0;  // speed per s and duty
  double pole = 0;  // 1/s
  double kp = 0;    // duty per speed
  double ki = 0;    // duty per speed and s
};

// The error after a ramp of slope 1 began, in s; or after a load that decelerates by 1 has come.
//
// Looked at in places of the same distance, one from the last by the addition theorems: real numbers alone, since q^2 is one.
class RampError {
 public:
  static constexpr int kPlaces = 200;  // until it has settled, that are looked at

  // exp(-d t) cosh q t and exp(-d t) sinh(q t) / q, the latter in s.
  struct Modes {
    double cosh, sinh;
  };

  explicit RampError(const SpeedLoop& loop)
      : w2_(loop.ki * loop.gain), d_((loop.pole + loop.kp * loop.gain) / 2), c_(loop.pole / w2_), q2_(d_ * d_ - w2_) {}

  Modes after(double t) const {
    const double q = std::sqrt(std::abs(q2_)), decay = std::exp(-d_ * t);
    const double near = decay * t * (1 + q2_ * t * t / 6);  // of sinh and sin alike
    constexpr double kNear = 3e-4;                          // whose next term is below the last bit
    if (q2_ < 0) return {decay * std::cos(q * t), q * t < kNear ? near : decay * std::sin(q * t) / q};
    // Both halves of the hyperbolic functions with their decay, so that neither grows beyond bounds.
    const double up = std::exp((q - d_) * t), down = std::exp((-q - d_) * t);
    return {(up + down) / 2, q * t < kNear ? near : (up - down) / (2 * q)};
  }
  Modes sum(const Modes& a, const Modes& b) const {
    return {a.cosh * b.cosh + q2_ * a.sinh * b.sinh, a.sinh * b.cosh + a.cosh * b.sinh};
  }
  double operator()(const Modes& at) const { return c_ - (c_ * at.cosh + (c_ * d_ - 1) * at.sinh); }
  static double of_load(const Modes& at) { return at.sinh; }

  // visit(Modes) at each place.
  template <class Visit>
  void at_places(Visit&& visit) const {
    const Modes step = after(settled() / kPlaces);
    Modes at = step;
    for (int k = 0; k < kPlaces; ++k, at = sum(at, step)) visit(at);
  }

 private:
  // Behind this nothing higher follows: a period, or what the slower of two poles needs to settle.
  double settled() const {
    return q2_ < 0 ? std::min(2 * std::numbers::pi / std::sqrt(-q2_), 8 / d_) : 8 * (d_ + std::sqrt(q2_)) / w2_;
  }

  double w2_, d_, c_, q2_;
};

// s: times the slope it is the speed by which the target is passed at the end of a ramp that takes `rise` (s).
inline double ramp_overshoot(const SpeedLoop& loop, double rise) {
  const RampError error(loop);
  const RampError::Modes rises = error.after(rise);
  double most = 0;
  error.at_places([&](const RampError::Modes& t) { most = std::max(most, error(t) - error(error.sum(rises, t))); });
  return most;
}

// The same of the worst ramp.
inline double ramp_overshoot(const SpeedLoop& loop) {
  const RampError error(loop);
  double highest = 0, most = 0;
  error.at_places([&](const RampError::Modes& t) {
    const double e = error(t);
    highest = std::max(highest, e);
    most = std::max(most, highest - e);
  });
  return most;
}

// One that a ramp is made for: its loop, and what the current's limit lets it accelerate by.
struct RampedLoop {
  SpeedLoop loop;
  double limit = 0;  // speed per s
};

// The steepest ramp up to `most` at whose end none of them passes the target, `rise` above the begin, by more than `passes`.
// One that cannot follow it, at the current's limit, is not asked.  Looked for from above: what a steeper ramp passes by
// may be less, where it ends when the error falls.
inline double steepest_ramp(std::span<const RampedLoop> loops, double rise, double passes, double most) {
  constexpr double kFiner = 0.97;
  const auto too_steep = [&](double slew) {
    return std::ranges::any_of(loops, [&](const RampedLoop& l) {
      return slew < l.limit && slew * ramp_overshoot(l.loop, rise / slew) > passes;
    });
  };
  // No rotor passes by more at this one, whatever the ramp's length.
  double least = most;
  for (const auto& l : loops) least = std::min(least, passes / ramp_overshoot(l.loop));
  double slew = most;
  while (slew > least && too_steep(slew)) slew *= kFiner;
  return std::max(slew, least);
}

// s: times the deceleration by a load it is the speed by which the target is passed after the dip.
inline double load_rebound(const SpeedLoop& loop) {
  double most = 0;
  RampError(loop).at_places([&](const RampError::Modes& t) { most = std::max(most, -RampError::of_load(t)); });
  return most;
}

}  // namespace steplock::design
