// What the sinusoidal drive's blocks are set to, in SI units: all that its reference in doubles knows.
//
// Vectors have Matsui's power-invariant length, Eq. (3): sqrt(3/2) times the phase's peak.  Speeds
// and angles are electrical unless a name says otherwise.
//
//     K_E = sqrt(3/2) flux  V s/rad        torque = pole_pairs K_E i_delta        L = (3/2) L_a
//
// Doc: docs/sinusoidal.md   Test: tests/model/design/sinusoidal_rules_test.cpp
#pragma once

#include "model/design/settings.hpp"

namespace steplock::design::sinusoidal {

// The motor as the drive believes it to be.
struct Motor {
  double resistance = 0;                      // ohm, phase and switch
  double inductance_d = 0, inductance_q = 0;  // H
  double k_e = 0;                             // V s/rad
  int pole_pairs = 1;
};

struct Pwm {
  double period = 0, dead_time = 0;  // s; one sample per period
  double minimum = 0;                // s, shorter on or off times become 0 % or 100 %
  Modulation modulation = Modulation::kSpaceVector;
};

// The voltage that the bridge makes of a duty.
struct Applied {
  double period = 0, dead_time = 0;  // s
  double diode_drop = 0;             // V; 0: not known to the drive, as in the paper
  double small_current = 0;          // A, below it the effect of dead time is taken in proportion
  bool compensate = true;            // the duty makes up for dead time
};

struct VoltageModel {  // Eqs. (6)-(11)
  double k_sp = 0;  // rad/s per V
  double k_si = 0;  // rad/s^2 per V
  int samples = 8;  // of the moving average; 1 is none
};

struct CurrentModel {  // Eqs. (12)-(20)
  double k_e = 0;      // V/A
  double k_theta = 0;  // rad/A
};

struct CurrentRegulator {
  double kp_gamma = 0, kp_delta = 0;  // V/A
  double ki_gamma = 0, ki_delta = 0;  // V/(A s)
  double i_gamma = 0;                 // A, set-point
};

struct SpeedRegulator {
  double target = 0;  // rad/s
  double slew = 0;    // rad/s^2
  double filter = 0;  // rad/s, of the speed that it sees
  double kp = 0;      // A/(rad/s)
  double ki = 0;      // A/rad
  double limit = 0;   // A
  double start_current = 0;  // A, where the integral begins
};

struct Pilot {
  double short_s = 0, long_s = 0;     // s, lengths of a pulse
  double decayed = 0, decay_s = 0;    // A, below it a pulse is over; longest wait for it
  int repeats = 1;                    // rounds of short pulses that are averaged
  double least_saliency = 0;          // of the mean peak; less is no position
  double least_polarity = 0;          // of the two long peaks' sum; less is no polarity
  double amperes_per_second = 0;      // of a winding against the two others, mean over the rotor
  double turned = 0;                  // rad, by a pulse before its reverse, at most
};

struct Start {
  StartBy by = StartBy::kPattern;
  int offset_samples = 16;                       // with gates off, for the ADCs' offsets
  double pattern_s = 0, pattern_current = 0;     // s; A, phase peak
  double lock_speed = 0;                         // rad/s, above it the estimator is trusted
  double lock_s = 0;                             // for so long
  double give_up_s = 0;                          // no lock in this time is a failed attempt
  double stop_speed = 0;                         // rad/s, below it the drive lets go
  double brake_s = 0, retry_delay_s = 0;                // s
  int retries = 0;
};

struct Protection {
  double over_current = 0;                // A, any phase
  double saturated_s = 0;                 // s, a regulator at its limit for so long; 0: no test
  double slow_speed = 0, slow_s = 0;      // rad/s: too slow for the estimator for so long
  double emf_low = 0, emf_high = 0;       // measured EMF over K_E speed
  double emf_speed = 0, emf_s = 0;        // rad/s, above it; s, outside of these for so long
  int lost_samples = 0;                   // in a row
};

struct Parameters {
  Motor motor;
  Pwm pwm;
  Applied applied;
  Estimator estimator = Estimator::kCurrent;
  VoltageModel voltage_model;
  CurrentModel current_model;
  CurrentRegulator current;
  SpeedRegulator speed;
  Pilot pilot;
  Start start;
  Protection protection;
};

}  // namespace steplock::design::sinusoidal
