#include "hls/six_step/start_sequence.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace steplock {
namespace {

// A sequence with short times, one tick per clock, and the inputs of a healthy drive.
struct Bench {
  StartSequence dut;
  StartSequence::In in;
  std::vector<State> visited;

  Bench() {
    in.tick = true;
    in.command.configured = true;
    in.words = {.settle = 3,
                .reset = 5,
                .reset_duty = 1000,
                .start_duty = 2000,
                .ramp = 100,
                .hand_over = 1000,
                .window = 0x4000,
                .good_crossings = 4,
                .pull_in = 20,
                .observe = 10,
                .slow_down = 30,
                .brake = 5,
                .brake_duty = 500,
                .rest = 6,
                .retries = 2};
  }

  // One clock; returns what the outputs are after it.
  StartSequence::Out clock() {
    dut.tick(in);
    in.update = false;
    auto after = dut;
    const auto out = after.tick(in);
    if (visited.empty() || visited.back() != out.state) visited.push_back(out.state);
    return out;
  }

  StartSequence::Out clocks(int n) {
    StartSequence::Out out;
    for (int i = 0; i < n; ++i) out = clock();
    return out;
  }

  // Until the state is reached; fails the test when it never is.
  StartSequence::Out until(State state) {
    StartSequence::Out out;
    for (int i = 0; i < 5000; ++i) {
      out = clock();
      if (out.state == state) return out;
    }
    ADD_FAILURE() << "state " << int(state) << " was not reached";
    return out;
  }

  void crossing(bool good) {
    in.update = true;
    in.good = good;
    clock();
  }

  StartSequence::Out move(bool reverse, int sector) {
    in.update = in.good = true;
    in.turns_reverse = reverse;
    in.sector = sector;
    clock();
    return clock();
  }

  void run() {
    in.command.run = true;
    in.fast = false;
    until(State::kAccelerate);
    in.fast = true;
    until(State::kPullIn);
    for (int i = 0; i < 4; ++i) crossing(true);
    clock();
  }
};

TEST(StartSequence, StaysOffUntilConfigured) {
  Bench bench;
  bench.in.command.configured = false;
  bench.in.command.run = true;
  for (int i = 0; i < 100; ++i) ASSERT_FALSE(bench.clock().enable);
}

TEST(StartSequence, StartsThroughAllItsStates) {
  Bench bench;
  bench.run();
  EXPECT_EQ(bench.visited,
            (std::vector{State::kObserve, State::kSettle, State::kReset, State::kAccelerate,
                         State::kPullIn, State::kRun}));
}

TEST(StartSequence, EachFailedTryMakesTheRampGentlerThreeTimes) {
  Bench bench;
  bench.in.words.retries = 6;
  bench.in.command.run = true;
  for (const int gentle : {0, 1, 2, 3, 3, 3, 3}) {
    bench.in.fast = false;
    EXPECT_EQ(bench.until(State::kAccelerate).gentle, UInt<2>(gentle));
    bench.in.fast = true;
    bench.until(State::kPullIn);
    bench.clocks(20);  // no crossing comes in time
  }
  EXPECT_EQ(bench.clocks(2).state, State::kFault);
}

TEST(StartSequence, KeepsTheGatesOffWhileItObserves) {
  Bench bench;
  bench.in.command.run = true;
  const auto out = bench.until(State::kObserve);
  EXPECT_FALSE(out.enable);
  EXPECT_EQ(out.pattern, Pattern::kOff);
  EXPECT_EQ(out.loop, Loop::kCatch);
}

TEST(StartSequence, LeavesTheResetPositionByTheStepOfFullTorque) {
  for (const bool reverse : {false, true}) {
    Bench bench;
    bench.in.command.run = true;
    bench.in.command.reverse = reverse;
    const auto out = bench.until(State::kAccelerate);
    EXPECT_TRUE(out.load_step);
    EXPECT_FALSE(bench.clock().load_step);
    EXPECT_EQ(out.step, UInt<3>(reverse ? 0 : 3));
    EXPECT_EQ(out.reverse, reverse);
  }
}

TEST(StartSequence, RampsFromStandstillAndClosesTheLoopAtHandOver) {
  Bench bench;
  bench.in.command.run = true;
  EXPECT_EQ(bench.until(State::kReset).loop, Loop::kStop);
  auto out = bench.until(State::kAccelerate);
  EXPECT_EQ(out.loop, Loop::kRamp);
  EXPECT_EQ(bench.clocks(100).state, State::kAccelerate);
  bench.in.fast = true;
  out = bench.clock();
  EXPECT_EQ(out.state, State::kPullIn);
  EXPECT_EQ(out.loop, Loop::kTrack);
}

TEST(StartSequence, FadesItsTorquePerStepWhilePullingIn) {
  Bench bench;
  bench.in.command.run = true;
  bench.until(State::kAccelerate);
  bench.in.fast = true;
  EXPECT_EQ(bench.until(State::kPullIn).duty, Duty(2000));
  bench.in.commutate = true;
  bench.clock();
  bench.in.commutate = false;
  EXPECT_EQ(bench.clock().duty, Duty(2000 - 2000 / 32));
  EXPECT_EQ(bench.clock().duty, Duty(2000 - 2000 / 32));
}

TEST(StartSequence, GivesALaggingRotorItsTorqueBackPerStep) {
  Bench bench;
  bench.in.command.run = true;
  bench.until(State::kAccelerate);
  bench.in.fast = true;
  bench.until(State::kPullIn);
  bench.in.commutate = true;
  bench.clocks(10);
  bench.in.lags = true;
  const Duty faded = bench.clock().duty;
  const Duty more = bench.clock().duty;
  EXPECT_EQ(more, Duty(faded.raw() + (faded.raw() >> 5)));
  // As much as the start's, and a thirty-second more at most.
  Duty last = more;
  for (int n = 0; n < 7; ++n) last = bench.clock().duty;
  EXPECT_LE(last, Duty(2000 + 2000 / 32));
  EXPECT_GE(last, Duty(1800));
}

TEST(StartSequence, ARampThatNeverArrivesIsAFailedTry) {
  Bench bench;
  bench.in.command.run = true;
  bench.until(State::kAccelerate);
  EXPECT_EQ(bench.until(State::kRest).reason, Reason::kNoLock);
}

TEST(StartSequence, ABadCrossingBeginsTheCountAgain) {
  Bench bench;
  bench.in.command.run = true;
  bench.in.fast = true;
  bench.until(State::kPullIn);
  for (int i = 0; i < 3; ++i) bench.crossing(true);
  bench.crossing(false);
  for (int i = 0; i < 3; ++i) bench.crossing(true);
  EXPECT_EQ(bench.clock().state, State::kPullIn);
  bench.crossing(true);
  EXPECT_EQ(bench.clock().state, State::kRun);
}

TEST(StartSequence, CatchesARotorThatTurnsTheWantedWay) {
  for (const bool reverse : {false, true}) {
    Bench bench;
    bench.in.command.run = true;
    bench.in.command.reverse = reverse;
    bench.in.words.observe = 100;
    bench.until(State::kObserve);
    StartSequence::Out out;
    for (int i = 0; i < 5 && out.state != State::kRun; ++i) out = bench.move(reverse, 2);
    EXPECT_EQ(out.state, State::kRun);
    EXPECT_TRUE(out.load_step);
    // Forward the rotor has just entered sector 2: it is in the middle of step 1.  docs/theory.md
    EXPECT_EQ(out.step, UInt<3>(reverse ? 2 : 1));
  }
}

TEST(StartSequence, BrakesARotorThatTurnsTheOtherWayAndLooksAgain) {
  Bench bench;
  bench.in.command.run = true;
  bench.until(State::kObserve);
  for (int i = 0; i < 5; ++i) bench.move(true, 5 - i);
  const auto out = bench.clock();
  EXPECT_EQ(out.state, State::kBrake);
  EXPECT_EQ(out.pattern, Pattern::kBrake);
  EXPECT_EQ(out.duty, Duty(500));
  bench.until(State::kObserve);
  bench.until(State::kSettle);
}

TEST(StartSequence, ARotorThatNeverStopsIsAFaultInTheEnd) {
  Bench bench;
  bench.in.command.run = true;
  bench.in.words.observe = 100;
  for (int brakes = 0; brakes < 255; ++brakes) {
    bench.until(State::kObserve);
    for (int i = 0; i < 5; ++i) bench.move(true, 1);
    ASSERT_EQ(bench.visited.back(), State::kBrake);
  }
  bench.until(State::kObserve);
  for (int i = 0; i < 5; ++i) bench.move(true, 1);
  const auto out = bench.clock();
  EXPECT_EQ(out.state, State::kFault);
  EXPECT_EQ(out.reason, Reason::kCannotStop);
}

TEST(StartSequence, TriesAsOftenAsItMayAndThenLatchesTheReason) {
  Bench bench;
  bench.in.command.run = true;
  bench.in.fast = true;
  int failures = 0;
  StartSequence::Out out;
  for (int i = 0; i < 1000 && out.state != State::kFault; ++i) {
    out = bench.clock();
    failures += out.failed;
  }
  EXPECT_EQ(failures, 3);  // the first try and two retries
  EXPECT_EQ(out.reason, Reason::kNoLock);
  EXPECT_FALSE(out.enable);
  for (int i = 0; i < 1000; ++i) ASSERT_EQ(bench.clock().state, State::kFault);
}

TEST(StartSequence, ALostLockRestsAndStartsAgain) {
  Bench bench;
  bench.run();
  bench.in.lost = true;
  bench.in.cause = Reason::kStepOut;
  auto out = bench.until(State::kRest);
  EXPECT_FALSE(out.enable);
  EXPECT_EQ(out.reason, Reason::kStepOut);
  bench.in.lost = false;
  bench.until(State::kObserve);
}

TEST(StartSequence, ALongLockForgivesEarlierFailures) {
  Bench bench;
  bench.in.words.retries = 1;
  for (int i = 0; i < 4; ++i) {
    bench.run();
    bench.clocks(1100);
    bench.in.lost = true;
    bench.until(State::kRest);
    bench.in.lost = false;
  }
  bench.run();  // and a short one does not
  bench.in.lost = true;
  bench.until(State::kFault);
}

TEST(StartSequence, AFatalCauseLatchesInAnyState) {
  for (int clocks = 0; clocks < 60; ++clocks) {
    Bench bench;
    bench.in.command.run = true;
    bench.clocks(clocks);
    bench.in.fatal = true;
    bench.in.cause = Reason::kFaultPin;
    const auto out = bench.clock();
    ASSERT_EQ(out.state, State::kFault) << clocks;
    ASSERT_EQ(out.reason, Reason::kFaultPin);
    ASSERT_FALSE(out.enable);
  }
}

TEST(StartSequence, AFaultIsLeftOnlyByARisingClearWithRunLowAndTheCauseGone) {
  Bench bench;
  bench.in.command.clear_fault = true;  // held from before: no edge
  bench.in.fatal = true;
  bench.clock();
  bench.in.fatal = false;
  EXPECT_EQ(bench.clocks(10).state, State::kFault);

  const auto clear = [&] {
    bench.in.command.clear_fault = false;
    bench.clock();
    bench.in.command.clear_fault = true;
    return bench.clock().state;
  };
  bench.in.command.run = true;
  EXPECT_EQ(clear(), State::kFault);
  bench.in.command.run = false;
  bench.in.fatal = true;
  EXPECT_EQ(clear(), State::kFault);
  bench.in.fatal = false;
  EXPECT_EQ(clear(), State::kIdle);
}

TEST(StartSequence, ReversesThroughSlowingBrakingAndLooking) {
  Bench bench;
  bench.run();
  bench.in.fast = true;
  bench.in.command.reverse = true;
  auto out = bench.until(State::kSlowDown);
  EXPECT_TRUE(out.stop);
  EXPECT_FALSE(out.reverse);  // it still turns forward
  EXPECT_EQ(bench.clocks(20).state, State::kSlowDown);
  bench.in.fast = false;
  bench.until(State::kBrake);
  bench.until(State::kObserve);
  out = bench.until(State::kAccelerate);
  EXPECT_TRUE(out.reverse);
}

TEST(StartSequence, RunLowCoastsAtOnceOrBrakesToAStop) {
  Bench coast;
  coast.run();
  coast.in.command.run = false;
  const auto out = coast.clock();
  EXPECT_EQ(out.state, State::kIdle);
  EXPECT_FALSE(out.enable);

  Bench brake;
  brake.run();
  brake.in.command.brake_to_stop = true;
  brake.in.command.run = false;
  brake.until(State::kSlowDown);
  brake.until(State::kBrake);
  brake.until(State::kObserve);
  brake.until(State::kIdle);
}

TEST(StartSequence, HallSensorsNeedNoStart) {
  Bench bench;
  bench.in.source = Source::kHall;
  bench.in.command.run = true;
  EXPECT_EQ(bench.clocks(2).state, State::kRun);
}

}  // namespace
}  // namespace steplock
