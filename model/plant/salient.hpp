// Winding around a salient rotor with a sinusoidal field: L_d, L_q, and iron that saturates along d.
//
//     lambda_d(i_d) = flux + L_d (i_d - s (sqrt(i_d^2 + I^2) - I))        lambda_q = L_q i_q
//     l_d(i_d)      = d lambda_d / d i_d = L_d (1 - s i_d / sqrt(i_d^2 + I^2))
//     v_k - v_n     = R i_k + lambda_k'                                    conducting legs
//     torque        = 3/2 pole_pairs (lambda_d i_q - lambda_q i_d)
//     stored        = 3/2 (integral of i_d d lambda_d + L_q i_q^2 / 2)
//
// lambda_d depends on i_d alone and lambda_q on i_q alone, so the stored energy is a function of the
// state, and the energy law holds whatever the currents.  Positive i_d strengthens the magnet and
// meets less inductance, from L_d (1 + s) far below zero to L_d (1 - s) far above: polarity shows.
//
// The d axis, the magnet's north pole, stands at theta_e + 180 degrees: lambda_u = -flux cos theta_e,
// whose derivative is the back-EMF flux w_e sin theta_e of every other file here.
//
// In the stator's alpha-beta frame lambda' = L i' + motion, L = Rot diag(l_d, L_q) Rot^-1.  A
// terminal without current sees motion and what L couples into it: with
//
//     emf_k = phase k of (motion + (L - L_q) i')      v_k - v_n - emf_k = R i_k + L_q i_k'
//
// holds in every leg, so the circuit's rules for star point, floating legs and diodes stay as they are.
//
// Doc: docs/plant.md   Test: tests/model/plant/salient_test.cpp
#pragma once

#include "model/plant/bemf.hpp"
#include "model/plant/circuit.hpp"
#include "model/plant/parameters.hpp"

namespace steplock::plant {

class SalientWinding {
 public:
  explicit SalientWinding(const Motor&);

  // Whether the motor needs this winding: else the constant L - M of dynamics.hpp does, and faster.
  static bool needed(const Motor& m) {
    return m.inductance_d > 0 || m.inductance_q > 0 || m.saturation > 0;
  }

  // The magnetic circuit at an electrical angle and a set of phase currents.
  struct Field {
    double cosine, sine;  // of the d axis
    double i_d, i_q, lambda_d, lambda_q, l_d;
  };
  Field field(double angle, const Phases& current) const;

  double torque(const Field& f) const {
    return 1.5 * pole_pairs_ * (f.lambda_d * f.i_q - f.lambda_q * f.i_d);
  }
  double stored(const Field&) const;  // J

  struct Motion {
    Phases slope;  // A/s
    Phases emf;    // V, as above
  };
  // `w`: mechanical speed, rad/s.
  Motion motion(const Circuit&, const Field&, const Phases& current, double w,
                double bus_voltage) const;

 private:
  double pole_pairs_, resistance_, flux_, l_d_, l_q_, saturation_, saturation_current_;
};

// The emf of every trial circuit at one state, for Circuit::resolve().
struct SalientState {
  const SalientWinding& winding;
  SalientWinding::Field field;
  Phases current;
  double w, bus_voltage;

  Phases emf(const Circuit& circuit) const {
    return winding.motion(circuit, field, current, w, bus_voltage).emf;
  }
};

}  // namespace steplock::plant
