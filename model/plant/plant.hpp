// The plant: three-phase motor, six-switch bridge, dc bus, load and sensors, as one event-driven
// object that a co-simulation asks only when something can have happened.
//
//     electrical angle   theta_e = pole_pairs * angle; e_u crosses zero rising at theta_e = 0,
//                        e_v 120 and e_w 240 degrees later (positive speed)
//     torque             flux * pole_pairs * sum of shape_k i_k (+ cogging)
//     ideal forward six-step commutation at theta_e = 30, 90, 150, ... degrees
//
//     theta_e, degrees   30-90   90-150  150-210  210-270  270-330  330-30
//     current  + / -      u v     u w     v w      v u      w u      w v     most torque forward
//     floats, its e       w fall  v rise  u fall   w rise   v fall   u rise  crosses in the middle
//     halls u v w         1 0 1   1 0 0   1 1 0    0 1 0    0 1 1    0 0 1   u high in [30, 210)
//
// Currents are positive into the motor; voltages are against ground (the lower end of the bus).
// All motion between two discontinuities is one error-controlled Dormand-Prince step with its
// dense output; every discontinuity (gate, diode, clamp, corner of the BEMF, stiction, source that
// blocks) ends a step exactly.  Comparators and Halls are read off the dense output.
//
// Use:    while (t < end) {
//           if (t >= plant.next_event()) plant.advance_to(t), read(plant.pins());
//           if (gates changed) plant.advance_to(t), plant.set_gates(g), read(plant.pins());
//           t += clock period;
//         }
//
// Doc: docs/plant.md   Test: tests/model/plant/
#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "model/plant/parameters.hpp"

namespace steplock::plant {

// True turns the switch on; uh is phase u's high side.
struct Gates {
  bool uh = false, ul = false, vh = false, vl = false, wh = false, wl = false;
  bool operator==(const Gates&) const = default;
};

// The asynchronous pins, after the analog delay.
struct Pins {
  std::array<bool, 3> comparator = {};  // terminal above the reference
  bool limit = false;                   // shunt current above its threshold
  std::array<bool, 3> hall = {};
  bool operator==(const Pins&) const = default;
};

struct InitialState {
  double angle = 0;                    // rad, mechanical; electrical angle is pole_pairs times it
  double speed = 0;                    // rad/s, mechanical
  std::array<double, 3> current = {};  // A, into the motor; must sum to zero
  double bus_voltage = -1;             // V; negative: the source's voltage
};

// Integrals since the start, and what is stored now, all in J.
struct Energy {
  double supplied = 0;  // by the source, behind its resistance
  double copper = 0, bridge = 0, bus_resistance = 0, friction = 0;  // turned into heat
  double load = 0;                                                  // work done on the load torques
  double kinetic = 0, magnetic = 0, capacitor = 0, cogging = 0, unbalance = 0, spring = 0;  // stored now
  double stored_at_start = 0;

  double stored() const { return kinetic + magnetic + capacitor + cogging + (unbalance + spring); }
  // Zero but for the integration error: the running check of the plant's own arithmetic.
  double residual() const {
    return supplied - copper - bridge - bus_resistance - friction - load -
           (stored() - stored_at_start);
  }
};

struct State {
  double time = 0;                     // s
  std::array<double, 3> current = {};  // A, into the motor
  std::array<double, 3> voltage = {};  // V, terminals
  double neutral = 0;                  // V, star point
  double virtual_neutral = 0;          // V, mean of the terminals
  std::array<double, 3> emf = {};      // V, back-EMF of each phase
  double bus_voltage = 0;              // V, at the bridge
  double source_current = 0;           // A, out of the source
  double shunt_current = 0;            // A, from the bridge to ground
  double torque = 0;                   // N m, electromagnetic
  double speed = 0;                    // rad/s, mechanical
  double angle = 0;                    // rad, mechanical, unwrapped
  double electrical_angle = 0;         // rad, unwrapped
  bool stuck = false;                  // held by friction
  std::array<bool, 3> floating = {};   // the winding carries nothing: no switch, no diode, or open
  Energy energy = {};
};

class Plant {
 public:
  // Throws std::invalid_argument with validate()'s lines if the parameters make no sense.
  explicit Plant(const Parameters&, const InitialState& = {});
  Plant(Plant&&) noexcept;
  Plant& operator=(Plant&&) noexcept;
  ~Plant();

  double time() const;
  const Pins& pins() const;

  // No pin changes before this time under the present gates and inputs.  May be a mere horizon
  // (Accuracy::max_step at most), at which nothing happens.  Always later than time().
  double next_event() const;

  // To t >= time().  Beyond next_event() it goes through all events on the way, in order.
  void advance_to(double t);

  // From time() on.  Pins that answer without delay have their new value on return.
  void set_gates(const Gates&);
  const Gates& gates() const;
  void set_load_torque(double opposing);  // N m, >= 0, against the motion
  void set_active_torque(double torque);  // N m, towards negative speed
  void set_bus_voltage(double source);    // V, > 0
  void set_limit_threshold(double amps);  // A, > 0
  // kg m^2, >= 0, at the rotor besides the parameters' inertia.  The mass already turns as fast as the rotor (a gear
  // that is engaged in step): the speed stays, its energy comes from outside.
  void set_coupled_inertia(double inertia);
  // The contact between phase k's winding and its terminal.  One that opens with current in it arcs
  // until that current is next zero, and opens then.
  void set_open(int k, bool open);

  // How often a leg had both gates on.  The leg then stands at half the bus; no current spike is
  // modelled, the count is the finding.
  std::uint64_t shoot_throughs() const;

  State state() const;
  std::uint64_t steps() const;  // integration steps so far, rejected ones included

 private:
  struct Core;
  std::unique_ptr<Core> core_;
};

}  // namespace steplock::plant
