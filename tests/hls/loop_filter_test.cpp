#include "hls/six_step/loop_filter.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

namespace steplock {
namespace {

using In = LoopFilter::In;

constexpr double kTurn = 4294967296.0;       // u0.32
constexpr double kFine = 1.0 / (1LL << 36);  // the last bit of x, v and y, turns per clock
constexpr int kSlowest = 200;                // clocks, more than six products

Frequency settle(LoopFilter& dut, const In& in) {
  LoopFilter::Out out;
  for (int i = 0; i < kSlowest; ++i) out = dut.tick(in);
  EXPECT_FALSE(out.busy);
  return out.frequency;
}

// One update (or tick), worked on to its end.
Frequency update(LoopFilter& dut, In in) {
  dut.tick(in);  // a new `loop` counts from the next clock on
  in.update = in.tick = true;
  dut.tick(in);
  in.update = in.tick = false;
  return settle(dut, in);
}

// A filter that stands at this frequency: a ramp has taken it there.
LoopFilter at(double frequency) {
  LoopFilter dut;
  auto left = std::int64_t(frequency * kTurn);
  while (left > 0) {
    const auto ramp = std::min<std::int64_t>(left, 1 << 19);
    update(dut, {.loop = Loop::kRamp, .ramp = ramp, .maximum = Frequency::max()});
    left -= ramp;
  }
  return dut;
}

In track() {
  return {.loop = Loop::kTrack, .alpha = 0x8000, .maximum = Frequency::max()};
}

// A constant error e makes x_n = x_0 + n A and v_n = x_n + B with A = ki e s, B = kp e s.  Behind
// the pole a that is y_n = x_0 + n A + C (1 - (1-a)^n), C = B - A (1-a)/a.  Each update truncates p
// by one last bit, ki and kp (below 4) multiply that, and each product truncates once more: x is
// off by at most 5 n bits and v by 5 more; the pole's two products add two bits to what it forgets
// by a.  s and the pole are taken where all their bits count.
RC_GTEST_PROP(LoopFilter, StepResponseIsTheDiscretisedLagLeadFilters, ()) {
  auto in = track();
  in.bandwidth = Bandwidth::kPerSecond;
  in.scale = *rc::gen::inRange(1 << 6, 1 << 16) * 16;
  in.ki = *rc::gen::inRange(1, 1 << 12);
  in.kp = *rc::gen::inRange(1, 1 << 16);
  in.alpha = *rc::gen::inRange(1 << 9, (1 << 14) + 1) * 2;
  in.error = *rc::gen::inRange(1, 1 << 14);

  const double start = std::ldexp(1.0, -10);
  const double s = double(in.scale.raw()) / kTurn, e = double(in.error.raw()) / 65536;
  const double A = double(in.ki.raw()) / 16384 * e * s, B = double(in.kp.raw()) / 16384 * e * s;
  const double a = double(in.alpha.raw()) / 32768, C = B - A * (1 - a) / a;

  auto dut = at(start);
  for (int n = 1; n <= 40; ++n) {
    const double y = double(update(dut, in).raw()) / kTurn;
    const double analytic = start + n * A + C * (1 - std::pow(1 - a, n));
    // The output shows 32 of the 36 bits.
    RC_ASSERT(std::abs(y - analytic) < 1 / kTurn + (5 * n + 5 + 2 / a) * kFine);
  }
}

// Per step the same error moves the frequency by the same part of itself.
TEST(LoopFilter, PerStepTheGainFollowsTheFrequency) {
  auto in = track();
  in.ki = 0x0400;  // 1/16
  in.kp = 0;
  in.error = 0x1000;  // 1/16
  for (const double f : {1e-6, 1e-4, 1e-3}) {
    auto dut = at(f);
    const double moved = double(update(dut, in).raw()) / kTurn / f - 1;
    EXPECT_NEAR(moved, 1.0 / 256, 2 / (f * kTurn)) << f;
  }
}

TEST(LoopFilter, PerSecondTheHeldErrorIntegratesOnTicksAlone) {
  auto in = track();
  in.bandwidth = Bandwidth::kPerSecond;
  in.scale = 1 << 16;
  in.ki = 0x4000;
  in.error = 0x4000;
  auto dut = at(1e-3);
  const auto before = settle(dut, in);
  in.update = true;
  dut.tick(in);
  in.update = false;
  EXPECT_EQ(settle(dut, in), before);
  EXPECT_EQ(update(dut, in) - before, Frequency(1 << 14));
}

// 100 clocks of delay at 1/1000 turn per clock are a tenth of a turn: with that the error vanishes,
// but for its last bit and the product's, which ki + kp = 2 pass on.
TEST(LoopFilter, ConstantDelayIsTakenBack) {
  auto in = track();
  in.ki = in.kp = 0x4000;
  in.delay = 100;
  in.error = -6554;
  auto dut = at(1e-3);
  EXPECT_NEAR(double(update(dut, in).raw()) / kTurn, 1e-3, 2 * 2e-3 / 65536 + 1 / kTurn);
}

TEST(LoopFilter, TheErrorCountsAsItStandsAtTheUpdate) {
  auto in = track();
  in.ki = in.kp = 0x4000;
  in.error = 0x1000;
  auto dut = at(1e-3), changed = dut, other = dut;
  const Frequency wanted = update(dut, in);
  changed.tick(in);
  in.update = true;
  changed.tick(in);
  in.update = false;
  in.error = -0x1000;
  EXPECT_EQ(settle(changed, in), wanted);
  EXPECT_NE(update(other, in), wanted) << "the control";
}

TEST(LoopFilter, TheOutputStaysWithinItsLimits) {
  auto in = track();
  in.ki = in.kp = 0x8000;
  in.minimum = 1000;
  in.maximum = 500000;
  auto dut = at(300000 / kTurn);
  in.error = PhaseError::max();
  EXPECT_EQ(update(dut, in), Frequency(500000));
  in.error = PhaseError::min();
  for (int i = 0; i < 10; ++i) EXPECT_LE(update(dut, in), Frequency(500000));
  in.error = 0;
  EXPECT_EQ(update(dut, in), Frequency(1000));
}

// However long the output stood at its limit, the first errors of the other sign move it off.
TEST(LoopFilter, DoesNotWindUpAtALimit) {
  auto in = track();
  in.ki = 0x0400;
  in.kp = 0x4000;
  in.maximum = 1 << 20;
  auto dut = at((1 << 19) / kTurn);
  in.error = 0x4000;
  for (int i = 0; i < 1000; ++i) update(dut, in);
  in.error = -0x1000;
  const auto first = update(dut, in);
  EXPECT_LT(first, Frequency(1 << 20));
  // The integrator itself never passed what the output showed.
  in.error = 0;
  EXPECT_LT(update(dut, in), Frequency(1 << 20));
}

// Without a proportional part the output is the integrator: two errors of the other sign, of one that was held against
// the limit fifty times, and it is below it.
TEST(LoopFilter, TheIntegratorStandsAtTheLimitItReached) {
  for (const bool top : {true, false}) {
    auto in = track();
    in.bandwidth = Bandwidth::kPerSecond;
    in.scale = 1 << 16;
    in.ki = 0x4000;
    const int limit = 1 << 20, step = 1 << 14;
    top ? in.maximum = limit : in.minimum = limit;
    auto dut = at((limit + (top ? -3 : 3) * step) / kTurn);
    in.error = top ? 0x4000 : -0x4000;
    for (int i = 0; i < 50; ++i) update(dut, in);
    ASSERT_EQ(update(dut, in), Frequency(limit)) << top;
    in.error = top ? -0x4000 : 0x4000;
    update(dut, in);
    const auto left = int(update(dut, in).raw());
    EXPECT_NEAR(left, limit + (top ? -1 : 1) * step, step) << top;
    EXPECT_NE(left, limit);
  }
}

TEST(LoopFilter, ARampGrowsPerTickFromStandstillBelowTheMinimum) {
  LoopFilter dut;
  const In in = {
      .loop = Loop::kRamp, .ramp = 1234, .minimum = 1 << 20, .maximum = Frequency::max()};
  for (int n = 1; n <= 20; ++n) EXPECT_EQ(update(dut, in), Frequency(1234 * n));
}

TEST(LoopFilter, AGentleRampIsQuarteredThreeTimes) {
  for (int backoff = 0; backoff < 4; ++backoff) {
    LoopFilter dut;
    const In in = {.loop = Loop::kRamp, .ramp = 1234, .backoff = backoff, .maximum = Frequency::max()};
    // Four bits more than the frequency shows: at the last quarter two are lost, once per tick.
    for (int n = 1; n <= 20; ++n) {
      const double wanted = 1234.0 * n / (1 << 2 * backoff);
      const double lost = backoff == 3 ? n / 16.0 : 0;
      const auto is = static_cast<double>(update(dut, in).raw());
      EXPECT_LE(is, wanted);
      EXPECT_GT(is, wanted - 1 - lost);
    }
  }
}

TEST(LoopFilter, StopDropsTheWorkInFlight) {
  auto in = track();
  in.kp = 0x4000;
  in.error = 0x4000;
  auto dut = at(1e-3);
  in.update = true;
  dut.tick(in);
  in.update = false;
  for (int i = 0; i < 50; ++i) dut.tick(in);
  in.loop = Loop::kStop;
  dut.tick(in);
  in.loop = Loop::kTrack;
  EXPECT_EQ(settle(dut, in), Frequency(0));
}

TEST(LoopFilter, SaysWhenItTurnsSlowerThanAStallAndWhenAsFastAsHandOver) {
  for (const int more : {0, 1}) {
    LoopFilter dut;
    const In in = {.loop = Loop::kRamp, .ramp = 1000, .maximum = Frequency::max(),
                   .hand_over = 3000 + more, .stall = 2000 + more};
    update(dut, in);
    EXPECT_TRUE(dut.tick(in).slow);
    update(dut, in);
    EXPECT_EQ(dut.tick(in).slow, more == 1);
    EXPECT_FALSE(dut.tick(in).fast);
    update(dut, in);
    EXPECT_FALSE(dut.tick(in).slow);
    EXPECT_EQ(dut.tick(in).fast, more == 0);
  }
}

// The first change finds the frequency at its minimum, each that follows may raise it by half.  A
// rotor slower than the minimum never shows a small error.
TEST(LoopFilter, CatchesFromStandstillButNothingSlowerThanTheMinimum) {
  LoopFilter dut;
  In in = {.loop = Loop::kCatchSpin, .minimum = 1 << 19, .maximum = Frequency::max()};
  in.error = PhaseError::max();
  EXPECT_EQ(update(dut, in), Frequency(1 << 19));
  // 3/2 but for the last bit of the largest error.
  EXPECT_NEAR(double(update(dut, in).raw()), 3 << 18, 1 << 4);
  in.error = PhaseError::min();
  for (int i = 0; i < 5; ++i) update(dut, in);
  EXPECT_EQ(update(dut, in), Frequency(1 << 19));
}

// e = 1 - f T with the interval T: the error squares itself at each change of sector.
RC_GTEST_PROP(LoopFilter, CatchingConvergesToOneOverTheInterval, ()) {
  const double interval = *rc::gen::inRange(1000, 1000000);
  auto f = *rc::gen::inRange(50, 200) / 100.0 / interval;
  auto dut = at(f);
  for (int change = 0; change < 8; ++change) {
    const double e = std::clamp(1 - f * interval, -0.5, 0.49998);
    const In in = {.loop = Loop::kCatchSpin,
                   .error = PhaseError(std::int32_t(std::floor(e * 65536))),
                   .alpha = 0x8000,
                   .maximum = Frequency::max()};
    f = double(update(dut, in).raw()) / kTurn;
  }
  // What is left is the last bit of the error, 2^-16, and of the frequency.
  RC_ASSERT(std::abs(f * interval - 1) < 2.0 / 65536 + 2 * interval / kTurn);
}

// Following a rotor begins at hand-over, with whatever error; from there it is catching, and the minimum is the bound.
TEST(LoopFilter, FollowingBeginsAtHandOverAndThenIsCatching) {
  In in{.loop = Loop::kFollow, .error = 0x7fff, .minimum = 1000, .maximum = Frequency::max(), .hand_over = 1 << 20};
  LoopFilter dut;
  EXPECT_EQ(update(dut, in), Frequency(1 << 20));
  in.error = -0x8000;
  EXPECT_EQ(update(dut, in), Frequency(1 << 19)) << "half";
  for (int i = 0; i < 12; ++i) update(dut, in);
  EXPECT_EQ(update(dut, in), Frequency(1000));
  In stop = in;
  stop.loop = Loop::kStop;
  settle(dut, stop);
  EXPECT_EQ(update(dut, in), Frequency(1 << 20)) << "and again";
}

// However soon after a result the next update comes, it takes the same clocks to the same frequency.
TEST(LoopFilter, AnUpdateMayComeInAnyClockAfterAResult) {
  for (const Loop loop : {Loop::kTrack, Loop::kCatchSpin}) {
    LoopFilter::In in{.loop = loop, .error = 0x800, .ki = 0x400, .kp = 0x1000, .minimum = 1000, .maximum = Frequency::max()};
    LoopFilter settled;
    const auto update = [&in](LoopFilter& dut) {
      in.update = true;
      dut.tick(in);
      in.update = false;
      int clocks = 0;
      while (dut.tick(in).busy) ++clocks;
      return clocks;
    };
    settled.tick(in);
    for (int i = 0; i < 5; ++i) update(settled);
    LoopFilter rested = settled;
    for (int i = 0; i < 100; ++i) rested.tick(in);
    const int clocks = update(rested);
    EXPECT_GT(clocks, 24 * 3);
    for (int rest = 0; rest < 60; ++rest) {
      LoopFilter dut = settled;
      for (int i = 0; i < rest; ++i) dut.tick(in);
      EXPECT_EQ(update(dut), clocks) << rest << " clocks after the result";
      EXPECT_EQ(dut.tick(in).frequency, rested.tick(in).frequency);
    }
  }
}

}  // namespace
}  // namespace steplock
