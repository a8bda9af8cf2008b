#include "hls/six_step/bemf_comparator.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <random>

namespace steplock {
namespace {

// One step of a motor that turns evenly: demagnetisation, then the level from before the crossing,
// then the one after it, on the comparator of the floating phase.  Phases in 1/65536 of a step.
struct Motor {
  int clocks = 4096;      // per step
  int freewheel = 6000;   // end of demagnetisation
  int crossing = 0x8000;  // the true place
  int step = 5;           // U floats, and its back-EMF rises
  bool reverse = false;
  int pwm_period = 0;     // clocks; 0: the chopped gate is on throughout
  int pwm_on = 0;         // clocks
};

struct Seen {
  int crossings = 0;
  int phase = -1;         // of the last crossing
  int clock = -1;         // in which that one was told
  bool before = false;
  int freewheel = -1;     // as shown with the next commutation
};

// `disturb` may turn the true level into what the pin shows: (level, clock, clocks since the last edge).
template <class Disturb>
Seen run(BemfComparator& dut, const Motor& motor, const BemfConfig& config, Disturb disturb) {
  Seen seen;
  const bool rising = (motor.step % 2 == 1) != motor.reverse;
  const int floating = std::array{2, 1, 0, 2, 1, 0}[motor.step];
  int since_edge = 0;
  bool last_chop = true;
  for (int clock = 0; clock <= motor.clocks; ++clock) {
    const int phase = std::min(clock * (65536 / motor.clocks), 65535);
    const bool chop = motor.pwm_period == 0 || clock % motor.pwm_period < motor.pwm_on;
    since_edge = clock == 0 || chop != last_chop ? 0 : since_edge + 1;
    last_chop = chop;
    const bool after = phase < motor.freewheel || phase >= motor.crossing;
    const bool pin = disturb(after, clock, since_edge) == rising;
    const auto out = dut.tick({.u = floating == 0 ? pin : !pin,
                               .v = floating == 1 ? pin : !pin,
                               .w = floating == 2 ? pin : !pin,
                               .step = motor.step,
                               .reverse = motor.reverse,
                               .commutate = clock == 0 || clock == motor.clocks,
                               .chop = chop,
                               .phase = phase,
                               .config = config});
    if (clock != 0 && out.crossing) {
      ++seen.crossings;
      seen.phase = int(out.crossing_phase.raw());
      seen.clock = clock;
    }
    if (clock == motor.clocks) {
      seen.before = out.before_seen;
      seen.freewheel = int(out.freewheel.raw());
    }
  }
  return seen;
}

Seen run(const Motor& motor, const BemfConfig& config) {
  BemfComparator dut;
  return run(dut, motor, config, [](bool after, int, int) { return after; });
}

// In step k, forward, theta runs from 30 + 60 k to 90 + 60 k; reverse, the applied step is k + 3.
TEST(BemfComparator, FindsTheCrossingOfEveryPhaseInBothDirections) {
  for (int k = 0; k < 6; ++k) {
    for (const bool reverse : {false, true}) {
      BemfComparator dut;
      int crossings = 0;
      for (int i = 0; i < 600; ++i) {
        const double along = i / 600.0;
        const double theta = 30 + 60 * (k + (reverse ? 1 - along : along));
        // The back-EMF has the sign of the speed.
        const auto pin = [&](double lag) {
          return (std::sin((theta - lag) * M_PI / 180) > 0) != reverse;
        };
        const auto out = dut.tick({.u = pin(0),
                                   .v = pin(120),
                                   .w = pin(240),
                                   .step = reverse ? (k + 3) % 6 : k,
                                   .reverse = reverse,
                                   .commutate = i == 0,
                                   .chop = true,
                                   .phase = int(along * 65536)});
        if (!out.crossing) continue;
        ++crossings;
        // One sample is 65536 / 600 of a step.
        EXPECT_NEAR(int(out.crossing_phase.raw()), 0x8000, 65536 / 600);
      }
      EXPECT_EQ(crossings, 1) << "step " << k << " reverse " << reverse;
    }
  }
}

// Of the driven phases' comparators nothing counts: they show the opposite throughout.
TEST(BemfComparator, OnlyTheFloatingPhaseOfAStepIsRead) {
  for (int step = 0; step < 6; ++step) {
    for (const bool reverse : {false, true}) {
      const auto seen = run({.step = step, .reverse = reverse}, {.samples = 1});
      EXPECT_EQ(seen.crossings, 1) << step << ' ' << reverse;
      EXPECT_NEAR(seen.phase, 0x8000, 9) << step << ' ' << reverse;
    }
  }
}

TEST(BemfComparator, TheCrossingIsToldAClockAfterTheSampleThatDecides) {
  // Clock 2048 is the first that shows the level behind it; one sample a clock.
  for (int samples = 1; samples <= 15; ++samples) {
    EXPECT_EQ(run({}, {.samples = samples}).clock, 2048 + samples - 1 + 1) << samples;
  }
}

TEST(BemfComparator, EachStepHasItsOwnCrossing) {
  BemfComparator dut;
  const auto as_it_is = [](bool after, int, int) { return after; };
  for (int step = 0; step < 8; ++step) {
    const auto seen = run(dut, {.step = step % 6}, {.samples = 3}, as_it_is);
    EXPECT_EQ(seen.crossings, 1) << step;
    EXPECT_TRUE(seen.before) << step;
  }
  EXPECT_FALSE(run(dut, {.freewheel = 0x9000}, {.samples = 3}, as_it_is).before) << "seen in the step before, not in this";
}

TEST(BemfComparator, TheFilterDoesNotShiftTheCrossing) {
  for (int samples = 1; samples <= 15; ++samples) {
    for (const int every : {1, 2, 7, 50}) {
      const auto seen = run({}, {.sample_every = every, .samples = samples});
      ASSERT_EQ(seen.crossings, 1);
      // Half the distance of two samples, and the truncated bit.
      ASSERT_NEAR(seen.phase, 0x8000, every * 16 / 2 + 1) << samples << " samples, every " << every;
    }
  }
}

TEST(BemfComparator, AGapInTheSamplesIsHalved) {
  // Only the on-times are sampled; the crossing falls into the middle of an off-time.
  for (int crossing = 0x7000; crossing < 0x9000; crossing += 97) {
    const auto seen = run({.crossing = crossing, .pwm_period = 200, .pwm_on = 60},
                          {.sampling = Sampling::kOnTime, .blanking = 10});
    ASSERT_EQ(seen.crossings, 1);
    // The gap: 140 clocks of off-time and 10 of blanking, 16 units each.
    ASSERT_NEAR(seen.phase, crossing, (150 + 1) * 16 / 2 + 1);
  }
}

TEST(BemfComparator, TheGapLeavesNoBias) {
  double sum = 0;
  int count = 0;
  for (int crossing = 0x7000; crossing < 0x7000 + 200 * 16; ++crossing) {
    sum += run({.crossing = crossing, .pwm_period = 200, .pwm_on = 60},
               {.sampling = Sampling::kOnTime, .blanking = 10})
               .phase -
           crossing;
    ++count;
  }
  // Every place of a PWM period once.  In a gap of n units a crossing lies 0 to n - 1 before its end, for one on a sample is past
  // it: (n - 1) / 2 on the average, where the middle is n / 2.
  EXPECT_DOUBLE_EQ(sum / count, -0.5);
}

TEST(BemfComparator, FreewheelingIsNoCrossingAndItsEndIsMeasured) {
  for (const int freewheel : {0, 1000, 0x4000, 0x7800}) {
    for (const int samples : {1, 4, 15}) {
      const auto seen = run({.freewheel = freewheel}, {.samples = samples});
      ASSERT_EQ(seen.crossings, 1);
      ASSERT_TRUE(seen.before);
      // Confirmed by the last of `samples` samples, one in each clock of 16 units from the first behind the commutation.
      const int first = std::max(1, (freewheel + 15) / 16);
      ASSERT_EQ(seen.freewheel, 16 * (first + samples - 1)) << freewheel << ' ' << samples;
    }
  }
}

TEST(BemfComparator, FreewheelingBeyondTheCrossingIsSeenAsSuch) {
  const auto seen = run({.freewheel = 0x9000}, {.samples = 3});
  EXPECT_EQ(seen.crossings, 0);
  EXPECT_FALSE(seen.before);
  EXPECT_EQ(seen.freewheel, 0xFFFF);
}

TEST(BemfComparator, FreewheelingWithoutAnEndIsShownUntilOneIsSeen) {
  BemfComparator dut;
  run(dut, {.freewheel = 0x9000}, {.samples = 3}, [](bool after, int, int) { return after; });
  // The next step's freewheeling lasts: U floats, and its level of after is "above".
  for (int clock = 0; clock < 20; ++clock) {
    EXPECT_EQ(dut.tick({.u = true, .step = 5, .chop = true, .phase = clock, .config = {.samples = 3}}).freewheel, Phase::max()) << clock;
  }
  for (int clock = 0; clock < 3; ++clock) dut.tick({.step = 5, .chop = true, .phase = 1000 + clock, .config = {.samples = 3}});
  EXPECT_EQ(dut.tick({.step = 5, .chop = true, .phase = 2000, .config = {.samples = 3}}).freewheel, 1002);
}

TEST(BemfComparator, ALaggingRotorShowsTheLevelBeforeAndNoCrossing) {
  const auto seen = run({.crossing = 65536}, {.samples = 3});
  EXPECT_EQ(seen.crossings, 0);
  EXPECT_TRUE(seen.before);
}

TEST(BemfComparator, FindsNoMoreThanOneCrossingInAStep) {
  BemfComparator dut;
  const auto seen = run(dut, {}, {.samples = 1}, [](bool after, int clock, int) {
    return clock > 3000 ? clock % 20 < 10 : after;
  });
  EXPECT_EQ(seen.crossings, 1);
}

TEST(BemfComparator, SpikesShorterThanTheFilterAreNotSeen) {
  BemfComparator dut;
  // Three wrong samples in every sixteen, against a filter of four.
  const auto seen = run(dut, {}, {.samples = 4}, [](bool after, int clock, int) {
    return after != (clock % 16 < 3);
  });
  EXPECT_EQ(seen.crossings, 1);
  EXPECT_NEAR(seen.phase, 0x8000, 8 * 16);
}

TEST(BemfComparator, WithinTheBlankingThePinMayShowAnything) {
  for (const int blanking : {1, 5, 20}) {
    BemfComparator dut;
    std::mt19937 random(1);
    const auto seen = run(dut, {.pwm_period = 100, .pwm_on = 50},
                          {.blanking = blanking, .samples = 1},
                          [&](bool after, int, int since_edge) {
                            return since_edge < blanking ? (random() & 1) != 0 : after;
                          });
    ASSERT_EQ(seen.crossings, 1);
    ASSERT_NEAR(seen.phase, 0x8000, (blanking + 1) * 16 / 2 + 1);
  }
}

TEST(BemfComparator, TheFirstClockAfterTheBlankingCounts) {
  // Nothing but clock `blanking` after each edge shows the level: one sample per edge has to do.
  for (const int blanking : {1, 2, 3, 4, 20}) {
    BemfComparator dut;
    const auto seen = run(dut, {.pwm_period = 100, .pwm_on = 50},
                          {.blanking = blanking, .sample_every = 255, .samples = 1},
                          [&](bool after, int, int since_edge) {
                            return since_edge == blanking ? after : !after;
                          });
    EXPECT_EQ(seen.crossings, 1) << blanking;
    EXPECT_NEAR(seen.phase, 0x8000, 51 * 16 / 2 + 1) << blanking;
  }
}

TEST(BemfComparator, ASampleIsTakenEverySoManyClocks) {
  // Nothing but every `every`-th clock, from the first after the blanking, shows the level.
  for (const int every : {1, 2, 3, 4, 9}) {
    BemfComparator dut;
    const auto seen = run(dut, {}, {.blanking = 5, .sample_every = every, .samples = 4}, [&](bool after, int, int since_edge) {
      return since_edge >= 5 && (since_edge - 5) % every == 0 ? after : !after;
    });
    EXPECT_EQ(seen.crossings, 1) << every;
    EXPECT_NEAR(seen.phase, 0x8000, every * 16 / 2 + 1) << every;
  }
}

TEST(BemfComparator, OnlyTheChosenStateOfTheGateIsSampled) {
  for (const bool on_time : {true, false}) {
    BemfComparator dut;
    const auto seen = run(dut, {.pwm_period = 100, .pwm_on = 50},
                          {.sampling = on_time ? Sampling::kOnTime : Sampling::kOffTime, .samples = 1},
                          [&](bool after, int clock, int) {
                            return (clock % 100 < 50) == on_time ? after : clock % 2 == 0;
                          });
    ASSERT_EQ(seen.crossings, 1);
    ASSERT_NEAR(seen.phase, 0x8000, 52 * 16 / 2 + 1);
  }
}

TEST(BemfComparator, SamplesZeroCountsAsOne) {
  EXPECT_EQ(run({}, {.sample_every = 0}).phase, run({}, {.sample_every = 1}).phase);
  BemfComparator of_none, of_one;
  std::mt19937 random(1);
  for (int clock = 0; clock < 20000; ++clock) {
    BemfComparator::In in{.u = random() % 2 == 0, .step = 5, .commutate = clock % 64 == 0, .chop = true, .phase = clock % 64 * 1024};
    in.config.samples = 0;
    const auto none = of_none.tick(in);
    in.config.samples = 1;
    const auto one = of_one.tick(in);
    ASSERT_TRUE(none.crossing == one.crossing && none.crossing_phase == one.crossing_phase && none.before_seen == one.before_seen &&
                none.freewheel == one.freewheel) << clock;
  }
}

// Wherever the crossing lies behind the freewheeling, it is found where it is.
RC_GTEST_PROP(BemfComparator, TheCrossingIsWhereItIs, ()) {
  const int freewheel = *rc::gen::inRange(0, 30000);
  const int crossing = *rc::gen::inRange(freewheel + 2500, 62000);
  const int every = *rc::gen::inRange(1, 10);
  const int samples = *rc::gen::inRange(1, 16);
  const auto seen = run({.freewheel = freewheel, .crossing = crossing},
                        {.sample_every = every, .samples = samples});
  RC_ASSERT(seen.crossings == 1);
  RC_ASSERT(std::abs(seen.phase - crossing) <= every * 8 + 1);
}

}  // namespace
}  // namespace steplock
