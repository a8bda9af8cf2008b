// The part of settings_keys.hpp's table that sweeps draw from and judge by: envelope, bounds, hardship, disturbance.
//
// Doc: docs/design.md   Test: tests/model/design/settings_test.cpp
#pragma once

#include "model/design/settings.hpp"

namespace steplock::design {

// `k(name, value, unit, about, low, high)` is called for each key, of the section that `section` then is.
template <class S, class K>
void for_each_sweep_key(S& s, const char*& section, const K& k) {
  section = "envelope";
  auto& v = s.envelope;
  k("load", v.load, "", "dry loads, one is drawn: parts of the torque of the rated current", 0, 2);
  k("fan", v.fan, "", "one more of the loads: a fan that takes this part at set speed; 0: none", 0,
    2);
  k("inertia", v.inertia, "", "factor of rotor and load together, drawn evenly by ratio", 0.01, 1e3);
  k("bus", v.bus, "", "factor of inverter.bus_v", 0.1, 3);
  k("resistance", v.resistance, "", "factor of motor.resistance_ohm", 0.1, 10);
  k("inductance", v.inductance, "", "factor of motor.inductance_h and mutual_h, or inductance_d_h and inductance_q_h", 0.1, 10);
  k("flux", v.flux, "", "factor of motor.flux_vs, so of K_e and of K_t", 0.1, 3);
  k("offset", v.offset, "", "factor of the file's greatest comparator offset, either sign; sinusoidal: of a hundredth of adc.current_a", 0, 20);
  k("noise", v.noise, "", "factor of sensors.comparator_noise_v; sinusoidal: of adc.current_noise_a", 0, 20);
  k("delay", v.delay, "", "six-step: factor of sensors.comparator_delay_s", 0, 20);
  k("spinning", v.spinning, "", "part of the runs in which the rotor turns when they begin", 0, 1);
  k("speed", v.speed, "", "of that rotor, parts of the set speed; negative is reverse", -3, 3);
  k("weight", v.weight, "", "share of this drive in a sweep over several", 0.001, 1000);

  section = "bounds";
  auto& w = s.bounds;
  k("current_a", w.current_a, "A", "most in any phase; default: what the current limit lets through, or shorted windings drive at a backward speed", 1e-3, 1e4);
  k("kick_deg", w.kick_deg, "deg", "most backwards from rest, electrical; default: a mechanical turn, two electrical ones at least", 1, 1e6);
  k("speed", w.speed, "", "most from rest, over the set speed; default: from the speed loop and the inertia, 1.1 at least", 1, 10);
  k("lock_s", w.lock_s, "s", "longest from `run` to the lock; default: from inertia, torque and load, 5 s at least", 1e-3, 1e3);

  section = "hardship";
  auto& h = s.hardship;
  k("unbalance", h.unbalance, "", "greatest torque of a weight about which the rotor swings, part of the torque of the rated current", 0, 2);
  k("wind", h.wind, "", "greatest speed of the wind on a fan, either way, part of the set speed", 0, 2);
  k("spring_hz", h.spring_hz, "Hz", "of a load behind a belt, with the rotor held; drawn evenly by ratio", 0.1, 1e4);
  k("cogging", h.cogging, "", "greatest cogging torque, part of the torque of the rated current", 0, 2);
  k("stiction", h.stiction, "", "greatest torque that holds at each standstill, likewise", 0, 2);
  k("breakaway", h.breakaway, "", "greatest torque that holds until the rotor has turned once, likewise", 0, 2);
  k("comparators", h.comparators, "", "factor of the drawn offsets, noise and delay of the comparators", 1, 20);

  section = "disturbance";
  auto& u = s.disturbance;
  k("load_step", u.load_step, "", "greatest load step, part of the torque of the rated current", 0, 5);
  k("load_rate", u.load_rate, "",
    "but at most a step that takes this part of the rotor's speed per commutation step: the loop learns "
    "of it once a step", 0, 1);
  k("set_speed", u.set_speed, "", "set speeds before and after a step, parts of scenario.speed_rpm", 0.05, 2);
  k("bus_dip", u.bus_dip, "", "deepest dip of the bus, part of its voltage", 0, 0.95);
  k("stuck_steps", u.stuck_steps, "", "most commutation steps for which a comparator is stuck", 1, 1000);
  k("demagnetisation_deg", u.demagnetisation_deg, "electrical degrees",
    "longest freewheeling of the commutated current", 0, 60);
  k("inertia_step", u.inertia_step, "", "greatest factor of the inertia, of a mass that is coupled in step while the drive runs", 1, 100);
}

}  // namespace steplock::design
