// What a running drive meets in the disturbance matrix: one disturbance, drawn by the run's seed from
// what the drive file's [disturbance] allows.
//
//     kind              size                              duration
//     load_step         part of the rated torque          for good; at most what takes `load_rate` of
//                                                         the rotor's speed per commutation step
//     load_pulse        part of the rated torque          2 to 100 electrical turns: step and release
//     set_speed         new speed over the file's         for good
//     bus_dip           part of the source's voltage      1 to 200 ms
//     stuck_steps       commutation steps                 one comparator keeps its level for them
//     stuck_for_good    0 or 1: the level                 one comparator
//     missing_crossing  0 or 1: the level                 the floating phase's comparator, one step
//     extra_crossing    part of a step                    the same one, inverted; anywhere in the step
//     open_phase        winding 0, 1, 2                   its contact opens for good
//     demagnetisation   electrical degrees aimed at       a load step with the inductance that makes
//                                                         the commutated current flow for so long
//     inertia           factor                            a mass that turns along is coupled for good, and the
//                                                         host writes another set speed
//
// The set speed before it is drawn, too.  A comparator stuck for good and an open phase
// must end in the latched fault; after any other one the drive must be back in lock at set speed.
//
// Doc: docs/disturbances.md   Test: tests/testbench/disturbance_test.cpp
#pragma once

#include "testbench/run/timeline.hpp"
#include "testbench/sweep/conditions.hpp"

namespace steplock {

enum class Trouble {
  kLoadStep, kLoadPulse, kSetSpeed, kBusDip, kStuckSteps, kStuckForGood, kMissingCrossing,
  kExtraCrossing, kOpenPhase, kDemagnetisation, kInertia
};
inline constexpr int kTroubles = 11;
const char* name_of(Trouble);
// Nothing can mend it: the only right end is the latched fault.
constexpr bool for_good(Trouble t) {
  return t == Trouble::kStuckForGood || t == Trouble::kOpenPhase;
}

struct Disturbance {
  Trouble kind = Trouble::kLoadStep;
  double size = 0;         // as above
  double duration_s = 0;   // 0: for good, or by steps
  double set_speed = 1;    // before it, part of the file's
  double steps_per_s = 0;  // commutation steps, of the set speed after it
  double wait_turns = 0;   // electrical, from a settled start to it
  double place = 0;        // part of a step; inertia: where in the file's set speeds the new one lies
  int phase = 0;           // of the comparator
};

Disturbance draw_disturbance(const design::Settings& file, const Conditions&, RunSeed);

// The inductance factor with which a demagnetisation takes its size, electrical degrees.
double inductance_for(const design::Settings& under, const Disturbance&);

// The set speed in steps/s after it.
double speed_after(const design::Settings& file, const Disturbance&);
// Adds it to a timeline that has come to `clock`, and to the pins; returns the clock at which it begins.
// `file` gives rated torque and speed, `under` the bus.
std::uint64_t add_disturbance(Timeline&, std::vector<PinFault>& faults, const Disturbance&,
                              const design::Settings& file, const design::Settings& under,
                              std::uint64_t clock);

}  // namespace steplock
