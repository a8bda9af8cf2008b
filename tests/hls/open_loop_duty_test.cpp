#include "hls/six_step/open_loop_duty.hpp"

#include <gtest/gtest.h>

#include <cstdint>

namespace steplock {
namespace {

constexpr State kStates[] = {State::kIdle,       State::kDetectSpin, State::kBrake, State::kPreAlign,
                             State::kAlign,      State::kAccelerate, State::kPullIn, State::kRun,
                             State::kSlowDown,   State::kRetryDelay,    State::kFault};

struct Bench {
  OpenLoopDuty dut;
  OpenLoopDuty::In in{.align_duty = 1000, .start_duty = 3200, .brake_duty = 500};

  // The duty that follows a clock with the present inputs.
  Duty clock() {
    dut.tick(in);
    auto shown = dut;
    return shown.tick(in).duty;
  }
  Duty in_state(State state) {
    in.state = state;
    return clock();
  }
  Duty pull_in() {
    in_state(State::kAccelerate);
    return in_state(State::kPullIn);
  }
  // A step and a clock without one, as steps come.
  Duty step(bool lags) {
    in.lags = lags;
    in.commutate = true;
    clock();
    in.commutate = false;
    return clock();
  }
};

TEST(OpenLoopDuty, EachStateHasItsDuty) {
  Bench bench;
  for (const State state : kStates) {
    if (state == State::kPullIn) continue;
    const Duty wanted = state == State::kPreAlign || state == State::kAlign ? Duty(1000)
                        : state == State::kAccelerate                     ? Duty(3200)
                        : state == State::kBrake                          ? Duty(500)
                                                                          : Duty(0);
    EXPECT_EQ(bench.in_state(state), wanted) << int(state);
  }
}

TEST(OpenLoopDuty, ComesOneClockAfterItsState) {
  OpenLoopDuty dut;
  const OpenLoopDuty::In in{.state = State::kAccelerate, .start_duty = 3200};
  EXPECT_EQ(dut.tick(in).duty, Duty(0));
  EXPECT_EQ(dut.tick(in).duty, Duty(3200));
}

TEST(OpenLoopDuty, StrongDoublesResetAndStartUpToTheWholeAndNothingElse) {
  Bench bench;
  bench.in.strong = true;
  EXPECT_EQ(bench.in_state(State::kPreAlign), Duty(2000));
  EXPECT_EQ(bench.in_state(State::kAlign), Duty(2000));
  EXPECT_EQ(bench.in_state(State::kAccelerate), Duty(6400));
  EXPECT_EQ(bench.in_state(State::kBrake), Duty(500));
  bench.in.align_duty = 0x3fff;
  EXPECT_EQ(bench.in_state(State::kAlign), Duty(0x7ffe));
  for (const std::uint64_t start : {0x4000, 0x4001, 0x7fff, 0x8000, 0xc000, 0xffff}) {
    bench.in.start_duty = Duty::of(start);
    EXPECT_EQ(bench.in_state(State::kAccelerate), Duty(0x8000)) << start;
  }
}

TEST(OpenLoopDuty, FadesByAThirtySecondPerStepAndStandsBetweenSteps) {
  Bench bench;
  EXPECT_EQ(bench.pull_in(), Duty(3200));
  for (int i = 0; i < 10; ++i) EXPECT_EQ(bench.clock(), Duty(3200));
  EXPECT_EQ(bench.step(false), Duty(3100));
  for (int i = 0; i < 10; ++i) EXPECT_EQ(bench.clock(), Duty(3100));
  EXPECT_EQ(bench.step(false), Duty(3100 - 96));
}

// Down to 31 of 65536 a thirty-second is nothing: it ends there, and not at the top by wrapping.
TEST(OpenLoopDuty, FadesToNextToNothingAndStays) {
  Bench bench;
  bench.in.start_duty = Duty::max();
  bench.pull_in();
  std::uint64_t last = 0xffff;
  for (int i = 0; i < 400; ++i) {
    const std::uint64_t now = bench.step(false).raw();
    ASSERT_EQ(now, last - last / 32);
    last = now;
  }
  EXPECT_EQ(last, 31u);
}

TEST(OpenLoopDuty, ARotorThatLagsGetsItBackUpToTheStarts) {
  Bench bench;
  bench.pull_in();
  for (int i = 0; i < 10; ++i) bench.step(false);
  std::uint64_t last = bench.clock().raw();
  while (last < 3200) {
    const std::uint64_t now = bench.step(true).raw();
    ASSERT_EQ(now, last + last / 32);
    last = now;
  }
  EXPECT_LE(last, 3200u + 3200 / 32);  // the last step may pass it
  EXPECT_EQ(bench.step(true), Duty::of(last));
}

TEST(OpenLoopDuty, ALagBeforeAnythingFadedAddsNothing) {
  Bench bench;
  bench.pull_in();
  for (int i = 0; i < 10; ++i) EXPECT_EQ(bench.step(true), Duty(3200));
}

// A rotor that is followed: found with align_duty, then the start's, and a sixteenth once it has hand-over's frequency.
TEST(OpenLoopDuty, FollowingFindsWithTheResetsDutyAcceleratesWithTheStartsAndWaitsWithASixteenth) {
  Bench bench;
  bench.in.follows = true;
  EXPECT_EQ(bench.in_state(State::kAccelerate), Duty(1000));
  bench.in.fast = true;
  EXPECT_EQ(bench.step(false), Duty(1000)) << "nothing is known of a rotor that is not followed";
  bench.in.fast = false;
  bench.in.sure = true;
  bench.clock();
  for (const bool lags : {false, true}) EXPECT_EQ(bench.step(lags), Duty(3200));
  bench.in.fast = true;
  bench.clock();
  for (const bool lags : {false, true}) EXPECT_EQ(bench.step(lags), Duty(200));
  bench.in.fast = false;
  bench.clock();
  EXPECT_EQ(bench.clock(), Duty(1600)) << "a load took its speed";
  EXPECT_EQ(bench.step(false), Duty(3200)) << "and more than that";
}

// Its back-EMF is more than the words say, or its bus less: the next time it gets more, and so while it is pulled in.
TEST(OpenLoopDuty, WhatFellBackFromHandOversFrequencyGetsHalfForAStepAndWaitsWithAQuarter) {
  for (const bool lost : {true, false}) {  // the rotor, or its frequency
    Bench bench;
    bench.in.follows = bench.in.sure = bench.in.fast = true;
    bench.in_state(State::kAccelerate);
    for (const bool lags : {false, true}) EXPECT_EQ(bench.step(lags), Duty(200));
    (lost ? bench.in.sure : bench.in.fast) = false;
    bench.clock();
    EXPECT_EQ(bench.clock(), Duty(lost ? 1000 : 1600));
    bench.in.sure = bench.in.fast = true;
    bench.clock();
    EXPECT_EQ(bench.clock(), Duty(800)) << lost;
  }
}

// The first interval that is measured spans the start's torque: one longer than hand-over's is no falling back.  A rotor that
// passes no edge in all that time is slower indeed.
TEST(OpenLoopDuty, ARotorWhoseFirstIntervalWasLongerThanHandOversGetsHalfForAStepAndNoQuarter) {
  for (const int steps : {0, 1, 2}) {  // that begin with the frequency of hand-over
    Bench bench;
    bench.in.follows = bench.in.sure = bench.in.fast = true;
    bench.in_state(State::kAccelerate);
    for (int i = 0; i < steps; ++i) EXPECT_EQ(bench.step(false), Duty(200));
    bench.in.fast = false;
    bench.clock();
    EXPECT_EQ(bench.clock(), Duty(1600)) << steps;
    bench.in.fast = true;
    bench.clock();
    EXPECT_EQ(bench.clock(), Duty(steps == 1 ? 200 : 800)) << steps;
    // Steps before the speed fell do not count for the next time.
    bench.step(false);
    bench.in.fast = false;
    bench.clock();
    bench.in.fast = true;
    bench.clock();
    EXPECT_EQ(bench.clock(), Duty(steps == 1 ? 200 : 800)) << steps;
  }
}

TEST(OpenLoopDuty, TheQuarterLastsUntilTheNextStart) {
  Bench bench;
  bench.in.follows = bench.in.sure = bench.in.fast = true;
  bench.in_state(State::kAccelerate);
  for (const bool lags : {false, true}) bench.step(lags);
  bench.in.fast = false;
  bench.clock();
  bench.in.fast = true;
  bench.clock();
  bench.pull_in();
  EXPECT_EQ(bench.clock(), Duty(800));
  bench.in_state(State::kRetryDelay);
  bench.in_state(State::kAccelerate);
  EXPECT_EQ(bench.clock(), Duty(200));
  bench.pull_in();
  EXPECT_EQ(bench.clock(), Duty(200)) << "to be handed over is not to fall back";
}

TEST(OpenLoopDuty, ARotorThatWasFollowedIsPulledInWithASixteenthOfTheStarts) {
  Bench bench;
  bench.in.follows = bench.in.sure = bench.in.fast = true;
  bench.pull_in();
  for (const bool lags : {false, true}) EXPECT_EQ(bench.step(lags), Duty(200));
  bench.in_state(State::kBrake);
  EXPECT_EQ(bench.clock(), Duty(500)) << "other states do not ask";
}

// 0xf83e and a thirty-second of it are 0xffff: from a start of 0xf83f, 194 %, no lag gets past the top.
TEST(OpenLoopDuty, NeverWrapsPastTheTop) {
  Bench bench;
  for (std::uint64_t start = 0xf000; start <= 0xf83f; ++start) {
    bench.in.start_duty = Duty::of(start);
    bench.pull_in();
    bench.step(false);
    for (int i = 0; i < 5; ++i) ASSERT_GE(bench.step(true).raw(), 0xe000u) << start;
  }
}

// Nor from any that counts twice.
TEST(OpenLoopDuty, NeverWrapsWhereItCountsTwice) {
  Bench bench;
  bench.in.strong = true;
  for (std::uint64_t start = 0x4000; start <= 0xffff; start += 0xff) {
    bench.in.start_duty = Duty::of(start);
    bench.pull_in();
    bench.step(false);
    for (int i = 0; i < 5; ++i) ASSERT_GE(bench.step(true).raw(), 0x7c00u) << start;
  }
}

}  // namespace
}  // namespace steplock
