// What one run of a sweep meets: motor, load, bus, comparators or ADCs, and rotor, drawn from the
// drive file's envelope by the run's seed alone.  The drive's words stay those of the file: it does not know.
//
// Outside the envelope one quantity, drawn too, lies beyond its range by the factors of kBeyond; the
// others stay within.
//
// Doc: docs/sweep.md   Test: tests/testbench/conditions_test.cpp
#pragma once

#include "model/design/settings.hpp"
#include "testbench/sweep/seed.hpp"

namespace steplock {

struct Conditions {
  double angle_deg = 0;       // electrical, of the rotor at t = 0
  double load = 0;            // dry, part of the torque of the rated current
  double fan = 0;             // part of that torque, at set speed
  double inertia = 1, bus = 1, resistance = 1, inductance = 1, flux = 1;  // factors
  double offset_u_v = 0, offset_v_v = 0, offset_w_v = 0;                  // of the comparators
  double noise_v = 0, delay_s = 0;                                        // of all three
  double offset_u_a = 0, offset_v_a = 0, offset_w_a = 0, noise_a = 0;     // of the current ADCs
  double speed = 0;           // of the rotor at t = 0, part of the set speed
};

// N m, of the current that the file rates.
double rated_torque(const design::Settings&);

// The half of an envelope next to the drive file's own values, from rest: where starts are no question,
// and a disturbance finds all kinds of motors.
design::EnvelopeSection milder(const design::EnvelopeSection&);

Conditions draw_conditions(const design::Settings&, RunSeed);

// The file's settings with these conditions in place of its own, and a scenario of a start alone.
design::Settings settings_under(const design::Settings&, const Conditions&, RunSeed);

}  // namespace steplock
