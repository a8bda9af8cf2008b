// What a start may put a motor through until it runs: a start beyond one of these is a rough one.  The drive file
// declares them ([bounds]); what it does not name follows from the motor:
//
//     current_a  I = I_limit + hysteresis / 2 + 2 V / (2 (L - M)) t      t: the comparator's blanking and delay
//                times 1 + (V - 2 U) / (2 V - U), where that is more than 1: in the winding that goes on while the current
//                changes over between the others, the outgoing and the incoming one add up, and the shunt sees one of them.
//                U: back-EMF of two windings at hand-over; slower, the current ends before each step
//                or, of a rotor that turns backwards, through three shorted windings
//                I = K E / sqrt(R^2 + (w (L - M))^2)                      K = 1.02 + 0.98 exp(-3 R / (w (L - M))), IEC 60909
//                start by ramp: the first, and the second at the set speed, which an idle winding carries past the shunt
//                sinusoidal: the level of its over-current protection
//     speed      what the PI loop passes at the end of the worst ramp, and after the dip in which it meets the load, which the
//                duty at hand-over does not know (ramp_overshoot.hpp); at least 1.1.  The ramp has the slew's acceleration a,
//                or the limit's, whichever is less.
//                Sinusoidal: 1 + a / (w_n w_set), of a loop of natural frequency w_n that nothing damps.
//                Start that follows: nor less than sqrt(2 a_limit 180 degrees), what the limit's current makes of a light
//                rotor until three edges have told its direction
//     kick_deg   one mechanical turn, two electrical ones at least
//     lock_s     each attempt as long as half of the limit's torque, less the load, takes from the speed that the rotor
//                has backwards to hand-over; 5 s at least (sinusoidal: 5 s).  Infinite where that torque does not exceed the load
//
// The drive's words are those of the file; the motor may be another one, as in a sweep.
//
// Doc: docs/design.md   Test: tests/model/design/bounds_test.cpp
#pragma once

#include "model/design/design.hpp"

namespace steplock::design {

struct StartBounds {
  double current_a = 0;  // A, of any phase
  double kick_deg = 0;   // electrical, backwards from rest
  double speed = 0;      // of a rotor from rest, over the set speed
  double lock_s = 0;     // from `run`
};

StartBounds start_bounds(const Settings& file, const Settings& motor);
inline StartBounds start_bounds(const Settings& file) { return start_bounds(file, file); }

// A: of a whole run, which may end in a brake.
double current_bound(const Settings&);

// A, peak of a phase: three shorted windings at this speed, from the first instant on.
double shorted_current(const Settings& motor, double rpm);
// A: what the current limit lets through.
double limited_current(const Settings& motor);
// What a winding carries while the current changes over between the two others, over the limit; at least 1.
double changing_over(const Settings& motor, double rpm);

}  // namespace steplock::design
