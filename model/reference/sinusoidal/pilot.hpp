// Initial position of a salient rotor from pilot voltage pulses, Eqs. (21)-(26) and Table II.
//
// A pulse connects one winding to the bus against the two others; its current's peak is
//
//     I_k = I_o + Delta I_o cos(2 theta - 240 deg k)          (22), theta from winding u to the N pole
//     tan 2 theta = sqrt 3 (dI_W - dI_V) / (2 dI_U - dI_V - dI_W)        (24)-(25)
//
// The arctangent takes the place of (26)'s approximation (1.5 degrees off at the domain's edge) and
// spans all six rows of Table II.  Iron that saturates adds terms that are odd in theta; each pattern
// is therefore also given reversed, and the mean of the two peaks holds none of them.
//
// Polarity: two long pulses along the winding nearest to the position, one each way.  The one that
// strengthens the magnet meets less inductance: its peak is greater, and theta points there.
//
// A rotor without enough saliency, or peaks too alike, is reported as ambiguous, not guessed.
//
// Doc: docs/sinusoidal.md   Test: tests/model/reference/sinusoidal/sinusoidal_pilot_test.cpp
#pragma once

#include <array>
#include <optional>

#include "model/design/sinusoidal/parameters.hpp"
#include "model/reference/signals.hpp"
#include "model/reference/sinusoidal/vector.hpp"

namespace steplock::reference::sinusoidal {

// Patterns 0, 1, 2: winding u, v, w to the bus and the two others to ground; 3, 4, 5: the reverse.
inline Gates pilot_gates(int pattern) {
  Gates g = {};
  for (int leg = 0; leg < 3; ++leg) g[2 * leg + ((leg == pattern % 3) == (pattern < 3) ? 0 : 1)] = true;
  return g;
}

// Into (-90, 90] degrees; `saliency` is Delta I_o / I_o.
struct Axis {
  double angle = 0, saliency = 0;
};
inline Axis pilot_axis(const Phases& peak) {
  const double mean = (peak[0] + peak[1] + peak[2]) / 3;
  const double du = peak[0] - mean, dv = peak[1] - mean, dw = peak[2] - mean;
  const double y = std::numbers::sqrt3 * (dw - dv), x = 2 * du - dv - dw;
  return {0.5 * std::atan2(y, x), std::hypot(x, y) / 3 / mean};
}

// The pattern whose direction (0, 120, 240 degrees, or opposite) is nearest to an angle.
inline int nearest_pattern(double angle) {
  const int sixth = static_cast<int>(std::lround(wrapped(angle) / (kPi / 3)) + 6) % 6;
  constexpr int kOf[6] = {0, 5, 1, 3, 2, 4};  // +u, -w, +v, -u, +w, -v
  return kOf[sixth];
}

// Gives the pulses one after the other; the caller applies them, and hands over samples.
class PilotPulses {
 public:
  enum class Result { kNone, kFound, kNoSaliency, kNoPolarity, kNoDecay };

  explicit PilotPulses(const design::sinusoidal::Pilot& p) : p_(p) {}

  void start(double t) {
    *this = PilotPulses(p_);
    begin(t);
  }

  bool pulsing() const { return pulsing_; }
  int pattern() const { return pattern_; }
  double pulse_end() const { return begun_ + length(); }  // the peak is to be sampled there
  void end_pulse(double t) { pulsing_ = false, begun_ = t; }

  // The sample of a pulse's end.
  void peak(const Phases& current) {
    const double i = current[static_cast<std::size_t>(pattern_ % 3)] * (pattern_ < 3 ? 1 : -1);
    if (given_ < shorts()) {
      short_[static_cast<std::size_t>(pattern_ % 3)] += i / (2 * p_.repeats);
    } else {
      long_[static_cast<std::size_t>(given_ - shorts())] = i;
    }
    ++given_;
  }

  // A sample between pulses; the next one begins when all current is gone.
  void wait(double t, const Phases& current) {
    double greatest = 0;
    for (const double i : current) greatest = std::max(greatest, std::abs(i));
    quiet_ = greatest < p_.decayed ? quiet_ + 1 : 0;
    if (quiet_ >= 2) {
      next(t);
    } else if (t > begun_ + p_.decay_s) {
      result_ = Result::kNoDecay;
    }
  }

  Result result() const { return result_; }
  double angle() const { return angle_; }        // rad, of the N pole from winding u
  double saliency() const { return saliency_; }  // Delta I_o / I_o
  double polarity() const { return polarity_; }  // difference of the long peaks over their sum

 private:
  int shorts() const { return 6 * p_.repeats; }
  double length() const { return given_ < shorts() ? p_.short_s : p_.long_s; }

  void begin(double t) {
    // U, then U reversed, then V ...: what the first turns the rotor, the second turns back.
    if (given_ < shorts()) pattern_ = given_ % 6 / 2 + 3 * (given_ % 2);
    pulsing_ = true;
    begun_ = t;
    quiet_ = 0;
  }

  void next(double t) {
    if (given_ == shorts()) {
      const Axis axis = pilot_axis(short_);
      angle_ = axis.angle;
      saliency_ = axis.saliency;
      if (saliency_ < p_.least_saliency) result_ = Result::kNoSaliency;
      pattern_ = nearest_pattern(angle_);
    } else if (given_ == shorts() + 1) {
      pattern_ = (pattern_ + 3) % 6;
    } else if (given_ == shorts() + 2) {
      polarity_ = (long_[0] - long_[1]) / (long_[0] + long_[1]);
      result_ = std::abs(polarity_) < p_.least_polarity ? Result::kNoPolarity : Result::kFound;
      // The first long pulse lay within 30 degrees of angle_.
      if (polarity_ < 0) angle_ = wrapped(angle_ + kPi);
    }
    if (result_ == Result::kNone) begin(t);
  }

  design::sinusoidal::Pilot p_;
  Result result_ = Result::kNone;
  bool pulsing_ = false;
  int pattern_ = 0, given_ = 0, quiet_ = 0;
  double begun_ = 0, angle_ = 0, saliency_ = 0, polarity_ = 0;
  Phases short_ = {};
  std::array<double, 2> long_ = {};
};

}  // namespace steplock::reference::sinusoidal
