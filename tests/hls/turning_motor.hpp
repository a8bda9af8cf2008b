// A motor that turns at a constant speed, with its current held near a set one, as both an
// estimator's block and its reference in doubles see it.  Full scales are 1 and a sample takes 1, so
// that words are physics.
#pragma once

#include <algorithm>
#include <cmath>

#include "hls/sinusoidal/observer.hpp"
#include "model/reference/sinusoidal/applied_voltage.hpp"
#include "model/reference/sinusoidal/voltage_model.hpp"

namespace steplock::turning {

namespace exact = reference::sinusoidal;
using exact::kPi;
using exact::Vector;

constexpr double kPlace = 1.0 / 32768;  // the last of s0.15
constexpr int kPeriod = 1200;           // clocks
constexpr double kDc = 2700.0 / 4096;   // of the voltage's full scale

inline Int<16> word(double x) { return static_cast<int>(std::lround(x / kPlace)); }
inline double value(Int<16> x) { return double(x.raw()) * kPlace; }

// The servo motor m2310p at 24 V of 36 V, 20 A, 20 kHz: R T/L in u0.15, T/L in u2.13.
constexpr int kDecay = 3113, kGain = 3686;
// The same in the reference's terms: what the words mean, not what they were rounded from.
inline design::sinusoidal::Motor motor() {
  const double gain = kGain / 8192.0, decay = kDecay / 32768.0;
  return {.resistance = decay / gain,
          .inductance_d = 1 / gain,
          .inductance_q = 1 / gain,
          .k_e = 1 / (2 * kPi * 5894 / 131072.0)};
}

// Vectors of the length of a phase's peak.
inline Vector clarke(const exact::Phases& p) { return std::sqrt(2.0 / 3) * exact::clarke(p); }

// A motor that turns at a constant speed, with its current held near a set one; currents as the
// ADCs of both estimators show them.
class Turning {
 public:
  Turning(double angle, double turns, double i_delta, DeadClocks dead)
      : applied_({.period = kPeriod, .dead_time = double(dead.raw()) / 16,
                  .small_current = 16 * kPlace}),
        dead_(dead), angle_(angle), speed_(2 * kPi * turns), i_delta_(i_delta) {}

  // One interval on.
  void step() {
    const auto m = motor();
    const Vector e = exact::from_frame(angle_ + 0.5 * speed_, {0, m.k_e * speed_});
    const Vector next = exact::from_frame(angle_ + speed_, {0, i_delta_});
    const Vector wanted = e + m.resistance * i_ + m.inductance_q * (next - i_);
    exact::Phases share;
    const double half = std::sqrt(0.75) * wanted.y;
    const double v[3] = {wanted.x, -0.5 * wanted.x + half, -0.5 * wanted.x - half};
    for (std::size_t k = 0; k < 3; ++k) {
      const double duty = std::clamp(0.5 + v[k] / kDc, 0.0, 1.0);
      on_[k] = static_cast<int>(std::lround(duty * kPeriod));
      share[k] = double(on_[k]) / kPeriod;
    }
    const exact::Phases before = seen();
    const Vector given = clarke(applied_(share, before, kDc));
    i_ = i_ + (1 / m.inductance_q) * (given - m.resistance * i_ - e);
    exact::Phases mean;
    for (std::size_t k = 0; k < 3; ++k) mean[k] = 0.5 * (before[k] + seen()[k]);
    interval_ = {.voltage = clarke(applied_(share, mean, kDc)),
                 .before = clarke(before), .current = clarke(seen())};
    angle_ = exact::wrapped(angle_ + speed_);
  }

  // For an estimator's block, without its words.
  template <class In>
  In in() const {
    In in;
    in.enable = true;
    in.i_u = word(seen()[0]);
    in.i_v = word(seen()[1]);
    in.v_dc = 2700;
    in.pattern = {.on_u = on_[0], .on_v = on_[1], .on_w = on_[2], .period = kPeriod,
                  .dead = dead_, .inverse = 9321};
    return in;
  }
  const exact::Interval& interval() const { return interval_; }
  double angle() const { return angle_; }

 private:
  // The third phase is minus the two others, after rounding as before.
  exact::Phases seen() const {
    const double u = value(word(i_.x)), v = value(word(-0.5 * i_.x + std::sqrt(0.75) * i_.y));
    return {u, v, -u - v};
  }

  exact::AppliedVoltage applied_;
  DeadClocks dead_;
  double angle_, speed_, i_delta_;
  int on_[3] = {kPeriod / 2, kPeriod / 2, kPeriod / 2};
  Vector i_;
  exact::Interval interval_;
};

inline double angle_of(Angle a) { return 2 * kPi * double(a.raw()) / (1 << 24); }
inline double turns_of(Turn t) { return double(t.raw()) / (1 << 23); }

}  // namespace steplock::turning
