// The start sequence of the reference, state by state.
#include <gtest/gtest.h>

#include "model/reference/start_sequence.hpp"

namespace steplock::reference {
namespace {

constexpr design::StartParameters kTimes{.pre_align = 0.02,
                                         .align = 0.03,
                                         .hand_over = 100,
                                         .good_crossings = 5,
                                         .pull_in = 0.1,
                                         .detect_spin = 0.01,
                                         .slow_down = 0.2,
                                         .brake = 0.04,
                                         .retry_delay = 0.05,
                                         .retries = 2};

struct Case {
  explicit Case(design::Source source = design::Source::kBemf, const design::StartParameters& times = kTimes)
      : sequence(times, source, 1e-3) {}

  State tick(int times = 1, StartSequence::In in = {}) {
    in.command = command;
    in.tick = true;
    if (in.frequency == 0) in.frequency = 500;
    for (int k = 0; k < times; ++k) sequence.update(in);
    return sequence.state();
  }
  // An event between two ticks.
  State event(StartSequence::In in) {
    in.command = command;
    if (in.frequency == 0) in.frequency = 500;
    sequence.update(in);
    return sequence.state();
  }
  State run_up() {
    command.run = true;
    tick(1 + 10 + 20 + 30);
    event({.ramp_done = true});
    for (int k = 0; k < 5; ++k) event({.updated = true, .good = true});
    return sequence.state();
  }

  Command command;
  StartSequence sequence;
};

TEST(ReferenceStartSequence, GoesThroughThePapersModesInTime) {
  Case c;
  EXPECT_EQ(c.tick(5), State::kIdle);
  c.command.run = true;
  EXPECT_EQ(c.tick(), State::kDetectSpin);
  EXPECT_EQ(c.tick(9), State::kDetectSpin);
  EXPECT_EQ(c.tick(), State::kPreAlign);
  EXPECT_EQ(c.tick(20), State::kAlign);
  EXPECT_EQ(c.tick(29), State::kAlign);
  EXPECT_EQ(c.tick(), State::kAccelerate);
  EXPECT_EQ(c.tick(500), State::kAccelerate);  // until the ramp says so
  EXPECT_EQ(c.event({.ramp_done = true}), State::kPullIn);
}

// What has seen no rotor go on moving in the last 1024 of 4096 ticks fails for good; what has gets four times as many, over all
// tries.
TEST(ReferenceStartSequence, ARotorThatMovesHasFourTimesTheTicks) {
  auto times = kTimes;
  times.method = design::Method::kFollow;
  for (const bool hopeful : {false, true}) {
    for (const bool blocked : {false, true}) {
      Case c(design::Source::kBemf, times);
      c.command.run = true;
      ASSERT_EQ(c.tick(1 + 10), State::kAccelerate);
      int ticks = hopeful ? 4 * 4096 - 2 : 4095;
      if (blocked) {
        ASSERT_EQ(c.tick(1000, {.hopeful = hopeful}), State::kAccelerate);
        ASSERT_EQ(c.event({.blocked = true}), State::kRetryDelay);
        ASSERT_EQ(c.tick(50 + 10), State::kAccelerate);
        ticks -= 1000;
      }
      EXPECT_EQ(c.tick(ticks - 1, {.hopeful = hopeful}), State::kAccelerate);
      EXPECT_EQ(c.tick(1, {.hopeful = hopeful}), State::kRetryDelay);
      EXPECT_EQ(c.tick(50), State::kFault);
    }
  }
}

// An eighth of them, from end to end; one that is shaken in its place moves for moments.
TEST(ReferenceStartSequence, ARotorThatWentOnMovingInTheLastThousandTicksIsHopeful) {
  auto times = kTimes;
  times.method = design::Method::kFollow;
  struct Span {
    int from, to;  // ticks before the first verdict, the 4095th
    bool hopeful;
  };
  for (const Span span : {Span{128, 1, true}, {127, 1, false}, {128, 2, false}, {192, 66, false}, {256, 129, true}, {1024, 897, true},
                          {1023, 897, false}, {1024, 898, false}, {1152, 1025, false}, {3000, 1025, false}}) {
    Case c(design::Source::kBemf, times);
    c.command.run = true;
    ASSERT_EQ(c.tick(1 + 10), State::kAccelerate);
    c.tick(4094 - span.from), c.tick(span.from - span.to + 1, {.hopeful = true}), c.tick(span.to - 1);
    EXPECT_EQ(c.tick(), span.hopeful ? State::kAccelerate : State::kRetryDelay) << span.from << ' ' << span.to;
  }
}

TEST(ReferenceStartSequence, LocksOnlyAfterGoodCrossingsInARow) {
  Case c;
  c.command.run = true;
  c.tick(61);
  c.event({.ramp_done = true});
  for (int k = 0; k < 4; ++k) c.event({.updated = true, .good = true});
  EXPECT_EQ(c.event({.updated = true, .good = false}), State::kPullIn);
  for (int k = 0; k < 4; ++k) c.event({.updated = true, .good = true});
  EXPECT_FALSE(c.sequence.locked());
  EXPECT_EQ(c.event({.updated = true, .good = true}), State::kRun);
}

TEST(ReferenceStartSequence, RetriesWithTwiceTheResetAsOftenAsAllowedThenLatches) {
  Case c;
  c.command.run = true;
  c.tick();
  for (int attempt = 0; attempt < 3; ++attempt) {
    const int longer = 1 << attempt;  // a rotor that still swings needs more time
    c.tick(10);
    EXPECT_EQ(c.tick(20 * longer - 1), State::kPreAlign);
    EXPECT_EQ(c.tick(), State::kAlign);
    EXPECT_EQ(c.tick(30 * longer - 1), State::kAlign);
    EXPECT_EQ(c.tick(), State::kAccelerate);
    EXPECT_EQ(c.event({.ramp_done = true}), State::kPullIn);
    EXPECT_EQ(c.tick(100), State::kRetryDelay);
    EXPECT_EQ(c.sequence.reason(), Reason::kNoLock);
    c.tick(50);
  }
  EXPECT_EQ(c.sequence.state(), State::kFault);
}

TEST(ReferenceStartSequence, AFaultNeedsRunLowTheCauseGoneAndARisingClear) {
  Case c;
  ASSERT_EQ(c.run_up(), State::kRun);
  EXPECT_EQ(c.event({.fatal = Reason::kFaultPin, .fault_pin = true}), State::kFault);
  EXPECT_EQ(c.sequence.reason(), Reason::kFaultPin);
  c.command.clear_fault = true;
  EXPECT_EQ(c.tick(), State::kFault);  // run is high
  c.command = {};
  EXPECT_EQ(c.tick(), State::kFault);
  c.command.clear_fault = true;
  EXPECT_EQ(c.event({.fault_pin = true}), State::kFault);  // the cause is still there
  EXPECT_EQ(c.tick(), State::kFault);                      // no new edge
  c.command.clear_fault = false;
  c.tick();
  c.command.clear_fault = true;
  EXPECT_EQ(c.tick(), State::kIdle);
}

TEST(ReferenceStartSequence, CatchesARotorThatTurnsTheRightWay) {
  Case c;
  c.command.run = true;
  c.tick();
  EXPECT_EQ(c.event({.caught = 1}), State::kRun);
}

TEST(ReferenceStartSequence, BrakesARotorThatTurnsTheOtherWayAndGivesUpInTheEnd) {
  Case c;
  c.command.run = true;
  c.tick();
  for (int k = 0; k < 255; ++k) {
    ASSERT_EQ(c.event({.caught = -1}), State::kBrake);
    ASSERT_EQ(c.tick(40), State::kDetectSpin);
  }
  EXPECT_EQ(c.event({.caught = -1}), State::kFault);
  EXPECT_EQ(c.sequence.reason(), Reason::kCannotStop);
}

TEST(ReferenceStartSequence, ReversesBySlowingDownBrakingAndStartingAgain) {
  Case c;
  ASSERT_EQ(c.run_up(), State::kRun);
  c.command.reverse = true;
  EXPECT_EQ(c.tick(), State::kSlowDown);
  EXPECT_FALSE(c.sequence.reverse());
  EXPECT_EQ(c.tick(50), State::kSlowDown);
  EXPECT_EQ(c.event({.frequency = 120}), State::kBrake);
  EXPECT_EQ(c.tick(40), State::kDetectSpin);
  EXPECT_TRUE(c.sequence.reverse());
  EXPECT_EQ(c.tick(10), State::kPreAlign);
}

TEST(ReferenceStartSequence, AChangedMindDuringSlowDownGoesOn) {
  Case c;
  c.run_up();
  c.command.reverse = true;
  c.tick();
  c.command.reverse = false;
  EXPECT_EQ(c.tick(), State::kRun);
}

TEST(ReferenceStartSequence, StopsByBrakingUntilNothingTurns) {
  Case c;
  c.command.brake_to_stop = true;
  c.run_up();
  c.command.run = false;
  EXPECT_EQ(c.tick(), State::kSlowDown);
  EXPECT_EQ(c.tick(200), State::kBrake);  // the time limit
  EXPECT_EQ(c.tick(40), State::kDetectSpin);
  EXPECT_EQ(c.event({.caught = 1}), State::kBrake);  // still turns
  EXPECT_EQ(c.tick(40), State::kDetectSpin);
  EXPECT_EQ(c.tick(10), State::kIdle);
}

TEST(ReferenceStartSequence, CoastsAtOnceWithoutBrakeToStop) {
  Case c;
  c.run_up();
  c.command.run = false;
  EXPECT_EQ(c.event({}), State::kIdle);
}

TEST(ReferenceStartSequence, ALostLockRestsAndKeepsItsReason) {
  Case c;
  c.run_up();
  EXPECT_EQ(c.event({.lost = Reason::kStepOut}), State::kRetryDelay);
  EXPECT_EQ(c.sequence.reason(), Reason::kStepOut);
  EXPECT_EQ(c.tick(50), State::kDetectSpin);
  EXPECT_EQ(c.sequence.retries(), 1);
}

TEST(ReferenceStartSequence, UnconfiguredNeverLeavesIdle) {
  Case c;
  c.command.configured = false;
  c.command.run = true;
  EXPECT_EQ(c.tick(50), State::kIdle);
}

TEST(ReferenceStartSequence, HallsNeedNoStart) {
  Case c(design::Source::kHall);
  c.command.run = true;
  EXPECT_EQ(c.tick(), State::kRun);
}

}  // namespace
}  // namespace steplock::reference
