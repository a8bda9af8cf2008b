// What a start meets beyond the envelope in `sweep --matrix hard`: one hardship, drawn by the run's seed from what the
// drive file's [hardship] allows, on top of the motor and load that the envelope gives.
//
//     kind         size                          the physics
//     swing        torque, part of the rated one  a weight on one side (a crank, a drum): the rotor swings about the
//                                                 place where it hangs, with an amplitude of 30 to 150 degrees
//     wind         speed, part of the set one     a fan in moving air, either way: it turns as fast as its friction lets
//                                                 it, and pulls when it is stopped
//     spring       Hz                             a belt: at least half of the inertia behind a spring, damped by 2 %
//     cogging      torque, part of the rated one  6 or 12 detents per electrical turn: teeth against magnets
//     stiction     torque, part of the rated one  at each standstill: seals, dry bearings
//     breakaway    torque, part of the rated one  once, until the rotor has turned: a frozen pump, a stuck lid
//     comparators  factor                         of offsets, noise and delay at once: another comparator, long wires
//
// (Inertia that changes while the drive runs is a disturbance: disturbance.hpp.)
//
// Doc: docs/sweep.md   Test: tests/testbench/hardship_test.cpp
#pragma once

#include "testbench/sweep/conditions.hpp"

namespace steplock {

enum class Trial { kSwing, kWind, kSpring, kCogging, kStiction, kBreakaway, kComparators };
inline constexpr int kTrials = 7;
const char* name_of(Trial);

struct Hardship {
  Trial kind = Trial::kSwing;
  double size = 0;     // as above
  double detail = 0;   // swing: radians from where it hangs, mechanical; cogging: detents per mechanical turn
  double speed = 0;    // swing: of the rotor, part of the greatest at that angle
};

Hardship draw_hardship(const design::Settings& file, RunSeed);

// Of the conditions: a fan for the wind, no dry load that would hold what is to swing, other comparators.
void choose_load(Conditions&, const Hardship&, const design::Settings& file);
// Of the plant, and how its rotor turns when the run begins.
void meet(design::Settings& under, const Hardship&, const design::Settings& file);

}  // namespace steplock
