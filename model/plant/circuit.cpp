#include "model/plant/circuit.hpp"

#include <span>

#include "model/plant/salient.hpp"

namespace steplock::plant {
namespace {

LegMode decided(bool high, bool low, double current) {
  if (high && low) return LegMode::kBoth;
  if (high) return LegMode::kHighSwitch;
  if (low) return LegMode::kLowSwitch;
  if (current > 0) return LegMode::kLowDiode;
  if (current < 0) return LegMode::kHighDiode;
  return LegMode::kFloating;
}

constexpr LegMode kChoice[3] = {LegMode::kFloating, LegMode::kLowDiode, LegMode::kHighDiode};

}  // namespace

Circuit Circuit::resolve(const Bridge& bridge, const Gates& gates, const Phases& current,
                         const Phases& emf, double bus_voltage, const Legs& open,
                         const SalientState* salient) {
  const auto emf_in = [&](const Circuit& c) { return salient ? salient->emf(c) : emf; };
  Circuit circuit;
  circuit.drop = bridge.diode_drop;
  const bool high[3] = {gates.uh, gates.vh, gates.wh}, low[3] = {gates.ul, gates.vl, gates.wl};
  std::array<bool, 3> undecided = {};
  for (int k = 0; k < 3; ++k) {
    circuit.set(k, decided(high[k], low[k], current[k]), bridge);
    if (open[k]) circuit.disconnect(k);
    undecided[k] = circuit.mode[k] == LegMode::kFloating;
  }
  circuit.count();
  if (circuit.consistent(undecided, current, emf_in(circuit), bus_voltage)) return circuit;

  // A linear complementarity problem of three unknowns with one solution: try all.
  const auto choices = [&](int leg) { return std::span(kChoice).first(undecided[leg] ? 3 : 1); };
  Circuit trial = circuit;
  for (const LegMode w : choices(2)) {
    for (const LegMode v : choices(1)) {
      for (const LegMode u : choices(0)) {
        const LegMode choice[3] = {u, v, w};
        for (int k = 0; k < 3; ++k) {
          if (undecided[k]) trial.set(k, choice[k], bridge);
        }
        trial.count();
        if (trial.consistent(undecided, current, emf_in(trial), bus_voltage)) return trial;
      }
    }
  }
  return circuit;  // a tie within rounding: float, and let the guards see the next instant
}

void Circuit::set(int leg, LegMode leg_mode, const Bridge& bridge) {
  mode[leg] = leg_mode;
  on[leg] = leg_mode != LegMode::kFloating;
  share[leg] = lift[leg] = resistance[leg] = 0;
  switch (leg_mode) {
    case LegMode::kFloating:
    case LegMode::kOpen:
      break;
    case LegMode::kHighSwitch:
      share[leg] = 1;
      resistance[leg] = bridge.on_resistance;
      break;
    case LegMode::kLowSwitch:
      resistance[leg] = bridge.on_resistance;
      break;
    case LegMode::kBoth:
      share[leg] = 0.5;
      resistance[leg] = bridge.on_resistance / 2;
      break;
    case LegMode::kHighDiode:
      share[leg] = 1;
      lift[leg] = bridge.diode_drop;
      resistance[leg] = bridge.diode_resistance;
      break;
    case LegMode::kLowDiode:
      lift[leg] = -bridge.diode_drop;
      resistance[leg] = bridge.diode_resistance;
      break;
  }
}

void Circuit::disconnect(int leg) {
  mode[leg] = LegMode::kOpen;
  on[leg] = lift[leg] = resistance[leg] = 0;
}

void Circuit::count() {
  const double conducting = on[0] + on[1] + on[2];
  inverse_count = conducting > 0 ? 1 / conducting : 0;
}

bool Circuit::consistent(const std::array<bool, 3>& undecided, const Phases& current,
                         const Phases& emf, double bus_voltage) const {
  const Terminals t = terminals(current, emf, bus_voltage);
  for (int k = 0; k < 3; ++k) {
    if (!undecided[k]) continue;
    const double drive = t.voltage[k] - emf[k] - t.neutral;  // what makes the current grow
    switch (mode[k]) {
      case LegMode::kLowDiode:
        if (!(drive > 0)) return false;
        break;
      case LegMode::kHighDiode:
        if (!(drive < 0)) return false;
        break;
      default: {
        // With nothing conducting the star point itself yields to the low diodes.
        const bool low_held = inverse_count == 0;
        if (!low_held && t.voltage[k] < -drop) return false;
        if (t.voltage[k] > bus_voltage + drop) return false;
      }
    }
  }
  return true;
}

}  // namespace steplock::plant
