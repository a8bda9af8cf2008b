// What a start that follows a rotor counts: the ticks of all its tries, and what gives it hope.
#include "tests/hls/counters_bench.hpp"

namespace steplock {
namespace {

using Bench = test::CountersBench;

// A start that follows has these ticks over all tries, and a verdict at the end of each 4096.
constexpr int kMost = 4 * 4096 - 2, kVerdict = kMost - 3 * 4096 + 1;  // ticks up to its first verdict

// What has seen no rotor move until then would not in as many again; one that moves is only slow.
TEST(StartCountersFollow, ARotorThatMovesHasFourTimesTheTicks) {
  Bench bench;
  bench.in.config.method = Method::kFollow;
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
TEST(StartCountersFollow, AllTriesThatFollowShareTheirTicks) {
  for (const bool hopeful : {false, true}) {
    Bench bench;
    bench.in.config.method = Method::kFollow;
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
      for (const State state : {State::kRetryDelay, State::kDetectSpin, State::kBrake, State::kPullIn}) bench.ticks_of(state);
      bench.enter(State::kRun);
      for (int i = 0; i < 900; ++i) bench.tick();
      return false;
    };
    int tries = 1;
    while (!follow(997)) ++tries;
    EXPECT_EQ(ticks, hopeful ? kMost : kVerdict);
    EXPECT_EQ(tries, ticks / 997 + 1);
    EXPECT_TRUE(bench.out.retries_exhausted);
    // A long run, like standstill, forgets them.
    bench.ticks_of(State::kRun);
    EXPECT_FALSE(follow(997));
    EXPECT_FALSE(bench.out.retries_exhausted);
  }
}

// A rotor that was turned round at that moment is, for some looks, not believed to move: of the 1024 ticks before a verdict any
// eighth counts, throughout which it moved.  One that its cogging holds moves for moments only.
TEST(StartCountersFollow, ARotorThatWentOnMovingInTheLastThousandTicksIsHopeful) {
  struct Case {
    int from, to;  // ticks before each verdict, in which it moved
    bool hopeful;
  };
  const Case cases[] = {{128, 1, true},    {126, 1, false},    {128, 2, false},    {129, 2, false},     {192, 64, false},
                        {256, 129, true},  {1024, 897, true},  {1022, 897, false}, {1024, 898, false},  {1152, 1025, false},
                        {1280, 900, false}, {4096, 1025, false}, {4096, 897, true}};
  for (const Case& c : cases) {
    Bench bench;
    bench.in.config.method = Method::kFollow;
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
TEST(StartCountersFollow, ARotorThatIsShakenIsNot) {
  for (const int moment : {1, 40, 126}) {
    Bench bench;
    bench.in.config.method = Method::kFollow;
    bench.enter(State::kAccelerate);
    for (int i = 0; i < kVerdict; ++i) {
      bench.in.hopeful = i % (moment + 1) != 0;
      ASSERT_FALSE(bench.tick()) << i;
    }
    EXPECT_TRUE(bench.out.retries_exhausted);
    EXPECT_TRUE(bench.tick());
  }
}

TEST(StartCountersFollow, ATryThatFollowsUntilNoTicksAreLeftIsTheLast) {
  for (const bool hopeful : {false, true}) {
    for (const Method method : {Method::kFollow, Method::kRamp}) {
      Bench bench;
      bench.enter(State::kIdle);
      bench.in.config.method = method;
      bench.in.hopeful = hopeful;
      bench.enter(State::kAccelerate);
      const int ticks = method != Method::kFollow ? 4095 : hopeful ? kMost : kVerdict;
      for (int i = 0; i < ticks; ++i) {
        ASSERT_FALSE(bench.tick());
        if (i < ticks - 1) {
          EXPECT_FALSE(bench.out.retries_exhausted);
        }
      }
      EXPECT_EQ(bench.out.retries_exhausted, method == Method::kFollow);
      EXPECT_TRUE(bench.tick());
      bench.enter(State::kRetryDelay);
      EXPECT_FALSE(bench.out.retries_exhausted);
    }
  }
}

}  // namespace
}  // namespace steplock
