// The six-step drive in doubles and continuous time: the reference that the fixed-point drive is
// held against.  Written from the equations; event-driven: nothing changes between two updates.
//
//     pins -> comparator logic -> phase detector -> loop filter -> VCO -> commutation -> guard
//     PWM, current limit -> chop;  frequency -> speed control -> duty;  start sequence above all
//
// Use:    double t = 0;
//         while (t < end) {
//           t = min(drive.next_event(), plant.next_event(), next command);
//           plant.advance_to(t);
//           out = drive.update(t, pins, command);
//           if (out.gates changed) plant.set_gates(out.gates), and update again if pins changed
//         }
//
// update() may be called at any time up to next_event(); a later time is an error of the caller.
//
// Doc: docs/theory.md   Test: tests/model/reference/
#pragma once

#include <optional>

#include "model/reference/bemf.hpp"
#include "model/reference/oscillator.hpp"
#include "model/reference/phase_locked_loop.hpp"
#include "model/reference/protection.hpp"
#include "model/reference/rotor_follower.hpp"
#include "model/reference/sector_decoder.hpp"
#include "model/reference/speed_control.hpp"
#include "model/reference/start_sequence.hpp"

namespace steplock::reference {

class Drive {
 public:
  explicit Drive(const design::Parameters&);

  double next_event() const { return next_; }
  // `bridge`: what it does, if another drive holds it and this one only looks on.
  Output update(double t, const Pins&, const Command&, const std::optional<Bridge>& bridge = {});

  // Where another drive stands that is locked.
  struct Joined {
    int step = 0;
    double step_phase = 0, phase_error = 0;  // turns of a step
    double frequency = 0, reference = 0;     // steps/s; the slewed set speed
    double duty = 0;
    bool reverse = false;
  };
  // Be there too, from t on, as if it had been so for long.
  void join(double t, const Joined&);

  // The speed may be set at any time.
  void set_target(double steps_per_second) { target_ = steps_per_second; }
  const StartSequence& sequence() const { return sequence_; }

 private:
  void enter_state(double t);
  void detect_spin(double t, bool to_be_followed);
  void follow_halls(double t);
  void follow_rotor(double t, const Pins&);
  void on_tick(double t);
  bool follows() const { return p_.start.method == design::Method::kFollow; }
  bool following() const { return follows() && sequence_.state() == State::kAccelerate; }
  // Of a followed rotor with hand-over's frequency: a sixteenth of the start's duty, a quarter once it fell back,
  // but for the first interval that was measured.
  double part_of(double duty) const { return fell_ ? duty / 4 : duty / 16; }
  double stronger(double duty) const { return sequence_.retries() > 1 && !follows() ? 2 * duty : duty; }
  Mode mode() const;
  bool commutating() const;  // steps are applied
  bool loop_closed() const;

  design::Parameters p_;
  Pwm pwm_;
  CurrentLimit limit_;
  Oscillator vco_;
  Bemf bemf_;
  PhaseDetector detector_;
  LoopFilter filter_;
  SpeedControl speed_;
  StartSequence sequence_;
  Protection protection_;
  SectorDecoder decoder_;
  RotorFollower follower_;
  GateGuard guard_;

  double target_, next_ = 0;
  double boost_ = 0;          // duty above the back-EMF's while starting
  double changed_ = 0;        // when the decoder's sector last changed
  int steady_ = 0, way_ = 0;  // changes in a row with a steady period, and their direction
  int caught_ = 0;
  bool limited_ = false, ramp_done_ = false;
  bool good_interval_ = false, measured_ = false, holds_ = false, boosted_ = false;
  bool was_fast_ = false, fell_ = false;  // the followed rotor had hand-over's frequency; and less since
  bool eases_ = false;                    // in the present step
  int fast_steps_ = 0;                    // that began with hand-over's frequency, in a row
  double overdue_ = kNever;   // when the rotor that is followed should have passed an edge, and a quarter more
};

}  // namespace steplock::reference
