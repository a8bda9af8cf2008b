#include "hls/six_step/start_counters.hpp"

#include <gtest/gtest.h>

#include <utility>

namespace steplock {
namespace {

// A state machine that does as it is told, with a tick in every fifth clock.
struct Bench {
  StartCounters dut;
  StartCounters::In in;
  StartCounters::Out out;  // of the last clock

  Bench() {
    in.words = {.settle = 3, .reset = 5, .good_crossings = 4, .pull_in = 20, .observe = 10, .slow_down = 30, .brake = 7, .rest = 6,
                .retries = 2};
  }

  void clock() {
    out = dut.tick(in);
    in.tick = in.entered = in.failed = in.braking = in.update = false;
  }
  void clocks(int n) {
    for (int i = 0; i < n; ++i) clock();
  }
  void enter(State state) {
    in.state = state;
    in.entered = true;
    clocks(2);
  }
  // Whether the state is over with it.
  bool tick() {
    in.tick = true;
    clock();
    const bool over = out.over;
    clocks(4);
    return over;
  }
  // Ticks up to the one with which it is, 0 if there is none such in `most`.
  int ticks_of(State state, int most = 100'000) {
    enter(state);
    for (int i = 1; i <= most; ++i) {
      if (tick()) return i;
    }
    return 0;
  }
  void fail() {
    in.failed = true;
    clocks(4);
  }
  // Whether they are enough with this one: in the clock after it, and in no other.
  bool crossing(bool good, bool turns_reverse = false) {
    in.update = true;
    in.good = good;
    in.turns_reverse = turns_reverse;
    clock();
    EXPECT_FALSE(out.enough);
    clock();
    const bool enough = out.enough;
    clock();
    EXPECT_FALSE(out.enough);
    return enough;
  }
  bool crossings(int n, bool good, bool turns_reverse = false) {
    bool enough = false;
    for (int i = 0; i < n; ++i) enough = crossing(good, turns_reverse);
    return enough;
  }
};

TEST(StartCounters, AStateLastsItsTicksAndWhatIsLeftOfTheOneBefore) {
  Bench bench;
  const std::pair<State, int> lengths[] = {{State::kObserve, 10}, {State::kBrake, 7}, {State::kSettle, 3}, {State::kReset, 5},
                                           {State::kAccelerate, 4095}, {State::kPullIn, 20}, {State::kSlowDown, 30}, {State::kRest, 6},
                                           {State::kRun, 1024}};
  for (const auto& [state, ticks] : lengths) EXPECT_EQ(bench.ticks_of(state), ticks + 1) << int(state);
}

TEST(StartCounters, IsOverWithATickOnly) {
  Bench bench;
  bench.ticks_of(State::kRest);
  for (int i = 0; i < 100; ++i) {
    bench.clock();
    ASSERT_FALSE(bench.out.over);
  }
  EXPECT_TRUE(bench.tick());
}

TEST(StartCounters, ATickInTheStatesFirstClockCountsAndEndsNothing) {
  Bench bench;
  bench.ticks_of(State::kRest);  // is over with every tick from here on
  bench.in.state = State::kSettle;
  bench.in.entered = bench.in.tick = true;
  bench.clock();
  EXPECT_FALSE(bench.out.over);
  bench.clocks(4);
  EXPECT_FALSE(bench.tick());
  EXPECT_FALSE(bench.tick());
  EXPECT_TRUE(bench.tick());
}

TEST(StartCounters, ATickBehindTheStatesFirstClockFindsTheNewTime) {
  Bench bench;
  bench.ticks_of(State::kRest);
  bench.in.state = State::kSettle;
  bench.in.entered = true;
  bench.clock();
  EXPECT_FALSE(bench.tick());
}

TEST(StartCounters, FailedTriesDoubleSettleResetAndAccelerateThreeTimesAndNothingElse) {
  Bench bench;
  for (const int factor : {1, 2, 4, 8, 8}) {
    EXPECT_EQ(bench.ticks_of(State::kSettle), 3 * factor + 1);
    EXPECT_EQ(bench.ticks_of(State::kReset), 5 * factor + 1);
    EXPECT_EQ(bench.ticks_of(State::kAccelerate), 4095 * factor + 1);
    EXPECT_EQ(bench.ticks_of(State::kPullIn), 20 + 1);
    EXPECT_EQ(bench.ticks_of(State::kRest), 6 + 1);
    bench.fail();
  }
}

TEST(StartCounters, TellsFailedTriesUpToThree) {
  Bench bench;
  bench.enter(State::kRest);
  for (const int gentle : {0, 1, 2, 3, 3, 3}) {
    bench.clock();
    EXPECT_EQ(bench.out.gentle, UInt<2>(gentle));
    EXPECT_EQ(bench.out.strong, gentle > 1);
    bench.fail();
  }
}

TEST(StartCounters, NoTriesAreLeftAfterAsManyFailuresAsTheWordSays) {
  for (const int retries : {0, 1, 2, 15}) {
    Bench bench;
    bench.in.words.retries = UInt<4>(retries);
    bench.enter(State::kRest);
    for (int i = 0; i < retries; ++i) {
      EXPECT_FALSE(bench.out.tried);
      bench.fail();
    }
    bench.clock();
    EXPECT_TRUE(bench.out.tried);
  }
}

// A start that follows has these ticks over all tries, and a verdict at the end of each 4096.
constexpr int kMost = 4 * 4096 - 2, kVerdict = kMost - 3 * 4096 + 1;  // ticks up to its first verdict

// What has seen no rotor move until then would not in as many again; one that moves is only slow.
TEST(StartCounters, ARotorThatMovesHasFourTimesTheTicks) {
  Bench bench;
  bench.in.words.method = Method::kFollow;
  bench.enter(State::kIdle);
  EXPECT_EQ(bench.ticks_of(State::kAccelerate), kVerdict + 1);
  bench.enter(State::kIdle);
  bench.in.hopeful = true;
  EXPECT_EQ(bench.ticks_of(State::kAccelerate), kMost + 1);
  // It is asked each time: a rotor that was lost may be found again until then.
  for (int verdict = 0; verdict < 2; ++verdict) {
    bench.enter(State::kIdle);
    bench.in.hopeful = true;
    bench.enter(State::kAccelerate);
    for (int i = 0; i < kVerdict + 1 + 4096 * verdict; ++i) ASSERT_FALSE(bench.tick()) << i;
    bench.in.hopeful = false;
    for (int i = 1; i < 4096; ++i) ASSERT_FALSE(bench.tick()) << i << verdict;
    EXPECT_TRUE(bench.tick()) << verdict;
  }
}

// So a rotor that nothing turns, and that noise lets no try give up, ends in its fault in time, however often it is tried.
TEST(StartCounters, AllTriesThatFollowShareTheirTicks) {
  for (const bool hopeful : {false, true}) {
    Bench bench;
    bench.in.words.method = Method::kFollow;
    bench.enter(State::kIdle);
    int ticks = 0;
    const auto follow = [&](int most) {
      bench.in.hopeful = hopeful;
      bench.enter(State::kAccelerate);
      for (int i = 0; i < most; ++i, ++ticks) {
        if (bench.tick()) return true;
      }
      // What comes between takes none of them, and what gave hope is not forgotten.
      bench.in.hopeful = false;
      bench.fail();
      for (const State state : {State::kRest, State::kObserve, State::kBrake, State::kPullIn}) bench.ticks_of(state);
      bench.enter(State::kRun);
      for (int i = 0; i < 900; ++i) bench.tick();
      return false;
    };
    int tries = 1;
    while (!follow(997)) ++tries;
    EXPECT_EQ(ticks, hopeful ? kMost : kVerdict);
    EXPECT_EQ(tries, ticks / 997 + 1);
    EXPECT_TRUE(bench.out.tried);
    // A long run, like standstill, forgets them.
    bench.ticks_of(State::kRun);
    EXPECT_FALSE(follow(997));
    EXPECT_FALSE(bench.out.tried);
  }
}

// A rotor that was turned round at that moment is, for some looks, not believed to move: of the 1024 ticks before a verdict any
// eighth counts, throughout which it moved.  One that its cogging holds moves for moments only.
TEST(StartCounters, ARotorThatWentOnMovingInTheLastThousandTicksIsHopeful) {
  struct Case {
    int from, to;  // ticks before each verdict, in which it moved
    bool hopeful;
  };
  const Case cases[] = {{128, 1, true},    {126, 1, false},    {128, 2, false},    {129, 2, false},     {192, 64, false},
                        {256, 129, true},  {1024, 897, true},  {1022, 897, false}, {1024, 898, false},  {1152, 1025, false},
                        {1280, 900, false}, {4096, 1025, false}, {4096, 897, true}};
  for (const Case& c : cases) {
    Bench bench;
    bench.in.words.method = Method::kFollow;
    bench.enter(State::kIdle);
    bench.enter(State::kAccelerate);
    const auto moves = [&](int from, int to) {  // ticks left
      for (int left = from; left > to; --left) {
        const int before = (left + 4095) % 4096 + 1;
        bench.in.hopeful = before <= c.from && before >= c.to;
        ASSERT_FALSE(bench.tick()) << left;
      }
      bench.in.hopeful = false;
    };
    moves(kMost, kMost - kVerdict);
    const bool goes_on = !bench.tick();
    EXPECT_EQ(goes_on, c.hopeful) << c.from << ' ' << c.to;
    if (!goes_on) continue;
    moves(kMost - kVerdict - 1, 0);
    EXPECT_TRUE(bench.tick());
  }
}

// Edges to and fro, however many.
TEST(StartCounters, ARotorThatIsShakenIsNot) {
  for (const int moment : {1, 40, 126}) {
    Bench bench;
    bench.in.words.method = Method::kFollow;
    bench.enter(State::kAccelerate);
    for (int i = 0; i < kVerdict; ++i) {
      bench.in.hopeful = i % (moment + 1) != 0;
      ASSERT_FALSE(bench.tick()) << i;
    }
    EXPECT_TRUE(bench.out.tried && bench.tick());
  }
}

TEST(StartCounters, ATryThatFollowsUntilNoTicksAreLeftIsTheLast) {
  for (const bool hopeful : {false, true}) {
    for (const Method method : {Method::kFollow, Method::kRamp}) {
      Bench bench;
      bench.enter(State::kIdle);
      bench.in.words.method = method;
      bench.in.hopeful = hopeful;
      bench.enter(State::kAccelerate);
      const int ticks = method != Method::kFollow ? 4095 : hopeful ? kMost : kVerdict;
      for (int i = 0; i < ticks; ++i) {
        ASSERT_FALSE(bench.tick());
        ASSERT_TRUE(i == ticks - 1 || !bench.out.tried) << i;
      }
      EXPECT_EQ(bench.out.tried, method == Method::kFollow);
      EXPECT_TRUE(bench.tick());
      bench.enter(State::kRest);
      EXPECT_FALSE(bench.out.tried);
    }
  }
}

TEST(StartCounters, StandstillAndALongRunForgetFailures) {
  Bench bench;
  bench.enter(State::kRest);
  bench.fail();
  bench.fail();
  bench.enter(State::kRun);
  for (int i = 0; i < 1024; ++i) bench.tick();
  EXPECT_EQ(bench.out.gentle, UInt<2>(2));
  EXPECT_TRUE(bench.out.tried);
  bench.tick();
  EXPECT_EQ(bench.out.gentle, UInt<2>(0));
  EXPECT_FALSE(bench.out.tried);

  bench.enter(State::kRest);
  bench.fail();
  bench.fail();
  bench.enter(State::kIdle);
  EXPECT_EQ(bench.out.gentle, UInt<2>(0));
}

TEST(StartCounters, ARotorIsUnstoppableAfter255BrakingIntervalsSinceALockOrStandstill) {
  for (const State forgets : {State::kRun, State::kIdle}) {
    Bench bench;
    const auto brake = [&] {
      bench.enter(State::kObserve);
      bench.in.braking = true;
      bench.enter(State::kBrake);
      bench.clocks(2);
      return bench.out.braked;
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
    bench.in.words.good_crossings = UInt<6>(needed);
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
  bench.enter(State::kObserve);
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
