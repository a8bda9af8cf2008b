// Failed tries, lost locks, latched faults of hls/six_step/start_sequence.hpp.
#include "tests/hls/start_bench.hpp"

namespace steplock {
namespace {

using Bench = test::StartBench;

TEST(StartSequence, EachFailedTryMakesTheRampGentlerThreeTimes) {
  Bench bench;
  bench.in.config.retries = 6;
  bench.in.command.run = true;
  for (const int backoff : {0, 1, 2, 3, 3, 3, 3}) {
    bench.in.fast = false;
    EXPECT_EQ(bench.until(State::kAccelerate).backoff, UInt<2>(backoff));
    bench.in.fast = true;
    bench.until(State::kPullIn);
    bench.clocks(20);  // no crossing comes in time
  }
  EXPECT_EQ(bench.clocks(2).state, State::kFault);
}

// 3 and 5 ticks: a rotor too heavy for them still swings at their end.
TEST(StartSequence, EachFailedTryDoublesSettleAndResetThreeTimes) {
  Bench bench;
  bench.in.config.retries = 6;
  bench.in.command.run = true;
  for (const int factor : {1, 2, 4, 8, 8}) {
    int settle = 0, reset = 0;
    bench.in.fast = false;
    bench.until(State::kPreAlign);
    for (State s = State::kPreAlign; s != State::kAccelerate; s = bench.clock().state) {
      (s == State::kPreAlign ? settle : reset) += 1;
    }
    EXPECT_EQ(settle, 3 * factor + 1);
    EXPECT_EQ(reset, 5 * factor + 1);
    bench.in.fast = true;
    bench.until(State::kPullIn);
    bench.clocks(20);
  }
}

TEST(StartSequence, FromTheThirdTryOnTheStartHasTwiceTheDutyUpToTheWhole) {
  Bench bench;
  bench.in.config.retries = 6;
  bench.in.config.align_duty = 0x1800;
  bench.in.config.start_duty = 0x7000;  // twice as much is more than the whole
  bench.in.command.run = true;
  for (const bool twice : {false, false, true, true, true}) {
    bench.in.fast = false;
    EXPECT_EQ(bench.until(State::kPreAlign).duty, Duty(twice ? 0x3000 : 0x1800));
    EXPECT_EQ(bench.until(State::kAlign).duty, Duty(twice ? 0x3000 : 0x1800));
    bench.until(State::kAccelerate);
    EXPECT_EQ(bench.clock().duty, Duty(twice ? 0x8000 : 0x7000));
    bench.in.fast = true;
    bench.until(State::kPullIn);
    bench.clocks(20);
  }
}

TEST(StartSequence, TheLongestResetCanBeDoubledThreeTimes) {
  Bench bench;
  bench.in.config.retries = 6;
  bench.in.config.align = Ticks::max();
  bench.in.command.run = true;
  for (const int factor : {1, 2, 4, 8}) {
    bench.in.fast = false;
    bench.until(State::kAlign);
    EXPECT_EQ(bench.clocks(factor * int(Ticks::max().raw())).state, State::kAlign);
    EXPECT_EQ(bench.clock().state, State::kAccelerate);
    bench.in.fast = true;
    bench.until(State::kPullIn);
    bench.clocks(20);
  }
}

TEST(StartSequence, ARampThatNeverArrivesIsAFailedTry) {
  Bench bench;
  bench.in.command.run = true;
  bench.until(State::kAccelerate);
  EXPECT_EQ(bench.until(State::kRetryDelay).reason, Reason::kNoLock);
}

TEST(StartSequence, ARotorThatNeverStopsIsAFaultInTheEnd) {
  Bench bench;
  bench.in.command.run = true;
  bench.in.config.detect_spin = 100;
  for (int brakes = 0; brakes < 255; ++brakes) {
    bench.until(State::kDetectSpin);
    for (int i = 0; i < 5; ++i) bench.move(true, 1);
    ASSERT_EQ(bench.visited.back(), State::kBrake);
  }
  bench.until(State::kDetectSpin);
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
  auto out = bench.until(State::kRetryDelay);
  EXPECT_FALSE(out.enable);
  EXPECT_EQ(out.reason, Reason::kStepOut);
  bench.in.lost = false;
  bench.until(State::kDetectSpin);
}

TEST(StartSequence, ALongLockForgivesEarlierFailures) {
  Bench bench;
  bench.in.config.retries = 1;
  for (int i = 0; i < 4; ++i) {
    bench.run();
    bench.clocks(1100);
    bench.in.lost = true;
    bench.until(State::kRetryDelay);
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

}  // namespace
}  // namespace steplock
