// Watches a run of the disturbance matrix from outside, by the rotor's true angle: first its start, as
// any start (witness.hpp), then what becomes of it after the disturbance.
//
//     in step     the drive claims a lock, each commutation of the last electrical turn was within 60
//                 degrees of its place, and the drive's speed is the rotor's (within a quarter)
//     well        in step, and the turn's mean speed within StartJudge::kAtSpeed of the set speed
//     recovered   well for held_turns turns on end, the disturbance over; a fault for good: still well
//                 when the time is over
//     latched     the fault is latched
//     silent_step_out   not in step for kNoticeTime, and the drive claims a lock all that time
//     unfinished  none of these when the time was over
//     not_started       it never came to the disturbance
//
// A rotor that was torn away by whole turns and is in step again has recovered: `slips` tells.  The
// recovery time goes from the disturbance to the end of the last turn that was not well, 0 if there
// was none; one turn is its resolution.
//
// Demagnetisation is looked at every degree: how long the phase that a commutation switched off went on
// carrying current.
//
// Doc: docs/disturbances.md   Test: tests/testbench/aftermath_test.cpp
#pragma once

#include "testbench/sweep/disturbance.hpp"
#include "testbench/sweep/witness.hpp"

namespace steplock {

enum class After { kRecovered, kLatched, kSilentStepOut, kUnfinished, kNotStarted };
inline constexpr int kAfters = 5;
const char* name_of(After);

// A drive recovers from what passes, and latches what does not.
constexpr bool ends_well(Trouble kind, After outcome) {
  return outcome == (for_good(kind) ? After::kLatched : After::kRecovered);
}

struct AfterFindings {
  After outcome = After::kNotStarted;
  Reason reason = Reason::kNone;       // of the latched fault, or of the last failed try
  double disturbed_s = 0;              // when it began
  std::optional<double> recovery_s;    // from then, if it recovered
  std::optional<double> lost_s;        // from then to the first loss of lock, which switches the gates off
  std::optional<double> fault_s;       // from then, if it latched
  double dip = 0;                      // farthest a turn's mean speed lay below the set speed: its part
  double peak_current_a = 0;           // from then on
  double demagnetisation_deg = 0;      // the longest from then on, if it is looked at
  int retries = 0, lost_locks = 0;     // from then on
  std::uint64_t slips = 0;
  double end_s = 0;
};

struct Disturbed {
  double from_s = 0, until_s = 0;  // equal for a step
  double set_rpm = 0;              // after it, signed
  bool for_good = false;           // nothing mends it: no early verdict of recovery
  bool look_at_freewheeling = false;
};

class Aftermath {
 public:
  explicit Aftermath(const WitnessSettings&, Recorder* recorder = nullptr);

  // As a Recorder's.
  void changed(const plant::State&, Watch was, Watch now, const DriveView&, double load_nm);
  void sample(const plant::State&, Watch, const DriveView&, double load_nm);
  double next_sample() const;
  bool tracing() const { return start_.tracing(); }
  void pins_changed(double time, const plant::Pins& p) { start_.pins_changed(time, p); }

  bool start_decided() const { return start_.decided(); }
  const Findings& start() const { return start_.findings(); }
  void disturb(const Disturbed&);  // from now on
  bool decided() const { return decided_; }
  void time_is_over();             // at the limit
  const AfterFindings& findings() const { return findings_; }

 private:
  struct Mark {
    double time, angle;
  };
  void look(const plant::State&);
  void watch_freewheeling(const plant::State&, bool commutated, int from, int to);
  void turn(double time, double angle, const DriveView&);
  bool disturbed(double time) const { return disturbance_ && time >= disturbance_->from_s; }

  WitnessSettings settings_;
  Witness start_;
  Judge judge_;
  std::optional<Disturbed> disturbance_;
  AfterFindings findings_;
  bool decided_ = false, claims_ = true, astray_ = false;
  State state_ = State::kRun;
  double next_look_ = 0, next_fine_ = 1e9;
  std::optional<Mark> mark_;
  double last_unwell_ = 0;
  std::optional<double> silent_since_;
  // The phase that was switched off, and the angle at which.
  int freewheels_ = -1;
  double freewheels_from_ = 0;
};

}  // namespace steplock
