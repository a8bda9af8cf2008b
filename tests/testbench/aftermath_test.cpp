// What becomes of a running drive, told from the rotor's true angle: each outcome, made by hand.
#include "testbench/sweep/aftermath.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace steplock {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

// 600 rpm, one pole pair: 100 ms per electrical turn, 60 steps a second.  The disturbance comes at 1 s.
class Story {
 public:
  explicit Story(bool good = false)
      : aftermath_({.run_s = 0, .set_rpm = 600, .pole_pairs = 1, .advance_deg = 0, .at_rest = true}) {
    state_.electrical_angle = 30 * kDegree;
    change(State::kRun, 0);
    step(54);
    aftermath_.disturb({.from_s = 1, .until_s = 1, .set_rpm = 600, .for_good = good, .look_at_freewheeling = true});
    step(6);
  }
  // Steps the drive, and turns the rotor by so many degrees meanwhile.
  void step(int count, double rotor_deg = 60) {
    for (int k = 0; k < count && !aftermath_.decided(); ++k) {
      state_.time += 1.0 / 60;
      state_.electrical_angle += rotor_deg * kDegree;
      state_.speed = rotor_deg * kDegree * 60;
      change(was_.state(), (was_.step() + 1) % 6);
      look();
    }
  }
  void enter(State state, Reason reason = Reason::kNone) { change(state, was_.step(), reason); }
  // The phase switched off carries current for this long, then floats.
  void freewheel(double deg) {
    state_.electrical_angle += deg * kDegree;
    state_.time += deg / 3600;
    state_.floating = {true, true, true};
    look();
    state_.floating = {};
    state_.electrical_angle -= deg * kDegree;
    state_.time -= deg / 3600;
  }
  void over() { aftermath_.time_is_over(); }
  const AfterFindings& findings() const { return aftermath_.findings(); }

 private:
  void look() {
    if (state_.time >= aftermath_.next_sample()) {
      aftermath_.sample(state_, was_, {.steps_per_second = 60}, 0);
    }
  }
  void change(State state, int step, Reason reason = Reason::kNone) {
    const Watch now{static_cast<std::uint32_t>(step) << Watch::kStep |
                    static_cast<std::uint32_t>(state) << Watch::kState |
                    static_cast<std::uint32_t>(reason) << Watch::kReason};
    aftermath_.changed(state_, was_, now, {.steps_per_second = 60}, 0);
    was_ = now;
  }
  Aftermath aftermath_;
  plant::State state_;
  Watch was_;
};

TEST(Aftermath, ADriveThatIsNeverShakenHasRecoveredAtOnce) {
  Story story;
  story.step(200);
  EXPECT_EQ(story.findings().outcome, After::kRecovered);
  EXPECT_EQ(*story.findings().recovery_s, 0);
  EXPECT_EQ(story.findings().slips, 0u);
}

TEST(Aftermath, RecoveryLastsUntilTheLastTurnThatWasSlow) {
  Story story;
  story.step(12, 57);
  story.step(200);
  EXPECT_EQ(story.findings().outcome, After::kRecovered);
  // Two slow turns of 0.1 s; a look may take in a part of the next one.
  EXPECT_NEAR(*story.findings().recovery_s, 0.3, 0.11);
  EXPECT_NEAR(story.findings().dip, 0.05, 0.005);
}

TEST(Aftermath, ALockGivenUpAndTakenAgainIsARecoveryWithARetry) {
  Story story;
  story.step(3, 0);
  story.enter(State::kRetryDelay, Reason::kStepOut);
  story.step(9, 0);
  story.enter(State::kRun);
  story.step(300);
  EXPECT_EQ(story.findings().outcome, After::kRecovered);
  EXPECT_EQ(story.findings().retries, 1);
  EXPECT_EQ(story.findings().lost_locks, 1);
  EXPECT_NEAR(*story.findings().lost_s, 3 / 60.0, 1.1 / 60);
  EXPECT_GT(*story.findings().recovery_s, 0.2);
}

TEST(Aftermath, ARotorThatStandsWhileTheDriveClaimsItsLockIsSilent) {
  Story story;
  story.step(200, 0);
  EXPECT_EQ(story.findings().outcome, After::kSilentStepOut);
  // Half a second of notice; looks come once in 0.1 s.
  EXPECT_NEAR(story.findings().end_s - story.findings().disturbed_s, 0.5, 0.25);
  EXPECT_GT(story.findings().slips, 0u);
}

// Right speed, wrong angle: only the true angle tells.
TEST(Aftermath, AStableLockTwoStepsAwayIsSilent) {
  Story story;
  story.step(2, 0);
  story.step(200);
  EXPECT_EQ(story.findings().outcome, After::kSilentStepOut);
}

TEST(Aftermath, AFaultIsLatchedWithItsTimeAndReason) {
  Story story;
  story.step(9);
  story.enter(State::kFault, Reason::kStepOut);
  EXPECT_EQ(story.findings().outcome, After::kLatched);
  EXPECT_EQ(story.findings().reason, Reason::kStepOut);
  EXPECT_NEAR(*story.findings().fault_s, 9 / 60.0, 1.1 / 60);
}

TEST(Aftermath, AFaultForGoodIsNotRecoveredFromBeforeTheTimeIsOver) {
  Story story(true);
  story.step(600);
  EXPECT_EQ(story.findings().outcome, After::kUnfinished);
  story.over();
  EXPECT_EQ(story.findings().outcome, After::kRecovered);
}

TEST(Aftermath, MeasuresHowLongTheCommutatedCurrentFlows) {
  Story story;
  story.step(1);
  story.freewheel(17);
  story.step(1);
  story.freewheel(9);
  EXPECT_NEAR(story.findings().demagnetisation_deg, 17, 1e-9);
}

}  // namespace
}  // namespace steplock
