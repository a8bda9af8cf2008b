// The rules of design.hpp, one part of the drive each, and what they have in common.
//
//     start_rules.cpp   both starts: alignment and ramp, and the one that follows the rotor
//     speed_rules.cpp   speed control
//     design.cpp        all else, and their order: each takes what those before it have set
//
// Doc: docs/design.md   Test: tests/model/design/design_rules_test.cpp
#pragma once

#include "model/design/design.hpp"
#include "model/design/ramp_overshoot.hpp"

namespace steplock::design {

inline constexpr double kCorner = 1.5;  // of the default envelope: 1.2 / 0.8, of what is more to what is less than the file says

// Of a stalled current, A, through this resistance.
double duty_for(const Settings&, double current, double resistance);
// The acceleration, in steps/s^2, that the loop follows with an error of ten degrees at this frequency.
double followed(const LoopParameters&, double frequency);

// What words hold at most, for values that are worked out (config.cpp): of a frequency, steps/s, and of a ramp, steps/s^2.
double most_frequency(const LoopParameters&, double clock_hz);
double most_ramp(const LoopParameters&, double tick, double clock_hz);
inline constexpr double kMostSamples = 65535;  // of a time between comparator samples

void set_start(const Settings&, Design&);
void set_follower(const Settings&, Design&);
void set_speed(const Settings&, Design&);

// Speed control with this motor, in steps/s.
SpeedLoop speed_loop(const SpeedParameters&, const MotorConstants&, double bus_v, int pole_pairs);
// steps/s^2, with nothing against it.
double acceleration(const MotorConstants&, double current, int pole_pairs);

}  // namespace steplock::design
