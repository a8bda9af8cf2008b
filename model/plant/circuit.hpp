// Bridge and star winding as a circuit: which switch or diode of each leg conducts, and what
// voltages follow.
//
//     conducting leg   v = share * v_bus + lift - resistance * i      (i into the motor)
//     floating leg     i = 0,  v = v_n + e
//     star point       v_n = mean of (v - e) over the legs that conduct
//
//     leg            share  lift    resistance
//     high switch    1      0       on
//     low switch     0      0       on
//     high diode     1      +drop   diode        i < 0
//     low diode      0      -drop   diode        i > 0
//     both on        1/2    0       on / 2       reported by the plant; its own current is not
//     modelled
//     open winding   share of its switch, i = 0, the star point does not know it
//
// If nothing conducts, three equal resistors from the terminals to ground hold the mean of the
// terminals at zero, and the low diodes keep the lowest terminal above -drop: the star point is the
// higher of the two levels.  The resistors' microamperes are neglected everywhere else.  The terminal
// of an open winding is the bridge's: at a rail while a switch is on, else its resistor holds it at
// ground.
//
// A switch's channel carries either direction alone; the diode beside it is idle while it is on.
//
// Doc: docs/plant.md   Test: tests/model/plant/circuit_test.cpp
#pragma once

#include <algorithm>
#include <array>

#include "model/plant/bemf.hpp"
#include "model/plant/plant.hpp"

namespace steplock::plant {

enum class LegMode { kFloating, kHighSwitch, kLowSwitch, kHighDiode, kLowDiode, kBoth, kOpen };
using Legs = std::array<bool, 3>;

struct SalientState;

struct Terminals {
  Phases voltage;
  double neutral;
};

class Circuit {
 public:
  // The only consistent state of conduction: legs with a switch on follow it, legs with current and
  // no switch use the diode of that direction, and of those without current a diode starts only if
  // the terminal would otherwise leave [-drop, v_bus + drop].  `open`: windings without contact,
  // which carry no current.  `salient`: has the emf instead, which then depends on what conducts.
  static Circuit resolve(const Bridge&, const Gates&, const Phases& current, const Phases& emf,
                         double bus_voltage, const Legs& open = {},
                         const SalientState* salient = nullptr);

  Terminals terminals(const Phases& current, const Phases& emf, double bus_voltage) const {
    Terminals out;
    double sum = 0;
    for (int k = 0; k < 3; ++k) {
      out.voltage[k] = share[k] * bus_voltage + lift[k] - resistance[k] * current[k];
      sum += on[k] * (out.voltage[k] - emf[k]);
    }
    out.neutral = sum * inverse_count;
    if (inverse_count == 0) out.neutral = coasting(emf);
    for (int k = 0; k < 3; ++k) {
      if (mode[k] == LegMode::kFloating) out.voltage[k] = out.neutral + emf[k];
    }
    return out;
  }

  // Into ground through the common shunt; the same current that leaves the bus (the loop through
  // two low sides closes above the shunt).
  double bus_current(const Phases& i) const {
    return share[0] * i[0] + share[1] * i[1] + share[2] * i[2];
  }

  bool is_diode(int leg) const { return mode[leg] == LegMode::kLowDiode || mode[leg] == LegMode::kHighDiode; }

  std::array<LegMode, 3> mode = {};
  Phases share = {}, lift = {}, resistance = {};
  Phases on = {};            // 1 if the leg conducts
  double inverse_count = 0;  // 1 / number of conducting legs, 0 if none
  double drop = 0;

 private:
  // The star point when nothing conducts.
  double coasting(const Phases& emf) const {
    double sum = 0, lowest = 0;
    int attached = 0;
    for (int k = 0; k < 3; ++k) {
      if (mode[k] == LegMode::kOpen) continue;
      sum += emf[k];
      lowest = attached++ == 0 ? emf[k] : std::min(lowest, emf[k]);
    }
    return attached == 0 ? 0 : std::max(-sum / attached, -drop - lowest);
  }
  void set(int leg, LegMode, const Bridge&);
  void disconnect(int leg);  // its switch keeps the terminal, but not the winding
  void count();
  bool consistent(const std::array<bool, 3>& undecided, const Phases& current, const Phases& emf,
                  double bus_voltage) const;
};

}  // namespace steplock::plant
