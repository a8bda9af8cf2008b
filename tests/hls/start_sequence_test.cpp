// The way to a lock, and back; what goes wrong on it: start_sequence_failures_test.cpp.
#include <algorithm>

#include "tests/hls/start_bench.hpp"

namespace steplock {
namespace {

using Bench = test::StartBench;

TEST(StartSequence, StaysOffUntilConfigured) {
  Bench bench;
  bench.in.command.configured = false;
  bench.in.command.run = true;
  for (int i = 0; i < 100; ++i) ASSERT_FALSE(bench.clock().enable);
}

TEST(StartSequence, WordsThatBecomeValidUnderARunThatIsUpStartNothing) {
  Bench bench;
  bench.in.command.configured = false;
  bench.in.command.run = true;
  bench.clock();
  bench.in.command.configured = true;
  for (int i = 0; i < 100; ++i) ASSERT_EQ(bench.clock().state, State::kIdle);
  bench.in.command.run = false;
  bench.clock();
  bench.in.command.run = true;
  bench.until(State::kDetectSpin);
}

// Both in one clock is a wish to start.
TEST(StartSequence, ARunThatRisesWithItsWordsStarts) {
  Bench bench;
  bench.in.command.configured = false;
  bench.clock();
  bench.in.command.configured = bench.in.command.run = true;
  bench.until(State::kDetectSpin);
}

TEST(StartSequence, ASetSpeedOfNothingIsABrakedStopAndStartsNothing) {
  Bench bench;
  bench.in.still = bench.in.command.run = true;
  for (int i = 0; i < 100; ++i) ASSERT_EQ(bench.clock().state, State::kIdle);
  bench.in.still = false;
  bench.run();
  bench.in.still = true;
  bench.until(State::kSlowDown);
  bench.until(State::kBrake);
  bench.until(State::kDetectSpin);
  bench.until(State::kIdle);
  bench.in.still = false;
  bench.until(State::kDetectSpin);
}

TEST(StartSequence, StartsThroughAllItsStates) {
  Bench bench;
  bench.run();
  EXPECT_EQ(bench.visited,
            (std::vector{State::kDetectSpin, State::kPreAlign, State::kAlign, State::kAccelerate,
                         State::kPullIn, State::kRun}));
}

TEST(StartSequence, KeepsTheGatesOffWhileItObserves) {
  Bench bench;
  bench.in.command.run = true;
  const auto out = bench.until(State::kDetectSpin);
  EXPECT_FALSE(out.enable);
  EXPECT_EQ(out.pattern, Pattern::kOff);
  EXPECT_EQ(out.loop, Loop::kCatchSpin);
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
  EXPECT_EQ(bench.until(State::kAlign).loop, Loop::kStop);
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
  bench.in.config.pull_in = 200;
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
  // Until it is as much as the start's: the last step may pass that by a thirty-second.
  const Duty last = bench.clocks(30).duty;
  EXPECT_GE(last, Duty(2000));
  EXPECT_LE(last, Duty(2000 + 2000 / 32));
  EXPECT_EQ(bench.clocks(30).duty, last);
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
    bench.in.config.detect_spin = 100;
    bench.until(State::kDetectSpin);
    StartSequence::Out out;
    for (int i = 0; i < 5 && out.state != State::kRun; ++i) out = bench.move(reverse, 2);
    EXPECT_EQ(out.state, State::kRun);
    EXPECT_TRUE(out.load_step);
    // Forward the rotor has just entered sector 2: it is in the middle of step 1.  docs/theory.md
    EXPECT_EQ(out.step, UInt<3>(reverse ? 2 : 1));
  }
}

// In speed control it would end as a stall, attempt by attempt.  A ramp needs one that turns the other way braked.
TEST(StartSequence, StartsARotorThatTurnsTheWantedWaySlowerThanItMayRun) {
  for (const bool backward : {false, true}) {
    Bench bench;
    bench.in.command.run = true;
    bench.in.slow = true;
    bench.in.config.detect_spin = 100;
    bench.until(State::kDetectSpin);
    for (int i = 0; i < 8; ++i) bench.move(backward, i % 6);
    EXPECT_EQ(bench.clock().state, backward ? State::kBrake : State::kDetectSpin);
    if (!backward) bench.until(State::kPreAlign);
    EXPECT_TRUE(std::ranges::find(bench.visited, State::kRun) == bench.visited.end());
  }
}

TEST(StartSequence, BrakesARotorThatTurnsTheOtherWayAndLooksAgain) {
  Bench bench;
  bench.in.command.run = true;
  bench.until(State::kDetectSpin);
  for (int i = 0; i < 5; ++i) bench.move(true, 5 - i);
  const auto out = bench.clock();
  EXPECT_EQ(out.state, State::kBrake);
  EXPECT_EQ(out.pattern, Pattern::kBrake);
  EXPECT_EQ(out.duty, Duty(500));
  EXPECT_EQ(out.mode, SpeedMode::kFeedForwardBrake);
  EXPECT_EQ(out.loop, Loop::kCatchSpin) << "the frequency found is kept: the brake's duty is less that of the back-EMF";
  EXPECT_EQ(out.detector_source, DetectorSource::kNone);
  bench.until(State::kDetectSpin);
  bench.until(State::kPreAlign);
}

// A follower turns it round with the limit's current; a brake of one duty hardly slows what is slow already.
TEST(StartSequence, AFollowerTurnsRoundWhatIsSlowerThanHandOverUnlessItIsToStop) {
  enum { kSlow, kFast, kToStop, kNoSetSpeed };
  for (const int what : {kSlow, kFast, kToStop, kNoSetSpeed}) {
    Bench bench;
    bench.in.command.run = true;
    bench.in.config.method = Method::kFollow;
    bench.in.config.detect_spin = 100;
    bench.until(State::kDetectSpin);
    bench.in.command.brake_to_stop = what == kToStop;
    bench.in.command.run = what != kToStop;
    bench.in.still = what == kNoSetSpeed;
    bench.in.fast = what == kFast;
    for (int i = 0; i < 5; ++i) bench.move(true, 5 - i);
    EXPECT_EQ(bench.clock().state, what == kSlow ? State::kDetectSpin : State::kBrake) << what;
    if (what == kSlow) {
      bench.until(State::kAccelerate);
      EXPECT_TRUE(std::ranges::find(bench.visited, State::kBrake) == bench.visited.end());
    }
  }
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
  bench.until(State::kDetectSpin);
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
  brake.until(State::kDetectSpin);
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
