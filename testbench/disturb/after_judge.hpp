// What becomes of a running drive after a disturbance, told from the rotor's true angle and from what the drive claims: the part of an
// aftermath that is the same for every kind of drive.  Outcomes are those of sweep/aftermath.hpp:
//
//     in step     the drive claims a lock, did not go astray in the last electrical turn, and its speed is the rotor's
//     well        in step, and the turn's mean speed within StartJudge::kAtSpeed of the set speed
//     recovered   well for held_turns turns on end, the disturbance over
//     silent_step_out   not in step for StartJudge::kNoticeTime, and the drive claims a lock all that time
//
// The six-step Aftermath holds the same inside itself, since its text is part of the seed of the published starts (tools/starts); it comes
// here when they are drawn anew.
//
// Doc: docs/sweep.md   Test: tests/testbench/sinusoidal_disturbance_test.cpp
#pragma once

#include <cstdint>
#include <optional>

#include "testbench/sweep/aftermath.hpp"

namespace steplock {

class AfterJudge {
 public:
  explicit AfterJudge(const WitnessSettings& settings) : settings_(settings) {}

  void disturb(const Disturbed&);
  bool disturbed(double time) const { return disturbance_ && time >= disturbance_->from_s; }
  bool watches(double time) const { return disturbed(time) && !decided_; }

  // While it watches: at every gate edge, where the current of a chopped motor has its peaks.
  void look(const plant::State&);
  void claims(bool lock) { claims_ = claims_ && lock; }                 // at each change
  void failed(bool claimed_lock, bool for_good, double time);           // an attempt
  void strayed(bool first);                                             // `first`: it was not astray before
  // Once per electrical turn of set speed, from next_look() on.  `drive_rpm`: as StartJudge::turn's.
  void turn(const plant::State&, double drive_rpm, bool claims_now);
  double next_look() const { return decided_ ? kNever : next_look_; }

  bool decided() const { return decided_; }
  void time_is_over();  // at the limit
  const AfterFindings& findings() const { return findings_; }

 private:
  struct Mark {
    double time, angle;  // angle electrical, rad
  };
  void recovered();

  static constexpr double kNever = 1e9;  // s

  WitnessSettings settings_;
  std::optional<Disturbed> disturbance_;
  AfterFindings findings_;
  bool decided_ = false, claims_ = true, astray_ = false;
  double next_look_ = kNever, last_unwell_ = 0;
  std::optional<Mark> mark_;
  std::optional<double> silent_since_;
};

}  // namespace steplock
