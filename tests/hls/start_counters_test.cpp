#include "tests/hls/counters_bench.hpp"

namespace steplock {
namespace {

using Bench = test::CountersBench;

TEST(StartCounters, AStateLastsItsTicksAndWhatIsLeftOfTheOneBefore) {
  Bench bench;
  EXPECT_EQ(bench.ticks_of(State::kDetectSpin), 10 + 1);
  EXPECT_EQ(bench.ticks_of(State::kBrake), 7 + 1);
  EXPECT_EQ(bench.ticks_of(State::kPreAlign), 3 + 1);
  EXPECT_EQ(bench.ticks_of(State::kAlign), 5 + 1);
  EXPECT_EQ(bench.ticks_of(State::kAccelerate), 4095 + 1);
  EXPECT_EQ(bench.ticks_of(State::kPullIn), 20 + 1);
  EXPECT_EQ(bench.ticks_of(State::kSlowDown), 30 + 1);
  EXPECT_EQ(bench.ticks_of(State::kRetryDelay), 6 + 1);
  EXPECT_EQ(bench.ticks_of(State::kRun), 1024 + 1);
}

TEST(StartCounters, IsOverWithATickOnly) {
  Bench bench;
  bench.ticks_of(State::kRetryDelay);
  for (int i = 0; i < 100; ++i) {
    bench.clock();
    ASSERT_FALSE(bench.out.timed_out);
  }
  EXPECT_TRUE(bench.tick());
}

TEST(StartCounters, ATickInTheStatesFirstClockCountsAndEndsNothing) {
  Bench bench;
  bench.ticks_of(State::kRetryDelay);  // is over with every tick from here on
  bench.in.state = State::kPreAlign;
  bench.in.entered = bench.in.tick = true;
  bench.clock();
  EXPECT_FALSE(bench.out.timed_out);
  bench.clocks(4);
  EXPECT_FALSE(bench.tick());
  EXPECT_FALSE(bench.tick());
  EXPECT_TRUE(bench.tick());
}

TEST(StartCounters, ATickBehindTheStatesFirstClockFindsTheNewTime) {
  Bench bench;
  bench.ticks_of(State::kRetryDelay);
  bench.in.state = State::kPreAlign;
  bench.in.entered = true;
  bench.clock();
  EXPECT_FALSE(bench.tick());
}

TEST(StartCounters, FailedTriesDoubleSettleResetAndAccelerateThreeTimesAndNothingElse) {
  Bench bench;
  for (const int factor : {1, 2, 4, 8, 8}) {
    EXPECT_EQ(bench.ticks_of(State::kPreAlign), 3 * factor + 1);
    EXPECT_EQ(bench.ticks_of(State::kAlign), 5 * factor + 1);
    EXPECT_EQ(bench.ticks_of(State::kAccelerate), 4095 * factor + 1);
    EXPECT_EQ(bench.ticks_of(State::kPullIn), 20 + 1);
    EXPECT_EQ(bench.ticks_of(State::kRetryDelay), 6 + 1);
    bench.fail();
  }
}

TEST(StartCounters, TellsFailedTriesUpToThree) {
  Bench bench;
  bench.enter(State::kRetryDelay);
  for (const int backoff : {0, 1, 2, 3, 3, 3}) {
    bench.clock();
    EXPECT_EQ(bench.out.backoff, UInt<2>(backoff));
    EXPECT_EQ(bench.out.strong, backoff > 1);
    bench.fail();
  }
}

TEST(StartCounters, NoTriesAreLeftAfterAsManyFailuresAsTheWordSays) {
  for (const int retries : {0, 1, 2, 15}) {
    Bench bench;
    bench.in.config.retries = UInt<4>(retries);
    bench.enter(State::kRetryDelay);
    for (int i = 0; i < retries; ++i) {
      EXPECT_FALSE(bench.out.retries_exhausted);
      bench.fail();
    }
    bench.clock();
    EXPECT_TRUE(bench.out.retries_exhausted);
  }
}

TEST(StartCounters, StandstillAndALongRunForgetFailures) {
  Bench bench;
  bench.enter(State::kRetryDelay);
  bench.fail();
  bench.fail();
  bench.enter(State::kRun);
  for (int i = 0; i < 1024; ++i) bench.tick();
  EXPECT_EQ(bench.out.backoff, UInt<2>(2));
  EXPECT_TRUE(bench.out.retries_exhausted);
  bench.tick();
  EXPECT_EQ(bench.out.backoff, UInt<2>(0));
  EXPECT_FALSE(bench.out.retries_exhausted);

  bench.enter(State::kRetryDelay);
  bench.fail();
  bench.fail();
  bench.enter(State::kIdle);
  EXPECT_EQ(bench.out.backoff, UInt<2>(0));
}

TEST(StartCounters, ARotorIsUnstoppableAfter255BrakingIntervalsSinceALockOrStandstill) {
  for (const State forgets : {State::kRun, State::kIdle}) {
    Bench bench;
    const auto brake = [&] {
      bench.enter(State::kDetectSpin);
      bench.in.braking = true;
      bench.enter(State::kBrake);
      bench.clocks(2);
      return bench.out.brakes_exhausted;
    };
    for (int i = 0; i < 100; ++i) ASSERT_FALSE(brake());
    bench.enter(forgets);
    for (int i = 0; i < 254; ++i) ASSERT_FALSE(brake()) << i;
    EXPECT_TRUE(brake());
  }
}

TEST(StartCounters, AsManyGoodCrossingsInARowAsTheWordSaysAreEnough) {
  for (const int needed : {1, 4, 63}) {
    Bench bench;
    bench.in.config.good_crossings = UInt<6>(needed);
    bench.enter(State::kPullIn);
    for (int i = 0; i < needed - 1; ++i) ASSERT_FALSE(bench.crossing(true)) << i;
    EXPECT_TRUE(bench.crossing(true));
  }
}

TEST(StartCounters, ABadCrossingOrANewStateBeginsTheCountAgain) {
  Bench bench;
  bench.enter(State::kPullIn);
  EXPECT_FALSE(bench.crossings(3, true));
  EXPECT_FALSE(bench.crossing(false));
  EXPECT_FALSE(bench.crossings(3, true));
  bench.enter(State::kPullIn);
  EXPECT_FALSE(bench.crossings(3, true));
  bench.in.entered = true;  // in the clock of what would have been the fourth
  EXPECT_FALSE(bench.crossing(true));
  EXPECT_FALSE(bench.crossings(3, true));
  EXPECT_TRUE(bench.crossing(true));
}

TEST(StartCounters, WhileObservingAChangeOfDirectionBeginsTheCountAgain) {
  Bench bench;
  bench.enter(State::kDetectSpin);
  EXPECT_FALSE(bench.crossings(3, true, false));
  EXPECT_FALSE(bench.crossing(true, true));
  EXPECT_TRUE(bench.out.turns_reverse);
  EXPECT_FALSE(bench.crossings(3, true, true));
  EXPECT_TRUE(bench.crossing(true, true));

  bench.enter(State::kPullIn);  // where the decoder's direction means nothing
  for (int i = 0; i < 3; ++i) EXPECT_FALSE(bench.crossing(true, i % 2 == 0));
  EXPECT_TRUE(bench.crossing(true, true));
}

}  // namespace
}  // namespace steplock
