// The outcome of a sinusoidal drive's start, told from the rotor's true angle: each kind, made by hand.
#include "testbench/sweep/sinusoidal_witness.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace steplock::sinusoidal {
namespace {

constexpr double kTick = 1e-3;  // s between samples

// A rotor and a drive that turn as told: 600 rpm, one pole pair, so 100 ms per electrical turn.
class Story {
 public:
  explicit Story(bool at_rest = true)
      : witness_({.run_s = 0.1, .set_rpm = 600, .pole_pairs = 1, .advance_deg = 0, .at_rest = at_rest}) {
    witness_.sample(plant_, watch_, view_, 0);
  }
  void enter(State state, Reason reason = Reason::kNone) {
    view_.estimating = state == State::kStarting || state == State::kRun;
    change({static_cast<std::uint32_t>(state) << Watch::kState |
            static_cast<std::uint32_t>(reason) << Watch::kReason});
  }
  // Turns the rotor at `rpm`; the drive's angle stays `behind_deg` of it, and its speed is `believed_rpm`.
  void turn(double seconds, double rpm = 600, double behind_deg = 0, double believed_rpm = 600) {
    for (const double end = plant_.time + seconds; plant_.time < end - kTick / 2 && !witness_.decided();) {
      plant_.time += kTick;
      plant_.electrical_angle += rpm / 60 * 2 * std::numbers::pi * kTick;
      change({watch_.bits | 1u << Watch::kSample});  // shows the angle of the sample before
      change({watch_.bits & ~Watch::kStrobeMask});
      view_.angle_deg = north_pole_deg(plant_) - behind_deg;
      view_.speed_rpm = believed_rpm;
      if (plant_.time >= witness_.next_sample()) witness_.sample(plant_, watch_, view_, 0);
    }
  }
  void current(double amps) { plant_.current = {amps, -amps, 0}; }
  const Findings& findings() const { return witness_.findings(); }

 private:
  void change(Watch now) {
    witness_.changed(plant_, watch_, now, view_, 0);
    watch_ = now;
  }
  Witness witness_;
  plant::State plant_;
  Watch watch_;
  View view_;
};

TEST(SinusoidalWitness, ALockHeldAtSetSpeedHasStarted) {
  Story story;
  story.enter(State::kStarting);
  story.turn(1);
  story.enter(State::kRun);
  story.turn(4, 600, 20);
  EXPECT_EQ(story.findings().outcome, Outcome::kStarted);
  EXPECT_NEAR(*story.findings().lock_time_s, 0.9, 1e-9);
  // The highest speed stands for 24 turns from the first look at it; looks come once a turn, a quarter of one late.
  EXPECT_NEAR(story.findings().end_s, 1 + 0.1 + 2.4, 0.026);
  EXPECT_EQ(story.findings().slips, 0u);
}

// The same with an estimate on the other side of the rotor: the speed alone says nothing.
TEST(SinusoidalWitness, ALockOnALostAngleIsSilentAtTheRightSpeedToo) {
  Story story;
  story.enter(State::kRun);
  story.turn(4, 600, 100);
  EXPECT_EQ(story.findings().outcome, Outcome::kSilentStepOut);
  EXPECT_EQ(story.findings().slips, 1u);
  EXPECT_NEAR(story.findings().end_s, StartJudge::kNoticeTime, 0.12);
}

TEST(SinusoidalWitness, ALockOnARotorThatStandsIsSilent) {
  Story story;
  story.enter(State::kRun);
  story.turn(2, 0, 0, 0);
  EXPECT_EQ(story.findings().outcome, Outcome::kSilentStepOut);
}

TEST(SinusoidalWitness, ALossThatTheDriveNoticesIsATryThatFailed) {
  Story story;
  story.enter(State::kRun);
  story.turn(0.2, 600, 100);
  story.enter(State::kRetryDelay, Reason::kEmf);
  story.turn(0.3, 0);
  story.enter(State::kStarting);
  story.turn(0.2, 600, 170);  // no claim, so no slip
  story.turn(2 * kTick);
  story.enter(State::kRun);
  story.turn(4);
  EXPECT_EQ(story.findings().outcome, Outcome::kStarted);
  EXPECT_EQ(story.findings().retries, 1);
  EXPECT_EQ(story.findings().lost_locks, 1);
  EXPECT_EQ(story.findings().slips, 1u);
  EXPECT_EQ(story.findings().sinusoidal_reason, Reason::kEmf);
}

TEST(SinusoidalWitness, ALatchedFaultEndsTheRunWithItsReason) {
  Story story;
  story.enter(State::kStarting);
  story.turn(0.1, 0);
  story.enter(State::kFault, Reason::kNoLock);
  EXPECT_EQ(story.findings().outcome, Outcome::kLatched);
  EXPECT_EQ(story.findings().sinusoidal_reason, Reason::kNoLock);
  EXPECT_FALSE(story.findings().lock_time_s);
}

TEST(SinusoidalWitness, ALockBelowSetSpeedIsUnfinished) {
  Story story;
  story.enter(State::kRun);
  story.turn(5, 500, 0, 500);
  EXPECT_EQ(story.findings().outcome, Outcome::kUnfinished);
  EXPECT_TRUE(story.findings().lock_time_s);
}

TEST(SinusoidalWitness, TheKickIsTheFarthestWayBackFromRestAndThePeakOfAnyPhase) {
  Story story;
  story.enter(State::kPattern);
  story.current(-7);
  story.turn(0.1, -60);
  story.current(3);
  story.turn(0.5);
  EXPECT_NEAR(*story.findings().kick_deg, 36, 1e-6);
  EXPECT_EQ(story.findings().peak_current_a, 7);
  Story spinning(false);
  spinning.turn(0.1, -60);
  EXPECT_FALSE(spinning.findings().kick_deg);
}

}  // namespace
}  // namespace steplock::sinusoidal
