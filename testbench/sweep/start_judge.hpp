// What came of one start, told from the rotor's true angle and from what the drive claims: the part of
// a witness that is the same for every kind of drive.
//
//     started          locked, without a slip since, for held_turns electrical turns (of the set speed) and held_s,
//                      the last kAtSpeedTurns of them within kAtSpeed of the set speed; one that stood has also had its highest
//                      speed: for kRisesTurns it has become no faster (by kCreeps)
//     rough            the same, but beyond a bound of current, kick, speed or time (model/design/bounds.hpp)
//     latched          the fault is latched
//     silent_step_out  a slip, or the rotor stands, or the drive's speed is not the rotor's (by a quarter),
//                      and kNoticeTime later the drive still claims that lock
//     unfinished       none of these when the time was over.  Beyond "bus": it is in lock, without a slip, below the set speed,
//                      and has had its highest duty for held_turns, held_s and a second, in which it has become no faster
//                      (by kCreeps): the bus gives no more
//
// A try that failed has a cause, told from the rotor's true motion when it was given up:
//
//     lock_lost        after a claim of lock
//     outrun           while pulling in: the rotor turns at less than half the VCO's speed
//     not_pulled_in    while pulling in, otherwise
//     wrong_way        before that: it turns the other way
//     too_weak         before that: it stands, or turns at less than kSlow of the set speed
//     not_followed     before that, otherwise: it turns, and the drive did not see how
//
// What a slip is, the witness of each kind says.  One that the drive notices ends the try, not the run:
// it may start again.
//
// Doc: docs/sweep.md   Test: tests/testbench/witness_test.cpp
#pragma once

#include <algorithm>
#include <deque>
#include <optional>
#include <string>

#include "model/design/bounds.hpp"
#include "model/plant/plant.hpp"
#include "testbench/drive/six_step/watch.hpp"
#include "testbench/drive/sinusoidal/watch.hpp"

namespace steplock {

enum class Outcome { kStarted, kRough, kLatched, kSilentStepOut, kUnfinished };
const char* name_of(Outcome);
// Rough or not, it runs.
constexpr bool has_started(Outcome o) { return o == Outcome::kStarted || o == Outcome::kRough; }

enum class Cause { kLockLost, kOutrun, kNotPulledIn, kWrongWay, kTooWeak, kNotFollowed };
inline constexpr int kCauses = 6;
const char* name_of(Cause);

struct WitnessSettings {
  double run_s = 0;             // when `run` rises
  double set_rpm = 0;           // signed
  int pole_pairs = 1;
  double advance_deg = 0;
  bool at_rest = true;          // at t = 0: only then there is a kick
  double held_turns = 24, held_s = 0;  // for so long a lock is watched
  double maximum_duty = 1;             // more the drive does not give
  std::optional<design::StartBounds> bounds = std::nullopt;
  double held() const { return std::max(held_s, held_turns * electrical_turn_s()); }
  double electrical_turn_s() const;
};

struct Findings {
  Outcome outcome = Outcome::kUnfinished;
  // Of the latched fault, or of the last failed try; the one of the drive's kind.
  Reason reason = Reason::kNone;
  sinusoidal::Reason sinusoidal_reason = sinusoidal::Reason::kNone;
  std::optional<double> lock_time_s;   // from `run` to the lock that held, or to the last one
  std::optional<double> speed_time_s;  // from `run` to set speed
  std::optional<double> kick_deg;      // electrical, backwards, from where the rotor stood
  double peak_current_a = 0;
  std::optional<double> peak_speed;    // of a rotor that stood: its highest, over the set speed
  std::string causes;                  // of each failed try, with + between them
  std::string beyond;                  // the bounds that a rough start passed: current, kick, speed, lock; likewise.  Or bus
  int retries = 0;                     // failed tries
  int lost_locks = 0;                  // of them, after a claim of lock
  std::uint64_t slips = 0;             // six-step: steps; sinusoidal: times that the angle was lost
  double end_s = 0;
};

class StartJudge {
 public:
  static constexpr double kAtSpeed = 0.03, kNoticeTime = 0.5,
                          kOtherSpeed = 0.25, kStandStill = 0.01, kSlow = 0.02, kCreeps = 0.001, kRisesTurns = 24;
  static constexpr std::size_t kAtSpeedTurns = 6;

  explicit StartJudge(const WitnessSettings& settings) : settings_(settings) {}

  // At every gate edge, where the current of a chopped motor has its peaks.
  void look(const plant::State&);
  // A try; its reason is the caller's.  `pulled_in`: it was given up while pulling in.
  void failed(bool claimed_lock, bool for_good, double time);
  void caused(const plant::State&, bool claimed_lock, bool pulled_in, double drive_rpm);
  void claims(bool lock, double time);                         // from now on
  void slipped(std::uint64_t in_total, double time);
  // Once per electrical turn of set speed, from next_look() on.  `drive_rpm`: what the drive takes for
  // the speed, positive the wanted way; `duty`: the drive's, 0 to 1, or 0 where it has none.
  void turn(const plant::State&, double drive_rpm, double duty = 0);
  double next_look() const { return next_look_; }

  bool decided() const { return findings_.outcome != Outcome::kUnfinished || !findings_.beyond.empty(); }
  const Findings& findings() const { return findings_; }
  Findings& findings() { return findings_; }

 private:
  struct Mark {
    double time, angle;  // angle electrical, rad
  };
  void judge(double time, double drive_rpm, double duty);
  bool bus_gives_no_more(double time, double duty);
  bool rises(double time);
  std::string beyond() const;  // which bounds
  double mean_rpm(std::size_t turns) const;  // over the last ones
  bool other_speed(double drive_rpm) const;
  double way() const { return settings_.set_rpm < 0 ? -1 : 1; }

  WitnessSettings settings_;
  Findings findings_;
  std::optional<double> first_angle_;
  std::optional<double> lock_at_, slipped_at_, astray_at_;  // of the present claim of lock
  std::uint64_t slips_before_ = 0;  // of earlier claims
  std::optional<double> full_at_;   // the duty has been at its highest since, and the speed was full_rpm_
  double full_rpm_ = 0;
  std::optional<double> highest_at_;  // of this lock: no faster since than highest_rpm_
  double highest_rpm_ = 0;
  double next_look_ = 0;
  std::deque<Mark> marks_;  // one per electrical turn of set speed, the last kAtSpeedTurns
};

}  // namespace steplock
