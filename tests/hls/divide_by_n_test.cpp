#include "hls/six_step/divide_by_n.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace steplock {
namespace {

// Six steps take N pulses, whatever N is, and each commutation comes with the pulse that ends a
// step.
TEST(DivideByN, CountsNPulsesForEveryN) {
  for (int divide = 0; divide < 4; ++divide) {
    DivideByN dut;
    int commutations = 0;
    const int n = 6 << divide;
    for (int pulse = 1; pulse <= 5 * n; ++pulse) {
      const auto out = dut.tick({.pulse = true, .divide = divide});
      commutations += out.commutate;
      EXPECT_EQ(out.commutate, pulse % (1 << divide) == 0);
      EXPECT_EQ(int(out.step.raw()), (pulse >> divide) % 6);
      EXPECT_FALSE(dut.tick({.divide = divide}).commutate);
    }
    EXPECT_EQ(commutations, 5 * 6);
  }
}

TEST(DivideByN, CountsDownInReverse) {
  DivideByN dut;
  const int expected[] = {5, 4, 3, 2, 1, 0};
  for (const int step : expected) {
    EXPECT_EQ(dut.tick({.pulse = true, .reverse = true}).step, Step(step));
  }
}

TEST(DivideByN, StepPhaseJoinsTheTurnsCountedAndTheVcosPhase) {
  DivideByN dut;
  dut.tick({.pulse = true, .divide = 2});
  // One turn of four and a half of the next: 3/8 of the step.
  EXPECT_EQ(dut.tick({.phase = 0x8000, .divide = 2}).phase, Phase(0x6000));
}

TEST(DivideByN, StepPhaseEqualsTheVcosPhaseWhenNIsSix) {
  DivideByN dut;
  EXPECT_EQ(dut.tick({.phase = 0xABCD}).phase, Phase(0xABCD));
}

TEST(DivideByN, TheDividedSignalIsHighForTheFirstHalfTurn) {
  DivideByN dut;
  const bool expected[] = {true, true, false, false, false, true};
  for (const bool high : expected) EXPECT_EQ(DivideByN::turn(dut.tick({.pulse = true}).step), high);
}

TEST(DivideByN, LoadWinsOverAPulseAndBeginsAStep) {
  for (int divide = 0; divide < 4; ++divide) {
    DivideByN dut;
    const bool half = true;
    const Phase vco_half = divide == 0 ? 0x8000 : 0;
    dut.tick({.pulse = true, .divide = divide, .load = true, .step = 4, .half = half});
    const auto out = dut.tick({.phase = vco_half, .divide = divide});
    EXPECT_EQ(out.step, Step(4));
    EXPECT_EQ(out.phase, Phase(0x8000)) << "the middle of the step, N = " << (6 << divide);
  }
  DivideByN dut;
  EXPECT_TRUE(dut.tick({.load = true, .step = 1}).commutate);
}

TEST(DivideByN, HoldKeepsTheStepButReportsElapsedTurns) {
  DivideByN dut;
  const auto out = dut.tick({.pulse = true, .hold = true});
  EXPECT_EQ(out.step, Step(0));
  EXPECT_FALSE(out.commutate);
  EXPECT_TRUE(out.elapsed);
}

// However words and strobes change from clock to clock, the step stays one of six and moves by one.
RC_GTEST_PROP(DivideByN, StepStaysOneOfSixAndMovesByOne, ()) {
  DivideByN dut;
  int before = 0;
  for (int i = 0; i < 500; ++i) {
    const bool reverse = *rc::gen::arbitrary<bool>();
    const auto out = dut.tick({.pulse = *rc::gen::arbitrary<bool>(),
                               .divide = *rc::gen::inRange(0, 4),
                               .reverse = reverse,
                               .hold = *rc::gen::arbitrary<bool>()});
    const int step = int(out.step.raw());
    RC_ASSERT(step < 6);
    RC_ASSERT(step == (out.commutate ? (before + (reverse ? 5 : 1)) % 6 : before));
    before = step;
  }
}

// Loads between turns, in any clock: still one of six.
RC_GTEST_PROP(DivideByN, StepStaysOneOfSixWithLoads, ()) {
  DivideByN dut;
  for (int i = 0; i < 500; ++i) {
    const auto out = dut.tick({.pulse = *rc::gen::arbitrary<bool>(),
                               .divide = *rc::gen::inRange(0, 4),
                               .reverse = *rc::gen::arbitrary<bool>(),
                               .hold = *rc::gen::arbitrary<bool>(),
                               .load = *rc::gen::arbitrary<bool>(),
                               .step = *rc::gen::inRange(0, 6)});
    RC_ASSERT(out.step < 6);
  }
}

}  // namespace
}  // namespace steplock
