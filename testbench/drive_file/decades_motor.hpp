// A motor of any size, drawn from a seed, as a drive file that says no more than it must: for the design library, whose defaults
// have to give a drive whatever the motor is.
//
//     bus, rated current, frequency, inertia   by ratio: 2 to 800 V, 0.1 to 1000 A, 100 to 1,000,000 electrical r/min, 0.1 g cm^2 to
//                                              10 kg m^2; pole pairs 1 to 21
//     rotor          anywhere, at rest
//     back-EMF       between two phases, its peak at set speed: 0.4 to 0.58 of the bus
//     copper loss    3 to 20 % of the power;   reactance 3 to 25 % of the bus at the rated current
//     friction       2 % of the rated torque;  limit 2 to 4 times the rated current, where bus and resistance can give that
//
// Drawn again where nobody could build it: a mechanical time constant out of 1 ms to 3 s, an electrical one beyond 50 ms, more than
// 200,000 r/min, less than 0.1 mohm or 0.1 uH, more than 1 H or 10 V s, or a limit below 1.2 times the rated current.  So it spans
// more than drawn_motor.hpp, whose motors are those of batteries and supplies in use.
//
// Doc: docs/design.md   Test: tests/testbench/decades_motor_test.cpp
#pragma once

#include <cstdint>
#include <string>

namespace steplock {

// The text of the drive file; the same for the same seed and index everywhere.
std::string decades_motor_file(std::uint64_t seed, std::uint64_t index);

// "decades_0007"
std::string decades_motor_name(std::uint64_t index);

}  // namespace steplock
