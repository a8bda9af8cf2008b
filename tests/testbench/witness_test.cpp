// The outcome of a run, told from the rotor's true angle: each kind, made by hand.
#include "testbench/sweep/witness.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace steplock {
namespace {

constexpr double kPi = std::numbers::pi;

Watch watch(State state, int step, Reason reason = Reason::kNone) {
  return {static_cast<std::uint32_t>(step) << Watch::kStep |
          static_cast<std::uint32_t>(state) << Watch::kState |
          static_cast<std::uint32_t>(reason) << Watch::kReason};
}

// A rotor and a drive that turn as told: 600 rpm, one pole pair, so 100 ms per electrical turn and
// 60 steps a second.
class Story {
 public:
  explicit Story(bool at_rest = true)
      : Story({.run_s = 0.1, .set_rpm = 600, .pole_pairs = 1, .advance_deg = 0, .at_rest = at_rest}) {}
  explicit Story(const WitnessSettings& settings) : witness_(settings) {
    state_.electrical_angle = 30 * kPi / 180;
    witness_.sample(state_, was_, {}, 0);
  }
  void enter(State state, Reason reason = Reason::kNone) { change(watch(state, was_.step(), reason)); }
  // Steps the drive, and turns the rotor by so many degrees meanwhile.
  void step(int count, double rotor_deg = 60) {
    for (int k = 0; k < count && !witness_.decided(); ++k) {
      state_.time += 1.0 / 60;
      state_.electrical_angle += rotor_deg * kPi / 180;
      change(watch(was_.state(), (was_.step() + 1) % 6, was_.reason()));
      if (state_.time >= witness_.next_sample()) witness_.sample(state_, was_, view_, 0);
    }
  }
  // So long, at so many degrees a step, and no commutation that could slip.
  void turns(double s, double deg_a_step) {
    for (const double end = state_.time + s; state_.time < end && !witness_.decided();) {
      state_.time += 0.01;
      state_.electrical_angle += deg_a_step * 60 * 0.01 * kPi / 180;
      view_.steps_per_second = deg_a_step;
      if (state_.time >= witness_.next_sample()) witness_.sample(state_, was_, view_, 0);
    }
  }
  void wait(double s) {
    for (const double end = state_.time + s; state_.time < end; state_.time += 0.01) {
      if (state_.time >= witness_.next_sample()) witness_.sample(state_, was_, view_, 0);
    }
  }
  void current(double amps) { state_.current = {amps, -amps, 0}; }
  void speed(double rad_per_s) {
    state_.speed = rad_per_s;
    witness_.changed(state_, was_, was_, view_, 0);
  }
  void duty(double duty) { view_.duty = duty; }
  void turn_back(double deg) { state_.electrical_angle -= deg * kPi / 180; }
  const Findings& findings() const { return witness_.findings(); }

 private:
  void change(Watch now) {
    witness_.changed(state_, was_, now, view_, 0);
    was_ = now;
  }
  Witness witness_;
  plant::State state_;
  Watch was_ = watch(State::kIdle, 0);
  DriveView view_{.steps_per_second = 60};
};

TEST(Witness, ALockHeldAtSetSpeedHasStarted) {
  Story story;
  story.enter(State::kPullIn);
  story.step(60);
  story.enter(State::kRun);
  story.step(6 * 40);
  EXPECT_EQ(story.findings().outcome, Outcome::kStarted);
  EXPECT_NEAR(*story.findings().lock_time_s, 1.0 - 0.1, 1e-9);
  // 24 electrical turns held; looks come once a turn, by rounding a step later.
  EXPECT_NEAR(story.findings().end_s, 1.0 + 2.4, 0.12);
  EXPECT_EQ(story.findings().slips, 0u);
  EXPECT_EQ(*story.findings().kick_deg, 0);
}

TEST(Witness, ALockIsWatchedForItsTurnsAndItsTime) {
  for (const bool by_turns : {false, true}) {
    Story story({.run_s = 0, .set_rpm = 600, .held_turns = by_turns ? 50.0 : 1.0, .held_s = by_turns ? 1.0 : 5.0});
    story.enter(State::kRun);
    story.step(6 * 49);
    EXPECT_EQ(story.findings().outcome, Outcome::kUnfinished);
    story.step(6 * 2);
    EXPECT_EQ(story.findings().outcome, Outcome::kStarted);
  }
}

// A ramp's end is passed after the speed was first within 3 % of the set speed: a run that ended there would not show by how much.
TEST(Witness, OneThatStoodIsWatchedUntilItGrowsNoFaster) {
  for (const bool stood : {true, false}) {
    Story story({.run_s = 0, .set_rpm = 600, .at_rest = stood, .held_turns = 1});
    story.enter(State::kRun);
    for (int k = 0; k < 4; ++k) story.turns(1, 58.5 + 0.6 * k);  // 585 to 603 r/min, ten turns of each
    EXPECT_EQ(story.findings().outcome, stood ? Outcome::kUnfinished : Outcome::kStarted);
    story.turns(2.2, 60);  // of the last highest speed 10 turns, and 22 of less: more than 24 since it rose
    EXPECT_EQ(story.findings().outcome, Outcome::kStarted);
  }
}

// Each bound, kept by a hair and passed by a hair.
TEST(Witness, AStartBeyondABoundIsRough) {
  constexpr design::StartBounds kBounds = {.current_a = 5, .kick_deg = 90, .speed = 1.2, .lock_s = 1.005};
  const auto told = [&](double amps, double back_deg, double speed, int steps) {
    Story story({.run_s = 0, .set_rpm = 600, .bounds = kBounds});
    story.enter(State::kPullIn);
    story.current(amps);
    story.turn_back(back_deg);
    story.speed(speed * 600 * kPi / 30);
    story.turn_back(-back_deg);
    story.step(steps);
    story.enter(State::kRun);
    story.step(6 * 40);
    return std::string(name_of(story.findings().outcome)) + ":" + story.findings().beyond;
  };
  EXPECT_EQ(told(4.99, 89.9, 1.199, 60), "started:");
  EXPECT_EQ(told(5.01, 89.9, 1.199, 60), "rough:current");
  EXPECT_EQ(told(4.99, 90.1, 1.199, 60), "rough:kick");
  EXPECT_EQ(told(4.99, 89.9, 1.201, 60), "rough:speed");
  EXPECT_EQ(told(4.99, 89.9, 1.199, 61), "rough:lock");
  EXPECT_EQ(told(5.01, 90.1, 1.201, 61), "rough:current+kick+speed+lock");
}

TEST(Witness, ALockAtAnotherSpeedNeverStarts) {
  Story story;
  story.enter(State::kRun);
  story.step(6 * 60, 56);  // falls behind, too: slips
  EXPECT_NE(story.findings().outcome, Outcome::kStarted);
}

// 56 degrees in the time of a step are 560 r/min.
TEST(Witness, ALockBelowTheSetSpeedAtTheHighestDutyIsWhatTheBusGives) {
  const auto told = [](double duty, double deg, double faster) {
    Story story({.run_s = 0, .set_rpm = 600, .held_turns = 1, .maximum_duty = 0.9});
    story.duty(duty);
    story.enter(State::kRun);
    for (int k = 0; k < 60; ++k) story.turns(0.1, deg * (1 + k * faster));
    return std::string(name_of(story.findings().outcome)) + ":" + story.findings().beyond;
  };
  EXPECT_EQ(told(0.9, 56, 0), "unfinished:bus");
  EXPECT_EQ(told(0.89, 56, 0), "unfinished:") << "the drive could give more";
  EXPECT_EQ(told(0.9, 50, 0.0005), "unfinished:") << "it becomes faster";
  EXPECT_EQ(told(0.9, 64, 0), "unfinished:") << "it is too fast";
  EXPECT_EQ(told(0.9, 59, 0), "started:");
}

TEST(Witness, AClaimOfLockOnARotorThatStandsIsASilentStepOut) {
  Story story;
  story.enter(State::kRun);
  story.step(6 * 20, 0);
  EXPECT_EQ(story.findings().outcome, Outcome::kSilentStepOut);
  EXPECT_GT(story.findings().slips, 0u);
  // The drive had kNoticeTime to notice; looks come once in 0.1 s.
  EXPECT_NEAR(story.findings().end_s, StartJudge::kNoticeTime, 0.25);
}

// Hall sensors that never change cause no commutation: only the speed tells.
TEST(Witness, AClaimOfLockWithoutCommutationsOnARotorThatStandsIsSilentToo) {
  Story story;
  story.enter(State::kRun);
  story.wait(2);
  EXPECT_EQ(story.findings().outcome, Outcome::kSilentStepOut);
  EXPECT_EQ(story.findings().slips, 0u);
}

TEST(Witness, ASlipThatTheDriveNoticesIsATryThatFailed) {
  Story story;
  story.enter(State::kRun);
  story.step(12, 0);
  story.enter(State::kRetryDelay, Reason::kStepOut);
  story.step(6, 0);
  story.enter(State::kPullIn);
  story.step(6);
  story.enter(State::kRun);
  story.step(6 * 40);
  EXPECT_EQ(story.findings().outcome, Outcome::kStarted);
  EXPECT_EQ(story.findings().retries, 1);
  EXPECT_EQ(story.findings().lost_locks, 1);
  EXPECT_EQ(story.findings().reason, Reason::kStepOut);
  EXPECT_GT(story.findings().slips, 0u);
}

TEST(Witness, ALatchedFaultEndsTheRunWithItsReason) {
  Story story;
  story.enter(State::kPullIn);
  story.step(6);
  story.enter(State::kFault, Reason::kNoLock);
  EXPECT_EQ(story.findings().outcome, Outcome::kLatched);
  EXPECT_EQ(story.findings().reason, Reason::kNoLock);
  EXPECT_FALSE(story.findings().lock_time_s);
}

TEST(Witness, ARunThatDecidesNothingIsUnfinished) {
  Story story;
  story.enter(State::kAccelerate);
  story.step(600);
  EXPECT_EQ(story.findings().outcome, Outcome::kUnfinished);
}

TEST(Witness, TheKickIsTheFarthestWayBackFromRest) {
  Story story;
  story.enter(State::kAlign);
  story.turn_back(47);
  story.step(1, 0);
  story.step(30);
  EXPECT_NEAR(*story.findings().kick_deg, 47, 1e-9);
  Story spinning(false);
  spinning.step(3, -60);
  EXPECT_FALSE(spinning.findings().kick_deg);
}

// 600 r/min are 62.8 rad/s, and as many in electrical terms: 60 steps a second.
TEST(Witness, EachFailedTryHasTheCauseThatTheRotorsMotionTells) {
  const auto cause = [](double rad_per_s, State state) {
    Story story;
    story.enter(state);
    story.speed(rad_per_s);
    story.enter(State::kRetryDelay, Reason::kNoLock);
    return story.findings().causes;
  };
  EXPECT_EQ(cause(62.8, State::kRun), "lock_lost");
  EXPECT_EQ(cause(31.3, State::kPullIn), "outrun");
  EXPECT_EQ(cause(31.5, State::kPullIn), "not_pulled_in");
  EXPECT_EQ(cause(-1.3, State::kAccelerate), "wrong_way");
  EXPECT_EQ(cause(-1.2, State::kAccelerate), "too_weak");
  EXPECT_EQ(cause(1.2, State::kAccelerate), "too_weak");
  EXPECT_EQ(cause(1.3, State::kAccelerate), "not_followed");
  Story story;
  for (const State state : {State::kPullIn, State::kRetryDelay, State::kAccelerate, State::kFault}) story.enter(state);
  EXPECT_EQ(story.findings().causes, "outrun+too_weak");
}

TEST(Witness, TheHighestSpeedIsThatOfARotorThatStood) {
  Story story;
  for (const double rad_per_s : {0.0, 62.83185307, 94.24777961, -200.0, 30.0}) story.speed(rad_per_s);
  EXPECT_NEAR(*story.findings().peak_speed, 1.5, 1e-9);
  Story spinning(false);
  spinning.speed(60);
  EXPECT_FALSE(spinning.findings().peak_speed);
}

TEST(Witness, ThePeakIsTheLargestOfAnyPhaseEitherWay) {
  Story story;
  story.current(3);
  story.step(1);
  story.current(-7);
  story.step(1);
  story.current(1);
  story.step(1);
  EXPECT_EQ(story.findings().peak_current_a, 7);
}

}  // namespace
}  // namespace steplock
