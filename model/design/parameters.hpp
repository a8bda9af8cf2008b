// What the drive's blocks are set to, in SI units: the design library's result before it becomes
// words, and all that the floating-point reference drive knows.
//
// Members carry the names of the register words (config.hpp).  A step is one commutation interval of
// 60 electrical degrees.  Frequencies are steps per second, phases turns of one step, duties
// fractions of the PWM period, durations seconds.
//
// Doc: docs/design.md   Test: tests/model/design/config_test.cpp
#pragma once

#include "model/design/settings.hpp"

namespace steplock::design {

struct PwmParameters {
  double period = 0, minimum = 0, dead_time = 0;  // s
  bool centred = false, complementary = false;
  int tick_periods = 1;
  double tick() const { return period * tick_periods; }  // s
};

struct LimitParameters {
  double blanking = 0, off_time = 0;  // s; off_time 0 disables
};

struct BemfParameters {
  Sampling sampling = Sampling::kBoth;
  double blanking = 0, sample_every = 0;  // s
  int samples = 1;
};

// Per second, the filter is the paper's: a current gain * error into C1 parallel to (R + C2), whose
// voltage is the frequency.  In one equation, with e in turns of a step and f in steps/s,
//     f / e = (integral / s + proportional) / (1 + s / pole)
// Per step, at each crossing:  x += integral * e * f;  f = x + proportional * e * f, low-passed
// by `pole` (1 - exp(-omega_p), 1 is no pole).
struct LoopParameters {
  Detector detector = Detector::kEveryStep;
  LoopForm form = LoopForm::kPerStep;
  int divide = 0;
  double expected = 0.5, lead_error = 0.25;  // turns of a step
  double delay = 0;                          // s, of the sensors, before the drive's pins
  double integral = 0;                       // 1/s^2, or 1 per step
  double proportional = 0;                   // 1/s, or 1 per step
  double pole = 1;                           // rad/s, or fraction per step
  double minimum = 0, maximum = 0;           // steps/s
};

struct StartParameters {
  Method method = Method::kRamp;
  double pre_align = 0, align = 0;  // s
  double align_duty = 0, start_duty = 0;  // kFollow: until the rotor is followed, and then
  double ramp = 0;       // steps/s^2
  double look = 0, probe = 0;  // s
  int still = 0;               // looks
  double hand_over = 0;  // steps/s
  double window = 0;     // turns of a step
  int good_crossings = 1;
  double pull_in = 0, detect_spin = 0, slow_down = 0, brake = 0;  // s
  double brake_duty = 0;  // from which the back-EMF's is taken
  double retry_delay = 0;  // s
  int retries = 0;
};

struct SpeedParameters {
  double target = 0;  // steps/s
  double slew = 0;    // steps/s^2
  double kp = 0;      // duty per (step/s)
  double ki = 0;      // duty per (step/s) per s
  double bemf = 0;    // duty per (step/s), of the back-EMF
  double loaded = 0;  // duty per (step/s), of the greatest back-EMF and commutation of the limit's current at the lowest bus
  double minimum = 0, maximum = 1;
  double duty_slew = 0;  // 1/s
};

struct ProtectionParameters {
  int misses = 0;
  double stall = 0;       // steps/s
  double slip = 0;        // duty
  double freewheel = 0;   // turns of a step
  double wrong_lock = 0;  // s; 0 disables
  int over_current = 0;
};

struct Parameters {
  PwmParameters pwm;
  LimitParameters limit;
  BemfParameters bemf;
  LoopParameters loop;
  StartParameters start;
  SpeedParameters speed;
  ProtectionParameters protection;
  Source source = Source::kBemf;
};

}  // namespace steplock::design
