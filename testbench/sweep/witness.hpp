// Watches one run of a sweep from outside, by the rotor's true angle, and says when its outcome is
// clear.
//
//     started          locked, without a slipped step since, for kHeldTurns electrical turns (of the
//                      set speed), the last kAtSpeedTurns of them within kAtSpeed of the set speed
//     latched          the fault is latched
//     silent_step_out  a step slipped, or the rotor stands, or the drive's speed is not the rotor's (by
//                      a quarter), and kNoticeTime later the drive still claims that lock
//     unfinished       none of these when the time was over
//
// A slip that the drive notices ends the try, not the run: it may start again.
//
// It stands where a Recorder stands in the co-simulation, and passes everything on to one if there is
// one; that changes no number of its own.
//
// Doc: docs/sweep.md   Test: tests/testbench/witness_test.cpp
#pragma once

#include <deque>
#include <optional>

#include "testbench/run/recorder.hpp"

namespace steplock {

enum class Outcome { kStarted, kLatched, kSilentStepOut, kUnfinished };
const char* name_of(Outcome);

struct WitnessSettings {
  double run_s = 0;             // when `run` rises
  double set_rpm = 0;           // signed
  int pole_pairs = 1;
  double advance_deg = 0;
  bool at_rest = true;          // at t = 0: only then there is a kick
  double electrical_turn_s() const;
};

struct Findings {
  Outcome outcome = Outcome::kUnfinished;
  Reason reason = Reason::kNone;       // of the latched fault, or of the last failed try
  std::optional<double> lock_time_s;   // from `run` to the lock that held, or to the last one
  std::optional<double> speed_time_s;  // from `run` to set speed
  std::optional<double> kick_deg;      // electrical, backwards, from where the rotor stood
  double peak_current_a = 0;
  int retries = 0;                     // failed tries
  int lost_locks = 0;                  // of them, after a claim of lock
  std::uint64_t slips = 0;             // steps
  double end_s = 0;
};

class Witness {
 public:
  static constexpr double kHeldTurns = 24, kAtSpeed = 0.03, kNoticeTime = 0.5,
                          kOtherSpeed = 0.25, kStandStill = 0.01;

  static constexpr std::size_t kAtSpeedTurns = 6;

  explicit Witness(const WitnessSettings&, Recorder* recorder = nullptr);

  // As a Recorder's.
  void changed(const plant::State&, Watch was, Watch now, const DriveView&, double load_nm);
  void sample(const plant::State&, Watch, const DriveView&, double load_nm);
  double next_sample() const;
  bool tracing() const { return recorder_ != nullptr && recorder_->tracing(); }
  void pins_changed(double time, const plant::Pins&);

  bool decided() const { return findings_.outcome != Outcome::kUnfinished; }
  const Findings& findings() const { return findings_; }

 private:
  struct Mark {
    double time, angle;  // angle electrical, rad
  };
  void look(const plant::State&);
  void entered(State was, State is, Reason, double time);
  void judge(double time, const DriveView&);
  double mean_rpm(std::size_t turns) const;  // over the last ones
  bool other_speed(const DriveView&) const;

  WitnessSettings settings_;
  Recorder* recorder_;
  Judge judge_;
  Findings findings_;
  State state_ = State::kIdle;
  std::optional<double> first_angle_;
  std::optional<double> lock_at_, slipped_at_, astray_at_;  // of the present claim of lock
  std::uint64_t slips_before_ = 0;              // steps, of earlier claims
  double next_look_ = 0;
  std::deque<Mark> marks_;  // one per electrical turn of set speed, the last kAtSpeedTurns
};

}  // namespace steplock
