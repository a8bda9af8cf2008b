// The voltage that the bridge applied, reconstructed from PWM pattern, dc voltage and dead time; it
// is never measured (Sec. II).  And the same backwards: the duty that makes up for dead time.
//
// Over one period a leg that switches loses dead_time at each edge.  The diode that takes over holds the
// terminal low while the current flows into the motor, high otherwise:
//
//     v_k = (d_k - s_k t_d / T) v_dc - s_k (2 t_d / T) v_diode        s_k = sign(i_k)
//
// A leg that does not switch (duty 0 or 1) loses nothing.  Near zero, ripple gives a measured current
// either sign: below small_current s_k = i_k / small_current.  A wanted one has its sign.
//
// Doc: docs/sinusoidal.md   Test: tests/model/reference/sinusoidal/sinusoidal_voltage_test.cpp
#pragma once

#include <algorithm>

#include "model/design/sinusoidal/parameters.hpp"
#include "model/reference/sinusoidal/vector.hpp"

namespace steplock::reference::sinusoidal {

class AppliedVoltage {
 public:
  explicit AppliedVoltage(const design::sinusoidal::Applied& p) : p_(p) {}

  Phases operator()(const Phases& duty, const Phases& current, double v_dc) const {
    Phases v;
    for (std::size_t k = 0; k < 3; ++k) {
      const bool switches = duty[k] > 0 && duty[k] < 1;
      const double s = switches ? direction(current[k]) : 0;
      v[k] = (duty[k] - s * share()) * v_dc - 2 * s * share() * p_.diode_drop;
      v[k] = std::clamp(v[k], -p_.diode_drop, v_dc + p_.diode_drop);
    }
    return v;
  }

  // What to ask of the PWM so that `duty` comes about at this wanted current.
  Phases compensated(const Phases& duty, const Phases& current, double v_dc) const {
    Phases d = duty;
    if (!p_.compensate || v_dc <= 0) return d;
    for (std::size_t k = 0; k < 3; ++k) {
      d[k] += sign(current[k]) * share() * (1 + 2 * p_.diode_drop / v_dc);
      d[k] = std::clamp(d[k], 0.0, 1.0);
    }
    return d;
  }

 private:
  double share() const { return p_.dead_time / p_.period; }
  static double sign(double current) { return current > 0 ? 1 : current < 0 ? -1 : 0; }
  double direction(double current) const {
    if (p_.small_current <= 0) return sign(current);
    return std::clamp(current / p_.small_current, -1.0, 1.0);
  }

  design::sinusoidal::Applied p_;
};

}  // namespace steplock::reference::sinusoidal
