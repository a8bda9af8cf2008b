// From a drive file's settings to what every block is set to, in SI units.
//
// What the file names is taken; the rest follows from the motor, the load and the loop:
//
//     K_e      mean line-to-line back-EMF of the two conducting phases, V per mechanical rad/s
//     duty     of a stalled current: (I R_loop + drop) / (V + drop), R_loop = 2 (R + R_on)
//     ramp     0.4 of what the start current can accelerate
//     f_a      hand-over: back-EMF ten times the comparators' doubt, and a loop that can follow the
//              start current's acceleration within 10 degrees
//     PI       a quarter of the loop's bandwidth at hand-over; speed slew that the loop follows
//
// Doc: docs/design.md   Test: tests/model/design/design_rules_test.cpp
#pragma once

#include <string>
#include <vector>

#include "model/design/loop_filter.hpp"
#include "model/design/parameters.hpp"
#include "model/design/settings.hpp"

namespace steplock::design {

// What the rules need to know of motor, load and bridge.
struct MotorConstants {
  double k_e = 0;      // V s/rad, mechanical; equals K_t in N m/A
  double r_loop = 0;   // ohm, two phases and two switches
  double inertia = 0;  // kg m^2, in total
  double tau_m = 0;    // s, J R / K_e^2
  double tau_e = 0;    // s, L / R
  double no_load = 0;  // rad/s, mechanical, bus voltage / K_e
};
MotorConstants motor_constants(const Settings&);

// Of hand-over's speed: a rotor that turns backwards faster is braked, and so is one that shall stop.
inline constexpr double kBrakedFrom = 1.25;

struct Design {
  Parameters parameters;
  MotorConstants motor;
  LoopSpecification specification;  // per second; as used
  Components components;            // per second; as used
  double k_l = 0;                   // per second
  double bandwidth = 0;             // rad/step; per step
  Margins continuous, sampled;      // of the open loop; sampled at hand-over speed
  double align_time_formula = 0;    // s, Eq. (22)
  double kappa = 0;                 // N m/rad, Eq. (19)
  double acceleration_time = 0;     // s, from stand-still to hand-over
  double hand_over_rpm = 0, ramp_rpm_s = 0, start_current = 0, align_current = 0;
  double rated_torque = 0;  // N m
};

// For the motor that is believed.
Design design_drive(const Settings&);

// Steps per second of a mechanical speed, and back.
double steps_per_second(const Settings&, double rpm);
double rpm_of(const Settings&, double steps_per_second);

// Empty if all is well; else one line per problem: "section.key is ...; must be ...".
std::vector<std::string> problems(const Settings&);

// The load step of the scenario: as named, else half the torque of the rated current.
double load_step_torque(const Settings&);

// s, from a switch-on to the gate's answer: so long the current limit's comparator is not believed, or not heard.
double unbelieved(const Settings&);

// s: a quarter of the off-time, with all gates off, is to undo what that time did.
double least_off_time(const Settings&);

}  // namespace steplock::design
