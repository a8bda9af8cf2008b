// A plausible motor and what turns with it, drawn from a seed, as a drive file: for sweeps over motors that no file of this
// project knows.  What a builder chooses is drawn, by ratio where it spans decades; the rest follows from it.
//
//     power P          3 W to 3 kW
//     bus V            of the batteries and supplies in use, so that P takes 0.3 to 80 A
//     frequency f      electrical, at set speed: 50 to 700 Hz
//     pole pairs       1 to 21, so that 60 f / pairs is 100 to 50,000 r/min
//     back-EMF         between two phases, its peak at set speed: 0.4 to 0.58 of V, so that 1.2 times the flux at 0.8
//                      times the bus still reach it                                       flux = that / (sqrt(3) 2 pi f)
//     rated current    P over that
//     copper loss      3 to 20 % of P                                                    R = loss / (2 I^2)
//     reactance        2 pi f 2 L I: 3 to 25 % of V                                      L
//     inertia          mechanical time constant 3 to 60 ms; of the load 0 to 4 times the rotor's
//     friction, fan    1 to 4 % and 0 to 50 % of the rated torque, at set speed
//     current limit    2 to 4 times the rated current, where bus and resistance can give that
//
// Plausible, not real: no two values that a builder could not put together, and no more.
//
// Doc: docs/sweep.md   Test: tests/testbench/drawn_motor_test.cpp
#pragma once

#include <cstdint>
#include <string>

namespace steplock {

// The text of the drive file; the same for the same seed and index everywhere.
std::string drawn_motor_file(std::uint64_t seed, std::uint64_t index);

// "motor_0007"
std::string drawn_motor_name(std::uint64_t index);

}  // namespace steplock
