#include "model/plant/dynamics.hpp"

#include <algorithm>

namespace steplock::plant {

Dynamics::Dynamics(const Parameters& p)
    : bridge_(p.bridge),
      back_emf_(p.motor.shape),
      winding_(p.motor),
      load_(p),
      salient_(SalientWinding::needed(p.motor)),
      resistance_(p.motor.resistance),
      inductance_(p.motor.inductance - p.motor.mutual),
      inverse_inductance_(1 / inductance_),
      pole_pairs_(p.motor.pole_pairs),
      torque_constant_(p.motor.flux * p.motor.pole_pairs),
      own_inertia_(p.motor.inertia + (load_.springs() ? 0 : p.load.inertia)),
      inertia_(own_inertia_),
      inverse_inertia_(1 / inertia_),
      coulomb_(p.motor.coulomb_friction),
      static_(p.motor.static_friction),
      viscous_(p.motor.viscous_friction),
      fan_(load_.springs() ? 0 : p.motor.fan_friction),
      cogging_torque_(p.motor.cogging_torque),
      cogging_periods_(p.motor.cogging_periods),
      cogging_rate_(cogging_periods_ / pole_pairs_),
      cogging_offset_(p.motor.cogging_phase),
      stiff_bus_(p.bus.resistance == 0),
      source_sinks_(p.bus.sinks),
      bus_resistance_(p.bus.resistance),
      bus_conductance_(stiff_bus_ ? 0 : 1 / p.bus.resistance),
      capacitance_(stiff_bus_ ? 0 : p.bus.capacitance),
      inverse_capacitance_(stiff_bus_ ? 0 : 1 / p.bus.capacitance) {
  // A hundredth of what the motor could reach at this bus.
  const double current = 0.01 * p.bus.voltage / resistance_;
  const double speed = torque_constant_ > 0 ? 0.01 * p.bus.voltage / torque_constant_ : 1;
  constexpr double kTwistScale = 0.01;  // rad
  scale_ = {current, current, current, speed, 1.0, p.bus.voltage, speed, kTwistScale};
}

void Dynamics::couple(double inertia) {
  inertia_ = own_inertia_ + inertia;
  inverse_inertia_ = 1 / inertia_;
}

Regime Dynamics::regime(const Variables& y, const Inputs& in, double turns) const {
  Regime regime;
  regime.active = in.active_torque;
  regime.source_voltage = in.source_voltage;
  regime.source_conducts = source_sinks_ || y[kBus] <= in.source_voltage ? 1 : 0;
  regime.hold = static_ + in.opposing_torque + in.breakaway_torque;
  if (load_.acts()) regime.turned = std::fmod(turns, pole_pairs_) * kTurn / pole_pairs_;
  if (cogging_torque_ > 0) {
    regime.cogging_phase = std::fmod(turns, pole_pairs_) * kTurn * cogging_rate_ + cogging_offset_;
  }

  const double w = y[kSpeed];
  regime.direction = w < 0 ? -1 : 1;
  regime.piece = back_emf_.piece(y[kAngle], regime.direction);
  const Phases shape = back_emf_(regime.piece, y[kAngle]);
  const Phases current = {y[kIu], y[kIv], y[kIw]};
  SalientState state{winding_, {}, current, w, y[kBus]};
  if (salient_) state.field = winding_.field(y[kAngle], current);
  if (w == 0) {
    const double torque =
        salient_ ? winding_.torque(state.field)
                 : torque_constant_ * (shape[0] * y[0] + shape[1] * y[1] + shape[2] * y[2]);
    const double pulled = pull(regime, y, torque);
    regime.turning = std::abs(pulled) > regime.hold ? 1 : 0;
    regime.direction = pulled < 0 ? -1 : 1;
    regime.piece = back_emf_.piece(y[kAngle], regime.direction);
  }
  regime.dry = regime.direction * (coulomb_ + in.opposing_torque);

  Phases emf;
  for (int k = 0; k < 3; ++k) emf[k] = torque_constant_ * w * shape[k];
  Legs open;
  for (int k = 0; k < 3; ++k) {
    open[k] = in.open[k] && y[k] == 0;
    regime.opening[k] = in.open[k] && !open[k];
  }
  regime.circuit = Circuit::resolve(bridge_, in.gates, current, emf, y[kBus], open,
                                    salient_ ? &state : nullptr);
  return regime;
}

void Dynamics::salient_derivative(const Regime& regime, const Variables& y, Variables& slope,
                                  Powers& power) const {
  const Circuit& circuit = regime.circuit;
  const Phases current = {y[kIu], y[kIv], y[kIw]};
  const SalientWinding::Field field = winding_.field(y[kAngle], current);
  const Phases rise = winding_.motion(circuit, field, current, y[kSpeed], y[kBus]).slope;
  double copper = 0, bridge_loss = 0;
  for (int k = 0; k < 3; ++k) {
    slope[k] = rise[k];
    copper += current[k] * current[k];
    bridge_loss += (circuit.resistance[k] * current[k] - circuit.lift[k]) * current[k];
  }
  power[kCopper] = resistance_ * copper;
  power[kBridge] = bridge_loss;
  mechanics(regime, y, winding_.torque(field), circuit.bus_current(current), slope, power);
}

Outputs Dynamics::salient_outputs(const Regime& regime, const Variables& y) const {
  Outputs out;
  const Phases current = {y[kIu], y[kIv], y[kIw]};
  const SalientWinding::Field field = winding_.field(y[kAngle], current);
  out.shape = back_emf_(regime.piece, y[kAngle]);
  for (int k = 0; k < 3; ++k) out.emf[k] = torque_constant_ * y[kSpeed] * out.shape[k];
  const Phases emf = winding_.motion(regime.circuit, field, current, y[kSpeed], y[kBus]).emf;
  out.terminals = regime.circuit.terminals(current, emf, y[kBus]);
  out.torque = winding_.torque(field);
  out.pull = pull(regime, y, out.torque);
  out.bridge_current = regime.circuit.bus_current(current);
  out.source_current = source_current(regime, y, out.bridge_current);
  return out;
}

Energy Dynamics::stored(const Regime& regime, const Variables& y) const {
  Energy energy;
  energy.kinetic = 0.5 * inertia_ * y[kSpeed] * y[kSpeed];
  energy.magnetic = 0.5 * inductance_ * (y[kIu] * y[kIu] + y[kIv] * y[kIv] + y[kIw] * y[kIw]);
  if (salient_) {
    energy.magnetic = winding_.stored(winding_.field(y[kAngle], {y[kIu], y[kIv], y[kIw]}));
  }
  energy.capacitor = 0.5 * capacitance_ * y[kBus] * y[kBus];
  energy.cogging = -cogging_torque_ / cogging_periods_ *
                   std::cos(cogging_rate_ * y[kAngle] + regime.cogging_phase);
  if (load_.acts()) {
    const CoupledLoad::Motion m = motion(regime, y);
    energy.kinetic += load_.kinetic(m);
    energy.unbalance = load_.lifted(m);
    energy.spring = load_.wound(m);
  }
  return energy;
}

}  // namespace steplock::plant
