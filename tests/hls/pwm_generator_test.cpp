#include "hls/bridge/pwm_generator.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <vector>

namespace steplock {
namespace {

using In = PwmGenerator::In;

// One period as seen at the outputs.
struct Period {
  int length = 0;
  int on = 0;      // clocks
  int lead = -1;   // first clock that is on
  int edges = 0;   // changes of the pulse inside the period
  bool tick = false;
};

// Runs until a period starts, then records that one, up to the start of the next.
class Recorder {
 public:
  explicit Recorder(const In& in) : in_(in) { next(); }

  Period next() {
    Period period = begun_;
    for (int clocks = 0; clocks < 40000; ++clocks) {
      const auto out = dut_.tick(in_);
      if (out.start) {
        begun_ = {.length = 1, .on = out.on, .lead = out.on ? 0 : -1, .tick = out.tick};
        last_ = out.on;
        return period;
      }
      if (out.on && period.lead < 0) period.lead = period.length;
      period.edges += out.on != last_;
      last_ = out.on;
      ++period.length;
      period.on += out.on;
    }
    return {};
  }

  // The first period that was made of these words alone.
  Period with(const In& in) {
    in_ = in;
    next();
    next();
    return next();
  }

 private:
  PwmGenerator dut_;
  In in_;
  Period begun_;
  bool last_ = false;
};

Period settled(const In& in) { return Recorder(in).with(in); }

TEST(PwmGenerator, TheFirstPeriodAfterTheResetIsAWholeOne) {
  for (const int period : {1, 2, 3, 4, 5, 100, 101}) {
    PwmGenerator dut;
    std::vector<int> starts;
    for (int clock = 0; clock < 3 * period + 10; ++clock) {
      if (dut.tick({.on_clocks = 1, .period = period}).start) starts.push_back(clock);
    }
    ASSERT_GE(starts.size(), 3u) << period;
    EXPECT_EQ(starts[1] - starts[0], period);
    EXPECT_EQ(starts[2] - starts[1], period);
  }
}

// The contract in one line each, against the counters of the block.
int expected_on(const In& in) {
  const int on = int(in.on_clocks.raw());
  const int period = int(in.period.raw());
  const int minimum = int(in.minimum.raw());
  if (on < minimum) return 0;
  return on >= period || period - on < minimum ? period : on;
}

TEST(PwmGenerator, EveryPulseOfShortPeriodsHasItsLengthAndItsPlace) {
  for (int period = 1; period <= 9; ++period) {
    for (int on = 0; on <= 11; ++on) {
      for (int minimum = 0; minimum <= 5; ++minimum) {
        for (const bool centred : {false, true}) {
          const In in = {.on_clocks = on, .period = period, .minimum = minimum, .centred = centred};
          const auto seen = settled(in);
          const int length = expected_on(in);
          SCOPED_TRACE(testing::Message() << "period " << period << " on " << on << " minimum "
                                          << minimum << " centred " << centred);
          ASSERT_EQ(seen.length, period);
          ASSERT_EQ(seen.on, length);
          ASSERT_EQ(seen.lead, length == 0 ? -1 : centred ? (period - length) / 2 : 0);
          ASSERT_LE(seen.edges, 2);
        }
      }
    }
  }
}

RC_GTEST_PROP(PwmGenerator, EveryPulseOfLongPeriodsHasItsLengthAndItsPlace, ()) {
  const int period = *rc::gen::inRange(1, 16384);
  const In in = {.on_clocks = *rc::gen::inRange(0, 16384),
                 .period = period,
                 .minimum = *rc::gen::inRange(0, 300),
                 .centred = *rc::gen::arbitrary<bool>()};
  const auto seen = settled(in);
  const int length = expected_on(in);
  RC_ASSERT(seen.length == period);
  RC_ASSERT(seen.on == length);
  RC_ASSERT(seen.lead == (length == 0 ? -1 : in.centred ? (period - length) / 2 : 0));
}

TEST(PwmGenerator, AHundredPercentHasNoGapFromPeriodToPeriod) {
  for (const bool centred : {false, true}) {
    PwmGenerator dut;
    const In in = {.on_clocks = 100, .period = 100, .centred = centred};
    for (int i = 0; i < 102; ++i) dut.tick(in);
    for (int i = 0; i < 1000; ++i) ASSERT_TRUE(dut.tick(in).on) << i;
  }
}

TEST(PwmGenerator, ZeroIsNeverOn) {
  PwmGenerator dut;
  for (int i = 0; i < 1000; ++i) ASSERT_FALSE(dut.tick({.on_clocks = 0, .period = 100}).on) << i;
}

TEST(PwmGenerator, ComingDownFromAHundredPercentTheCentredPulseWaitsForItsPlace) {
  const In full = {.on_clocks = 100, .period = 100, .centred = true};
  const In half = {.on_clocks = 40, .period = 100, .centred = true};
  Recorder recorder(full);
  recorder.with(full);
  const auto seen = recorder.with(half);
  EXPECT_EQ(seen.lead, 30);
  EXPECT_EQ(seen.on, 40);
}

TEST(PwmGenerator, PeriodZeroIsOffAndPicksTheWordsUpWithinThreeClocks) {
  PwmGenerator dut;
  for (int i = 0; i < 100; ++i) {
    const auto out = dut.tick({.on_clocks = 50, .period = 0});
    ASSERT_FALSE(out.on || out.start || out.tick);
  }
  const In in = {.on_clocks = 50, .period = 100};
  for (int i = 0; i < 2; ++i) ASSERT_FALSE(dut.tick(in).start);
  const auto out = dut.tick(in);
  EXPECT_TRUE(out.start);
  EXPECT_TRUE(out.on);
}

// A period is what its last clock before it said: words that change within it are not seen.
RC_GTEST_PROP(PwmGenerator, AWordThatChangesWithinAPeriodDoesNotTouchIt, ()) {
  PwmGenerator dut;
  const In in = {.on_clocks = *rc::gen::inRange(0, 50),
                 .period = 50,
                 .minimum = *rc::gen::inRange(0, 10),
                 .centred = *rc::gen::arbitrary<bool>()};
  for (int i = 0; i < 4; ++i) dut.tick(in);  // into the first period that is made of them
  PwmGenerator calm = dut;
  for (int i = 0; i < 40; ++i) {
    const In other = {.on_clocks = *rc::gen::inRange(0, 16384),
                      .period = *rc::gen::inRange(0, 16384),
                      .minimum = *rc::gen::inRange(0, 16384),
                      .centred = *rc::gen::arbitrary<bool>()};
    RC_ASSERT(dut.tick(other).on == calm.tick(in).on);
  }
}

TEST(PwmGenerator, TicksComeEveryTickPeriodsAndZeroCountsAsOne) {
  for (const int every : {0, 1, 2, 3, 255}) {
    const In in = {.on_clocks = 3, .period = 5, .tick_periods = every};
    Recorder recorder(in);
    while (!recorder.next().tick) {
    }
    for (int round = 0; round < 3; ++round) {
      for (int i = 1; i < every; ++i) ASSERT_FALSE(recorder.next().tick);
      ASSERT_TRUE(recorder.next().tick);
    }
  }
}

TEST(PwmGenerator, IsOffInReset) {
  PwmGenerator dut;
  const auto out = dut.tick({.on_clocks = 100, .period = 100});
  EXPECT_FALSE(out.on || out.start || out.tick);
}

}  // namespace
}  // namespace steplock
