// What the wires of the top promise: its pattern, its latencies, and gates that obey.  The drive in
// closed loop, with motors, is in tests/testbench/sinusoidal_engines_test.cpp.

#include "hls/sinusoidal/sinusoidal_top.hpp"

#include <gtest/gtest.h>

#include <random>

namespace steplock {
namespace {

class Bench {
 public:
  SinusoidalTop::In in;
  SinusoidalTop::Out out;

  Bench() {
    auto& w = in.config;
    w.bridge = {.period = 1200, .minimum = 12, .dead_time = 12, .dead_time_loss = 192, .compensate = true,
                .reciprocal = 9321};
    w.estimator = {.decay = 3113, .gain = 3686, .k_theta = 3277, .k_e = 541, .k_speed = 5894};
    w.speed = {.target = 1 << 22, .slew = 4000, .filter = 983, .k_p = 700, .k_i = 530,
               .limit = 12288, .lock = 1000, .slow = 100, .stop = 1000, .emf_low = 3277,
               .emf_high = 20480};
    w.control = {.k_p = 1092, .k_i = 831, .inductance = 892, .emf = 1425, .limit = 18919};
    w.sequence = {.hold_voltage = 2000, .pattern = 20, .lock = 400, .give_up = 1000, .brake = 10,
                  .retry_delay = 10, .retries = 1};
    w.fault = {.over_current = 30000, .saturated = 0, .lost_samples = 3};
    in.command.configured = in.command.run = true;
  }

  // Codes come in the clock after the strobe.
  void tick() {
    in.codes.valid = out.sample;
    in.codes.u = u, in.codes.v = v, in.codes.dc = 2700;
    out = top_.tick(in);
    const Gates& g = out.gates;
    ASSERT_FALSE((g.uh && g.ul) || (g.vh && g.vl) || (g.wh && g.wl));
  }
  int clocks_until(auto&& met) {
    for (int n = 1; n < 200'000; ++n) {
      tick();
      if (met(out)) return n;
    }
    return 0;
  }
  bool off() const { return out.gates == Gates{}; }

  int u = 0, v = 0;

 private:
  SinusoidalTop top_;
};

TEST(SinusoidalTop, ThePatternIsLegWThenBothThenLegUAgainstTheOthers) {
  Bench b;
  b.clocks_until([](const auto& o) { return o.state == SinusoidalState::kPattern; });
  for (int n = 0; n < 3 * 1200; ++n) b.tick();  // the on-times of before are used up
  EXPECT_GT(b.clocks_until([](const auto& o) { return o.gates.wh; }), 0);
  EXPECT_TRUE(b.out.gates.ul && b.out.gates.vl);
  for (int n = 0; n < 21 * 1200; ++n) b.tick();
  EXPECT_GT(b.clocks_until([](const auto& o) { return o.gates.uh; }), 0);
  EXPECT_TRUE(b.out.gates.wh && b.out.gates.vl);
  for (int n = 0; n < 21 * 1200; ++n) b.tick();
  EXPECT_GT(b.clocks_until([](const auto& o) { return o.gates.uh; }), 0);
  EXPECT_TRUE(b.out.gates.vl && b.out.gates.wl);
}

// The currents that come back are none, so that the search ends with no saliency.
TEST(SinusoidalTop, PilotPulsesChopTheirLegsAgainstTheOthersWithAllGatesOffBetween) {
  Bench b;
  b.in.config.sequence.pilot = true;
  b.in.config.sequence.pattern = 1000;
  b.in.config.pilot = {.short_periods = 2, .rounds = 2, .decayed = 100, .saliency = 100};
  for (int round = 0; round < 2; ++round) {
    for (const int legs : {1, 6, 2, 5, 4, 3}) {
      int high = 0, low = 0;
      ASSERT_GT(b.clocks_until([](const auto& o) { return !(o.gates == Gates{}); }), 0);
      // Two periods, the dead times at their begin, and no gate after them.
      for (int n = 0; n < 2 * 1200; ++n) {
        const Gates& g = b.out.gates;
        high |= int(g.uh) | int(g.vh) << 1 | int(g.wh) << 2;
        low |= int(g.ul) | int(g.vl) << 1 | int(g.wl) << 2;
        b.tick();
      }
      EXPECT_EQ(high, legs);
      EXPECT_EQ(low, 7) << "chopped";
      for (int n = 0; n < 2 * 1200; ++n) {
        ASSERT_TRUE(b.off());
        b.tick();
      }
    }
  }
  b.clocks_until([](const auto& o) { return o.state == SinusoidalState::kRetryDelay; });
  EXPECT_EQ(b.out.reason, SinusoidalReason::kNoSaliency);
}

// The RTL reads the found angle while it works at a sample, the C++ when one is taken: it has to stand.
TEST(SinusoidalTop, WhatPilotPulsesFoundIsClearedBetweenSamples) {
  Bench b;
  b.in.config.sequence.pilot = true;
  b.in.config.sequence.pattern = 1000;
  b.in.config.pilot = {.short_periods = 2, .rounds = 2, .decayed = 100, .saliency = 100};
  ASSERT_GT(b.clocks_until([](const auto& o) { return o.state == SinusoidalState::kRetryDelay; }), 0);
  ASSERT_NE(b.out.initial, 0);
  int cleared = 0;
  for (int n = 0; n < 20 * 1200; ++n) {
    const auto before = b.out;
    b.tick();
    if (b.out.initial == before.initial) continue;
    ++cleared;
    ASSERT_FALSE(before.busy);
    ASSERT_EQ(b.out.initial, 0);
  }
  EXPECT_EQ(cleared, 1);
}

TEST(SinusoidalTop, AFaultPinEndsAPilotPulseInThreeClocks) {
  Bench b;
  b.in.config.sequence.pilot = true;
  b.in.config.sequence.pattern = 1000;
  b.in.config.pilot = {.short_periods = 20, .rounds = 2, .decayed = 100};
  ASSERT_GT(b.clocks_until([](const auto& o) { return o.gates.uh; }), 0);
  b.in.fault = true;
  for (int n = 0; n < 3; ++n) b.tick();
  for (int n = 0; n < 3000; ++n) {
    b.tick();
    ASSERT_TRUE(b.off());
  }
}

// In a pulse the limit is that of the drive, between pulses that of the decay, which is no fault.
TEST(SinusoidalTop, OverCurrentEndsAPilotPulseToo) {
  Bench b;
  b.in.config.sequence.pilot = true;
  b.in.config.sequence.pattern = 1000;
  b.in.config.pilot = {.short_periods = 20, .rounds = 2, .decayed = 100};
  ASSERT_GT(b.clocks_until([](const auto& o) { return o.gates.uh; }), 0);
  b.u = 1900;
  b.clocks_until([](const auto& o) { return o.state == SinusoidalState::kFault; });
  EXPECT_EQ(b.out.reason, SinusoidalReason::kOverCurrent);
}

// The pattern's on-time follows 1 / v_dc, which needs a few samples from reset: until then it is another
// in every period.
TEST(SinusoidalTop, OnTimesAreNew230ClocksAfterTheSampleAndAllIsDoneAfter477) {
  EXPECT_EQ(230, 2 + SinusoidalLoop::kEarly);
  EXPECT_LT(230 / 24e6, 10e-6) << "at 24 MHz";
  Bench b;
  b.u = 100;
  b.clocks_until([](const auto& o) { return o.state == SinusoidalState::kPattern; });
  int changed = 0;
  for (int period = 0; period < 5; ++period) {
    b.clocks_until([](const auto& o) { return o.sample; });
    const auto before = b.out;
    const int clocks = b.clocks_until(
        [&](const auto& o) { return o.done || o.on_u != before.on_u || o.on_w != before.on_w; });
    if (!b.out.done) {
      EXPECT_EQ(clocks, 230);
      ++changed;
      EXPECT_EQ(b.clocks_until([](const auto& o) { return o.done; }), 477 - 230);
    }
    EXPECT_EQ(477, 2 + SinusoidalLoop::kClocks);
  }
  EXPECT_GT(changed, 0);
}

// An ADC that gives codes more often than it is asked to: between the first of a period and the sample's
// end nothing sees them, afterwards they are a sample of their own.
TEST(SinusoidalTop, CodesThatComeWhileASampleIsUnderWayAreNotTaken) {
  std::mt19937 any(2);
  Bench asked, eager;
  asked.u = eager.u = 100;
  int refused = 0, taken = 0;
  for (int clock = 0; clock < 60 * 1200; ++clock) {
    const bool sample = asked.out.sample, busy = eager.out.busy;
    ASSERT_FALSE(sample && busy) << clock;
    const bool more = busy && any() % 8 == 0;
    eager.out.sample = sample || more;
    if (more) eager.u = int(any() % 3000) - 1500;
    asked.tick(), eager.tick();
    eager.u = 100;
    refused += more;
    taken += sample;
    ASSERT_TRUE(eager.out == asked.out) << clock;
  }
  EXPECT_GT(refused, 1000);
  EXPECT_GT(taken, 50);

  asked.clocks_until([](const auto& o) { return o.done; });
  EXPECT_FALSE(asked.out.busy);
  asked.out.sample = true;
  asked.tick();
  EXPECT_TRUE(asked.out.busy);
  EXPECT_EQ(asked.clocks_until([](const auto& o) { return o.done; }), 477 - 1);
}

TEST(SinusoidalTop, SamplesAreTakenOncePerPeriodWithAllLowSidesOn) {
  Bench b;
  b.clocks_until([](const auto& o) { return o.state == SinusoidalState::kPattern; });
  b.clocks_until([](const auto& o) { return o.sample; });
  for (int period = 0; period < 10; ++period) {
    EXPECT_EQ(b.clocks_until([](const auto& o) { return o.sample; }), 1200);
    if (period == 0) continue;
    EXPECT_TRUE(b.out.gates.ul && b.out.gates.vl && b.out.gates.wl);
  }
}

TEST(SinusoidalTop, AFaultPinTurnsAllGatesOffInThreeClocksWhateverTheyDo) {
  std::mt19937 any(1);
  for (int run = 0; run < 40; ++run) {
    Bench b;
    b.clocks_until([](const auto& o) { return o.state == SinusoidalState::kPattern; });
    const int more = std::uniform_int_distribution<>(100, 60'000)(any);
    for (int n = 0; n < more; ++n) b.tick();
    b.in.fault = true;
    for (int n = 0; n < 3; ++n) b.tick();
    for (int n = 0; n < 100; ++n) {
      b.tick();
      ASSERT_TRUE(b.off()) << run;
    }
    EXPECT_EQ(b.out.reason, SinusoidalReason::kFaultPin);
  }
}

TEST(SinusoidalTop, OverCurrentAndLostSamplesLatch) {
  Bench over;
  over.clocks_until([](const auto& o) { return o.state == SinusoidalState::kPattern; });
  over.u = -1900;
  over.clocks_until([](const auto& o) { return o.state == SinusoidalState::kFault; });
  EXPECT_EQ(over.out.reason, SinusoidalReason::kOverCurrent);

  Bench lost;
  lost.clocks_until([](const auto& o) { return o.state == SinusoidalState::kPattern; });
  for (int n = 0; n < 6 * 1200; ++n) {
    lost.out.sample = false;
    lost.tick();
  }
  EXPECT_EQ(lost.out.reason, SinusoidalReason::kLostSample);
  EXPECT_TRUE(lost.off());
}

TEST(SinusoidalTop, UnconfiguredAllGatesAreOff) {
  Bench b;
  b.in.command.configured = false;
  for (int n = 0; n < 50'000; ++n) {
    b.tick();
    ASSERT_TRUE(b.off());
  }
}

}  // namespace
}  // namespace steplock
