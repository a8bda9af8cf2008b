// A start that follows the rotor, as the start sequence sees it: the follower's strobes come from here.
#include "tests/hls/start_bench.hpp"

namespace steplock {
namespace {

struct Bench : test::StartBench {
  Bench() {
    in.config.method = Method::kFollow;
    in.command.run = true;
  }
  // The follower's word that it has the rotor, in the middle of this step.
  StartSequence::Out caught(int step) {
    in.at = step;
    in.caught = in.follower_drives = true;
    auto out = clock();
    in.caught = false;
    return out;
  }
};

TEST(StartSequenceFollows, NeitherSettlesNorResets) {
  Bench bench;
  bench.until(State::kAccelerate);
  bench.caught(2);
  bench.until(State::kPullIn);
  for (int i = 0; i < 4; ++i) bench.crossing(true);
  bench.clock();
  EXPECT_EQ(bench.visited, (std::vector{State::kDetectSpin, State::kAccelerate, State::kPullIn, State::kRun}));
}

TEST(StartSequenceFollows, WithoutALookForARotorThatTurnsItBeginsAtOnce) {
  Bench bench;
  bench.in.config.detect_spin = 0;
  bench.until(State::kAccelerate);
  EXPECT_EQ(bench.visited, (std::vector{State::kAccelerate}));
}

TEST(StartSequenceFollows, TheBridgeDrivesWhenTheFollowerSaysSo) {
  Bench bench;
  EXPECT_EQ(bench.until(State::kAccelerate).pattern, (OneHot<Pattern, 5>(Pattern::kOff)));
  bench.in.follower_drives = true;
  EXPECT_EQ(bench.clock().pattern, (OneHot<Pattern, 5>(Pattern::kDrive)));
  bench.in.follower_drives = false;
  const auto out = bench.clock();
  EXPECT_EQ(out.pattern, (OneHot<Pattern, 5>(Pattern::kOff)));
  EXPECT_TRUE(out.enable && out.follow);
}

// What was measured before is forgotten in the state's first clock; then edges set the frequency.
TEST(StartSequenceFollows, TheLoopStopsForAClockAndThenFollows) {
  StartSequence dut;
  StartSequence::In in;
  in.command.configured = in.command.run = true;
  in.config.method = Method::kFollow;
  StartSequence::Out out;
  while (out.state != State::kAccelerate) out = dut.tick(in);
  EXPECT_EQ(out.loop, Loop::kStop);
  EXPECT_EQ(out.detector_source, DetectorSource::kNone);
  for (int i = 0; i < 3; ++i) {
    out = dut.tick(in);
    EXPECT_EQ(out.loop, Loop::kFollow);
    EXPECT_EQ(out.detector_source, DetectorSource::kSectors);
  }
}

TEST(StartSequenceFollows, HandsOverInTheMiddleOfThePresentStep) {
  Bench bench;
  bench.until(State::kAccelerate);
  const auto out = bench.caught(4);
  EXPECT_EQ(out.state, State::kPullIn);
  EXPECT_TRUE(out.load_step);
  EXPECT_EQ(out.step, Step(4));
  EXPECT_EQ(out.loop, Loop::kTrack);
}

// One tick for the duty of the pulling in, with which the control's integral begins.
TEST(StartSequenceFollows, ARotorThatIsHandedOverIsControlledFromTheSecondTickOn) {
  Bench bench;
  bench.until(State::kAccelerate);
  for (int tries = 0; tries < 2; ++tries) {
    EXPECT_EQ(bench.caught(4).mode, SpeedMode::kFeedForwardDrive);
    EXPECT_EQ(bench.clock().mode, SpeedMode::kFeedForwardDrive);
    EXPECT_EQ(bench.clock().mode, SpeedMode::kControl);
    bench.until(State::kRetryDelay);
    EXPECT_NE(bench.until(State::kAccelerate).mode, SpeedMode::kControl);
  }
}

TEST(StartSequenceFollows, ARotorThatNeverComesIsNotTriedAgain) {
  Bench bench;
  bench.until(State::kAccelerate);
  bench.until(State::kFault);
  EXPECT_EQ(bench.clock().reason, Reason::kNoLock);
}

TEST(StartSequenceFollows, ARotorThatMovesToTheEndIsNotTriedAgainEither) {
  Bench bench;
  bench.in.moves = true;
  bench.until(State::kAccelerate);
  int ticks = 0;
  while (bench.clock().state == State::kAccelerate && ticks < 20000) ++ticks;
  EXPECT_NEAR(ticks, 4 * 4096, 3);
  EXPECT_EQ(bench.clocks(20).state, State::kFault);
  EXPECT_EQ(bench.clock().reason, Reason::kNoLock);
}

TEST(StartSequenceFollows, ABlockedRotorFailsTheTryAtOnceAndIsTheReason) {
  Bench bench;
  for (int tries = 0; tries < 3; ++tries) {
    bench.until(State::kAccelerate);
    bench.in.blocked = true;
    bench.clock();
    bench.in.blocked = false;
    const auto out = bench.clock();
    EXPECT_EQ(out.state, tries < 2 ? State::kRetryDelay : State::kFault);
    EXPECT_EQ(out.reason, Reason::kBlocked);
  }
}

// The word may change in any clock; there is a state for whatever it says.
TEST(StartSequenceFollows, AMethodThatChangesDuringTheAlignmentIsTaken) {
  for (const State state : {State::kPreAlign, State::kAlign}) {
    Bench bench;
    bench.in.config.method = Method::kRamp;
    bench.until(state);
    bench.in.config.method = Method::kFollow;
    bench.clock();
    EXPECT_EQ(bench.clock().state, State::kAccelerate);
  }
}

}  // namespace
}  // namespace steplock
