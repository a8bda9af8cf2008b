// What a schedule does in its clocks, whatever it computes.

#include "hls/numeric/scheduled.hpp"

#include <gtest/gtest.h>

namespace steplock {
namespace {

class Sum {
 public:
  struct In {
    Int<8> x = 0;
  };
  struct Out {
    Int<16> sum = 7;
  };
  Out tick(const In& in) {
    sum_ = wrap<Int<16>>(sum_ + in.x);
    return {sum_};
  }

 private:
  Int<16> sum_ = 100;
};

constexpr int kClocks = 5;
using Dut = Scheduled<Sum, Budget{.clocks = kClocks}>;

Dut::In start(int x) {
  Dut::In in;
  in.x = x;
  in.start = true;
  return in;
}
Dut::In nothing(int x = -50) {
  auto in = start(x);
  in.start = false;
  return in;
}

TEST(Scheduled, DoneComesItsClocksAfterTheStart) {
  Dut dut;
  EXPECT_FALSE(dut.tick(start(3)).busy);
  for (int clock = 1; clock < kClocks; ++clock) {
    const auto out = dut.tick(nothing());
    EXPECT_TRUE(out.busy) << clock;
    EXPECT_FALSE(out.done) << clock;
    EXPECT_EQ(out.sum, 7) << "the old result stays until done";
  }
  const auto out = dut.tick(nothing());
  EXPECT_TRUE(out.done);
  EXPECT_FALSE(out.busy);
  EXPECT_EQ(out.sum, 103) << "of the input at the start, not of those after it";
  EXPECT_FALSE(dut.tick(nothing()).done) << "one clock";
  EXPECT_EQ(dut.tick(nothing()).sum, 103);
}

// A block some of whose outputs come first: they are those of the same sample, and the state moves once.
class SumInTwo {
 public:
  using In = Sum::In;
  struct Out {
    struct {
      Int<16> sum = 7;
    } early;
    Int<16> late = 7;
  };
  Out tick(const In& in) {
    sum_ = wrap<Int<16>>(sum_ + in.x);
    return {{sum_}, sum_};
  }

 private:
  Int<16> sum_ = 100;
};

TEST(Scheduled, EarlyOutputsComeTheirClocksAfterTheStart) {
  constexpr int kEarly = 3;
  Scheduled<SumInTwo, Budget{.clocks = kClocks, .early = kEarly}> dut;
  for (int sample = 1; sample < 4; ++sample) {
    const int was = sample == 1 ? 7 : 97 + 3 * sample, is = 100 + 3 * sample;
    decltype(dut)::In in;
    in.x = 3;
    in.start = true;
    dut.tick(in);
    in.x = -50;
    in.start = false;
    for (int clock = 1; clock <= kClocks; ++clock) {
      const auto out = dut.tick(in);
      EXPECT_EQ(out.early.sum, clock < kEarly ? was : is) << clock;
      EXPECT_EQ(out.late, clock < kClocks ? was : is) << clock;
    }
  }
}

TEST(Scheduled, AStartWhileBusyIsMissedAndChangesNothing) {
  Dut dut, undisturbed;
  dut.tick(start(3));
  undisturbed.tick(start(3));
  for (int clock = 1; clock < kClocks; ++clock) {
    const bool before = dut.tick(start(99)).missed;
    EXPECT_EQ(before, clock > 1) << "the clock after, one by one";
    undisturbed.tick(nothing());
  }
  const auto out = dut.tick(nothing());
  EXPECT_TRUE(out.missed);
  EXPECT_TRUE(out.done);
  EXPECT_EQ(out.sum, undisturbed.tick(nothing()).sum);
  EXPECT_FALSE(dut.tick(nothing()).missed);
}

TEST(Scheduled, TheNextStartMayComeWithDone) {
  Dut dut;
  int sum = 100;
  for (int sample = 1; sample <= 10; ++sample) {
    const auto out = dut.tick(start(sample));
    EXPECT_EQ(out.done, sample > 1);
    EXPECT_FALSE(out.missed);
    if (sample > 1) {
      EXPECT_EQ(out.sum, sum);
    }
    sum += sample;
    for (int clock = 1; clock < kClocks; ++clock) dut.tick(nothing());
  }
}

TEST(Scheduled, WithoutAStartNothingHappens) {
  Dut dut;
  for (int clock = 0; clock < 3 * kClocks; ++clock) {
    const auto out = dut.tick(nothing());
    EXPECT_FALSE(out.done || out.busy || out.missed);
    EXPECT_EQ(out.sum, 7);
  }
}

}  // namespace
}  // namespace steplock
