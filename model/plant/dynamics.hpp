// The plant's differential equations between two discontinuities.
//
//     (L - M) i_k' = v_k - v_n - R i_k - e_k                  conducting legs; 0 for floating ones
//     J w'         = torque + cogging + load - active - direction (coulomb + opposing) - B w - F w |w|
//     load         = unbalance, wind and spring (coupled_load.hpp); with a spring J is the rotor's and F is behind it
//     theta_e'     = pole_pairs w
//     C v_bus'     = i_source - sum of share_k i_k            i_source = (V - v_bus) / R_bus
//     torque       = flux pole_pairs sum of shape_k i_k       e_k = flux pole_pairs w shape_k
//
// What switches (conduction, piece of the BEMF, direction of dry friction, a source that blocks) is
// held in a Regime, constant over a step; regime() is the only place that decides it.
//
// A salient or saturating motor replaces the first line and the torque by salient.hpp's; the round
// one keeps its own path, which is faster.
//
// Doc: docs/plant.md   Test: tests/model/plant/dynamics_test.cpp
#pragma once

#include <array>
#include <cmath>

#include "model/plant/bemf.hpp"
#include "model/plant/circuit.hpp"
#include "model/plant/coupled_load.hpp"
#include "model/plant/parameters.hpp"
#include "model/plant/salient.hpp"

namespace steplock::plant {

// Phase currents A, mechanical speed rad/s, electrical angle rad, bus voltage V; behind a spring the load's
// speed rad/s, and the spring's twist rad.
enum Variable { kIu, kIv, kIw, kSpeed, kAngle, kBus, kLoadSpeed, kTwist };
using Variables = std::array<double, 8>;

// W; integrated over time they are the entries of Energy.
enum Power { kSupplied, kCopper, kBridge, kBusResistance, kFriction, kLoad };
using Powers = std::array<double, 6>;

// What may be set at run time.
struct Inputs {
  Gates gates = {};
  double opposing_torque = 0;
  double active_torque = 0;
  double breakaway_torque = 0;
  double source_voltage = 0;
  Legs open = {};  // windings whose contact opens as soon as their current is zero
};

struct Regime {
  Circuit circuit;
  Legs opening = {};           // contacts that wait for that zero
  BackEmf::Piece piece;
  double direction = 1;        // sign of the speed; of the coming speed when leaving rest
  double turning = 1;          // 0 while friction holds the rotor
  double dry = 0;              // N m, coulomb + opposing, times direction
  double hold = 0;             // N m, what friction and load hold at rest
  double active = 0;           // N m
  double source_voltage = 0;   // V
  double source_conducts = 1;  // 0 while the source blocks
  double cogging_phase = 0;    // rad, at electrical angle 0 of this step
  double turned = 0;           // rad, mechanical, at electrical angle 0 of this step, within one turn
};

// Everything algebraic at one state.
struct Outputs {
  Phases shape, emf;
  Terminals terminals;
  double torque;          // N m, electromagnetic
  double pull;            // N m, all but friction and opposing load
  double source_current;  // A
  double bridge_current;  // A, through bus and shunt
};

class Dynamics {
 public:
  explicit Dynamics(const Parameters&);

  // `turns` whole electrical turns have been taken out of y's angle.
  Regime regime(const Variables& y, const Inputs&, double turns) const;

  void derivative(const Regime&, const Variables& y, Variables& slope, Powers&) const;
  Outputs outputs(const Regime&, const Variables& y) const;

  Energy stored(const Regime&, const Variables& y) const;  // its four stored entries
  const Variables& scale() const { return scale_; }        // below these, errors are absolute
  double pole_pairs() const { return pole_pairs_; }
  bool springs() const { return load_.springs(); }
  // A mass that turns as fast as the rotor is coupled to it, kg m^2 in all.
  void couple(double inertia);
  bool source_can_block() const { return !source_sinks_ && !stiff_bus_; }

 private:
  void mechanics(const Regime&, const Variables& y, double torque, double bridge_current,
                 Variables& slope, Powers&) const;
  void salient_derivative(const Regime&, const Variables& y, Variables& slope, Powers&) const;
  Outputs salient_outputs(const Regime&, const Variables& y) const;

  double cogging(const Regime& regime, double angle) const {
    if (cogging_torque_ == 0) return 0;
    return -cogging_torque_ * std::sin(cogging_rate_ * angle + regime.cogging_phase);
  }
  CoupledLoad::Motion motion(const Regime& regime, const Variables& y) const {
    return {regime.turned + y[kAngle] / pole_pairs_, y[kSpeed], y[kLoadSpeed], y[kTwist]};
  }
  // N m, of all but friction and opposing load.
  double pull(const Regime& regime, const Variables& y, double torque) const {
    const double sum = torque + cogging(regime, y[kAngle]) - regime.active;
    return load_.acts() ? sum + load_.pull(motion(regime, y)) : sum;
  }
  double source_current(const Regime& regime, const Variables& y, double bridge_current) const {
    if (stiff_bus_) return bridge_current;
    return regime.source_conducts * (regime.source_voltage - y[kBus]) * bus_conductance_;
  }

  Bridge bridge_;
  BackEmf back_emf_;
  SalientWinding winding_;
  CoupledLoad load_;
  bool salient_;
  double resistance_, inductance_, inverse_inductance_;
  double pole_pairs_, torque_constant_;  // flux * pole_pairs
  double own_inertia_, inertia_, inverse_inertia_;
  double coulomb_, static_, viscous_, fan_;
  double cogging_torque_, cogging_periods_, cogging_rate_, cogging_offset_;
  bool stiff_bus_, source_sinks_;
  double bus_resistance_, bus_conductance_, capacitance_, inverse_capacitance_;
  Variables scale_;
};

inline void Dynamics::derivative(const Regime& regime, const Variables& y, Variables& slope,
                                 Powers& power) const {
  if (salient_) return salient_derivative(regime, y, slope, power);
  const Circuit& circuit = regime.circuit;
  const double w = y[kSpeed], bus = y[kBus];
  const Phases shape = back_emf_(regime.piece, y[kAngle]);
  const double emf_per_shape = torque_constant_ * w;

  Phases drive;
  double sum = 0, shape_current = 0, copper = 0, bridge_loss = 0, bridge_current = 0;
  for (int k = 0; k < 3; ++k) {
    const double i = y[k];
    drive[k] = circuit.share[k] * bus + circuit.lift[k] -
               (circuit.resistance[k] + resistance_) * i - emf_per_shape * shape[k];
    sum += circuit.on[k] * drive[k];
    shape_current += shape[k] * i;
    copper += i * i;
    bridge_loss += (circuit.resistance[k] * i - circuit.lift[k]) * i;
    bridge_current += circuit.share[k] * i;
  }
  const double neutral = sum * circuit.inverse_count;
  for (int k = 0; k < 3; ++k) {
    slope[k] = circuit.on[k] * (drive[k] - neutral) * inverse_inductance_;
  }
  power[kCopper] = resistance_ * copper;
  power[kBridge] = bridge_loss;
  mechanics(regime, y, torque_constant_ * shape_current, bridge_current, slope, power);
}

// Rotor and bus, and the powers that both windings have in common.
inline void Dynamics::mechanics(const Regime& regime, const Variables& y, double torque,
                                double bridge_current, Variables& slope, Powers& power) const {
  const double w = y[kSpeed];
  const double friction = regime.dry + viscous_ * w + fan_ * regime.direction * w * w;
  slope[kSpeed] = regime.turning * (pull(regime, y, torque) - friction) * inverse_inertia_;
  slope[kAngle] = regime.turning * pole_pairs_ * w;
  slope[kLoadSpeed] = slope[kTwist] = 0;

  const double source = source_current(regime, y, bridge_current);
  slope[kBus] = (source - bridge_current) * inverse_capacitance_;

  const double opposing = regime.dry - regime.direction * coulomb_;
  power[kSupplied] = regime.source_voltage * source;
  power[kBusResistance] = bus_resistance_ * source * source;
  power[kFriction] = (friction - opposing) * w;
  power[kLoad] = (opposing + regime.active) * w;
  if (!load_.acts()) return;
  const CoupledLoad::Motion m = motion(regime, y);
  slope[kLoadSpeed] = load_.acceleration(m);
  slope[kTwist] = load_.slip(m);
  power[kFriction] += load_.heat(m);
  power[kLoad] += load_.work(m);
}

inline Outputs Dynamics::outputs(const Regime& regime, const Variables& y) const {
  if (salient_) return salient_outputs(regime, y);
  Outputs out;
  const Phases current = {y[kIu], y[kIv], y[kIw]};
  out.shape = back_emf_(regime.piece, y[kAngle]);
  double shape_current = 0;
  for (int k = 0; k < 3; ++k) {
    out.emf[k] = torque_constant_ * y[kSpeed] * out.shape[k];
    shape_current += out.shape[k] * current[k];
  }
  out.terminals = regime.circuit.terminals(current, out.emf, y[kBus]);
  out.torque = torque_constant_ * shape_current;
  out.pull = pull(regime, y, out.torque);
  out.bridge_current = regime.circuit.bus_current(current);
  out.source_current = source_current(regime, y, out.bridge_current);
  return out;
}

}  // namespace steplock::plant
