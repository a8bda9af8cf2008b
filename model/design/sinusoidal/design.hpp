// From a drive file's settings to what the sinusoidal drive's blocks are set to.
//
//     K_e       (L_q / T) (1 - exp(-bandwidth T))       e_c follows the EMF with this bandwidth
//     K_theta   angle_gain L_q / K_E                     the angle error falls by angle_gain per
//                                                        electrical radian turned, at any speed
//     K_SP      angle_gain / K_E,  K_SI = 10/s K_SP      the same of the voltage model
//     currents  kp = bandwidth L, ki = kp max(R / L, bandwidth / 6)
//     speed     kp = bandwidth J / (pole_pairs^2 K_E), ki = kp bandwidth / 5
//     pilot     p torque impulse / J times the way to the reverse: what a pulse turns the rotor; the
//               torque is the whole of a short pulse's current, and of a long one's, which lies
//               within 34 degrees of the magnet, the sine of that
//               bandwidth: the angle's error that a fifth of L_q makes under a current moves with that
//               current, and so the speed seen; what comes back through kp and filter is half at most
//     lock      above the speed that a fifth of R at the current's limit looks like at rest, by a tenth
//     slowest   K_E w T / L_q = half a step of the ADC: one radian of error just shows
//
// Doc: docs/sinusoidal.md   Test: tests/model/design/sinusoidal_rules_test.cpp
#pragma once

#include <string>
#include <vector>

#include "model/design/sinusoidal/parameters.hpp"

namespace steplock::design::sinusoidal {

struct Design {
  Parameters parameters;
  double emf_bandwidth = 0, current_bandwidth = 0, speed_bandwidth = 0;  // rad/s
  double current_step = 0;      // A, of the ADC
  double rated_torque = 0;      // N m
  double no_load_rpm = 0;       // at the end of the modulator's linear range
  double slowest_rpm = 0;       // the rule above
  double saliency = 0;          // (L_q - L_d) / (L_q + L_d)
};

Design design_drive(const Settings&);

// Full scale of the ADCs, A and V: the drive file's, or four times the rated current and half
// again the bus.
double current_range(const Settings&);
// A, phase peak that the speed regulator may ask for.
double current_limit(const Settings&);
double voltage_range(const Settings&);

// Electrical rad/s of a mechanical speed, and back.
double speed_of(const Settings&, double rpm);
double rpm_of(const Settings&, double rad_per_s);

// What makes no sense in a sinusoidal drive's settings: "section.key is ...; must be ...".
std::vector<std::string> problems(const Settings&);

}  // namespace steplock::design::sinusoidal
