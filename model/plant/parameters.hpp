// What the plant is made of: motor, load, bus, bridge, comparators, Halls.  Plain numbers in SI
// units; every default is a usable value (a 24 V servo of 4 pole pairs), so a caller names only
// what differs.
//
// Star-connected motor, phase quantities, peak values.  Phase u, v, w are index 0, 1, 2.
//
//     v_k - v_n = R i_k + (L - M) i_k' + e_k          sum of i_k = 0
//     e_k       = flux * w_e * shape(theta_e - 120 deg * k)         w_e = pole_pairs * w
//
// validate() names every value that makes no sense, one readable line each.
//
// Doc: docs/plant.md   Test: tests/model/plant/parameters_test.cpp
#pragma once

#include <array>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

namespace steplock::plant {

struct BackEmfShape {
  enum class Kind { kTrapezoidal, kSinusoidal, kTable };
  Kind kind = Kind::kTrapezoidal;
  double flat_top_deg = 120;    // trapezoid: width of each flat top, electrical degrees, [0, 175]
  bool rounded_flanks = false;  // trapezoid: cubic flanks that meet the tops without a corner
  // kTable: one electrical turn in equal steps from theta = 0, at least 8 values, normally of
  // peak 1; a periodic cubic spline runs through them.
  std::vector<double> table = {};
};

struct Motor {
  double resistance = 0.382;                       // ohm, per phase, > 0
  double inductance = 188e-6;                      // H, self-inductance L of a phase
  double mutual = 0;                               // H, M (usually negative); L - M > 0
  // A salient rotor (sinusoidal shape only): 0 stands for L - M, the round one.
  double inductance_d = 0, inductance_q = 0;  // H, along the magnet and across it, >= 0
  double saturation = 0;                      // of L_d along the magnet: see salient.hpp, [0, 0.9]
  double saturation_current = 1;              // A, where 71 % of it has come about, > 0
  double flux = 0.03966 / (2 * std::numbers::pi);  // V s/rad, peak, per electrical rad/s, >= 0
  int pole_pairs = 4;                              // 1 .. 100
  BackEmfShape shape = {};
  double inertia = 7.06e-6;   // kg m^2, rotor, > 0
  double cogging_torque = 0;  // N m, amplitude: torque = -amplitude sin(periods * angle + phase)
  int cogging_periods = 24;   // per mechanical turn, >= 1
  double cogging_phase = 0;   // rad
  double coulomb_friction = 1e-3;  // N m, dry friction while turning, >= 0
  double static_friction = 1e-3;   // N m, breakaway torque at rest, >= coulomb_friction
  double viscous_friction = 0;     // N m s/rad, >= 0
  double fan_friction = 0;         // N m s^2/rad^2: torque = -fan_friction w |w|, >= 0
};

struct Load {
  double inertia = 0;          // kg m^2, rigidly coupled unless behind a spring, >= 0
  double opposing_torque = 0;  // N m, always against the motion, holds at rest like a brake, >= 0
  double active_torque = 0;    // N m, pulls towards negative speed whatever the speed (a weight)
  double breakaway_torque = 0;  // N m, holds at rest beyond friction until the rotor has turned once, >= 0
  double unbalance_torque = 0;  // N m, amplitude: torque = -amplitude sin(angle - unbalance_angle), >= 0
  double unbalance_angle = 0;   // rad, mechanical, where the weight hangs
  double wind_speed = 0;        // rad/s: the fan at this speed takes no torque
  double spring_stiffness = 0;  // N m/rad, between rotor and load (its inertia and fan); 0 couples them rigidly
  double spring_damping = 0;    // N m s/rad, of the spring, >= 0
};

struct Bus {
  double voltage = 24;          // V, of the source behind its resistance, > 0
  double resistance = 0.05;     // ohm; 0 makes a stiff bus, whose voltage never moves
  double capacitance = 470e-6;  // F, at the bridge; > 0 unless the bus is stiff
  bool sinks = true;            // false: a supply that takes no current back; needs resistance > 0
};

struct Bridge {
  double on_resistance = 0.01;      // ohm, channel of a switch, either direction, >= 0
  double diode_drop = 0.55;         // V, forward drop of a body diode, > 0
  double diode_resistance = 0.005;  // ohm, slope of the body diode, >= 0
};

// One analog comparator, output high when its input exceeds `offset`, with `hysteresis` split
// evenly around it.  Noise is white, held for `noise_interval` (bandwidth 1/2 of its inverse) and
// drawn from (seed, comparator, number of the interval): it does not depend on how the run is cut
// into steps.
struct Comparator {
  double offset = 0;             // V (A for the current limit)
  double hysteresis = 0.01;      // V (A), full width, >= 0
  double delay = 100e-9;         // s, transport delay to the pin, >= 0
  double noise = 0;              // V (A), standard deviation, >= 0
  double noise_interval = 1e-6;  // s, > 0
};

struct Sensing {
  enum class Reference {
    kVirtualNeutral,  // mean of the three terminals (three equal resistors)
    kHalfBus,         // half the bus voltage
    kStarPoint,       // the motor's own star point, brought out
  };
  Reference reference = Reference::kVirtualNeutral;
  std::array<Comparator, 3> comparator = {};
  // Common shunt under the three low-side sources: its current is what returns from the bridge to
  // ground, so a current that freewheels through two low sides does not show in it.
  double limit_threshold = 10;  // A, > 0; Comparator::offset is added to it
  Comparator limit = {.hysteresis = 0.1, .delay = 100e-9};
  std::array<double, 3> hall_error_deg = {};  // electrical degrees, late if positive, |error| < 30
  double hall_delay = 0;                      // s, >= 0
  std::uint64_t seed = 1;                     // of all noise
};

struct Accuracy {
  double tolerance = 1e-8;   // relative, per integration step, [1e-12, 1e-3]
  double max_step = 100e-6;  // s, longest step and farthest horizon of next_event(), (0, 1]
};

struct Parameters {
  Motor motor = {};
  Load load = {};
  Bus bus = {};
  Bridge bridge = {};
  Sensing sensing = {};
  Accuracy accuracy = {};
};

// Empty if all is well; else one line per problem: "motor.resistance is 0 ohm; must be above 0".
std::vector<std::string> validate(const Parameters&);

}  // namespace steplock::plant
