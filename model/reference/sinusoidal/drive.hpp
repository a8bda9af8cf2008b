// Matsui's sensorless sinusoidal drive in doubles: the reference that a fixed-point drive is held
// against.  Written from the equations; in continuous time between its samples.
//
//     sample -> Clarke -> estimator -> speed regulator -> current regulators -> modulator -> next period
//                ^ applied voltage, from pattern, dc voltage and dead time
//
// One sample per PWM period, at its start; what is computed from it becomes the duty of the period
// after, so the voltage acts 1 to 2 periods after the sample, and is turned ahead by 1.5 of them.
//
// Use:    t = min(drive.next_event(), ...);  out = drive.update(t, pins, command);
//         if (out.sample) { take currents and bus voltage now; hand them over in a later update }
//
// Doc: docs/sinusoidal.md   Test: tests/model/reference/sinusoidal/
#pragma once

#include "model/reference/commutation.hpp"
#include "model/reference/sinusoidal/applied_voltage.hpp"
#include "model/reference/sinusoidal/current_model.hpp"
#include "model/reference/sinusoidal/modulator.hpp"
#include "model/reference/sinusoidal/pilot.hpp"
#include "model/reference/sinusoidal/protection.hpp"
#include "model/reference/sinusoidal/regulators.hpp"

namespace steplock::reference::sinusoidal {

class Drive {
 public:
  explicit Drive(const design::sinusoidal::Parameters&);

  double next_event() const { return next_; }
  Output update(double t, const Pins&, const Command&);

  // The speed may be set at any time; its sign is the command's.
  void set_target(double rad_per_s) { target_ = rad_per_s; }

 private:
  void take(double t, const Reading&);
  void sequence(double t, const Command&);
  void enter(double t, State);
  void begin_start(double t);
  void fail(double t, Reason);
  void control(const Phases& current, double v_dc);
  void hold_pattern(double t);
  bool estimating() const {
    return state_ == State::kStarting || state_ == State::kRun || state_ == State::kSlowDown;
  }
  const Estimate& estimate() const {
    return p_.estimator == design::Estimator::kCurrent ? current_model_.estimate()
                                                       : voltage_model_.estimate();
  }
  Gates wanted(double t) const;

  design::sinusoidal::Parameters p_;
  CentredPwm pwm_;
  AppliedVoltage applied_;
  VoltageModelEstimator voltage_model_;
  CurrentModelEstimator current_model_;
  CurrentRegulator current_regulator_;
  SpeedRegulator speed_;
  PilotPulses pilot_;
  Protection protection_;
  GateGuard guard_;

  State state_ = State::kIdle;
  Reason reason_ = Reason::kNone;
  double target_, next_ = 0, entered_ = 0, trusted_ = 0;
  int way_ = 1, tries_ = 0, calibrated_ = 0, peaks_due_ = 0;
  bool awaited_ = false, sampling_ = false, regulated_ = false;
  int modulated_ = 0;  // periods begun under the regulators
  double v_dc_ = 0, pilot_angle_ = 0;
  Phases offset_ = {}, summed_ = {}, ended_duty_ = {}, current_ = {};
  Vector in_frame_;
  double wanted_delta_ = 0;
};

}  // namespace steplock::reference::sinusoidal
