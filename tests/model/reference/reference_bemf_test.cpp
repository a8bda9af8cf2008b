// Zero-crossing detection of the reference against an ideal comparator.
#include <gtest/gtest.h>

#include <cmath>

#include "model/reference/bemf.hpp"
#include "model/reference/oscillator.hpp"

namespace steplock::reference {
namespace {

constexpr double kStep = 1e-3;  // s, one commutation step

struct Scene {
  double crossing = 0.5;        // turns of the step
  double freewheel = 0;         // the clamp shows the level after the crossing until then
  double period = 0, duty = 1;  // PWM; 0 is no chopping
  int step = 0;
  bool reverse = false;
  bool bounce = false;  // one wrong sample right after the crossing
};

struct Found {
  int crossings = 0;
  double place = -1, freewheel = -1;
  bool before_seen = false;
};

Found detect(const design::BemfParameters& p, const Scene& scene) {
  Bemf bemf(p);
  Oscillator vco;
  vco.set_frequency(0, 1 / kStep);
  vco.load(0, (scene.step + (scene.reverse ? 1 : 5)) % 6, 1 - 1e-9);
  Found found;
  const auto level = [&](double phase) {
    const bool bounced =
        scene.bounce && phase > scene.crossing + 0.01 && phase < scene.crossing + 0.014;
    const bool after = phase < scene.freewheel || (phase > scene.crossing && !bounced);
    return after == crossing_rises(scene.step, scene.reverse);
  };
  const double begin = vco.next();
  double t = begin;
  while (t < begin + kStep * 0.999) {
    vco.update(t, scene.reverse);
    const double phase = vco.phase(t);
    Pins pins;
    pins.comparator[kFloating[scene.step]] = level(phase);
    bool chop = true;
    double edge = kNever;
    if (scene.period > 0) {
      const double in = std::fmod(t - begin + 1e-12, scene.period);
      chop = in < scene.duty * scene.period;
      edge = t - in + (chop ? scene.duty * scene.period : scene.period) + 1e-12;
    }
    bemf.update(t, pins, {vco.step(), chop}, vco.phase(t), scene.reverse, true);
    if (bemf.crossing()) ++found.crossings, found.place = bemf.crossing_phase();
    t = std::max(std::min({bemf.next(), edge, vco.next()}), t + 1e-10);
  }
  found.before_seen = bemf.before_seen(scene.step);
  found.freewheel = bemf.freewheel();
  return found;
}

constexpr design::BemfParameters kPlain{.blanking = 2e-6, .sample_every = 1e-6, .samples = 4};

TEST(ReferenceBemf, FindsTheCrossingInEveryStepAndDirection) {
  for (int step = 0; step < 6; ++step) {
    for (const bool reverse : {false, true}) {
      const auto found = detect(kPlain, {.crossing = 0.42, .step = step, .reverse = reverse});
      EXPECT_EQ(found.crossings, 1);
      EXPECT_NEAR(found.place, 0.42, 0.5e-6 / kStep);  // half a sample interval
    }
  }
}

TEST(ReferenceBemf, TheFiltersLengthMovesNothing) {
  for (int samples = 1; samples <= 15; ++samples) {
    auto p = kPlain;
    p.samples = samples;
    EXPECT_NEAR(detect(p, {.crossing = 0.61}).place, 0.61, 0.5e-6 / kStep) << samples;
  }
}

TEST(ReferenceBemf, DemagnetisationIsNotACrossing) {
  const auto found = detect(kPlain, {.crossing = 0.5, .freewheel = 0.2});
  EXPECT_EQ(found.crossings, 1);
  EXPECT_NEAR(found.place, 0.5, 0.5e-6 / kStep);
  EXPECT_NEAR(found.freewheel, 0.2, 5e-6 / kStep);  // confirmed four samples later
}

TEST(ReferenceBemf, ALevelThatNeverWasBeforeIsNoCrossing) {
  const auto found = detect(kPlain, {.crossing = 0.3, .freewheel = 0.4});
  EXPECT_EQ(found.crossings, 0);
  EXPECT_FALSE(found.before_seen);
}

TEST(ReferenceBemf, ALateRotorShowsTheLevelBefore) {
  const auto found = detect(kPlain, {.crossing = 1.5});
  EXPECT_EQ(found.crossings, 0);
  EXPECT_TRUE(found.before_seen);
}

TEST(ReferenceBemf, OneBounceDoesNotCountTwice) {
  const auto found = detect(kPlain, {.crossing = 0.5, .bounce = true});
  EXPECT_EQ(found.crossings, 1);
  EXPECT_NEAR(found.place, 0.5, 15e-6 / kStep);
}

// One that only looks on: the phase floats from the bridge's commutation on, whatever its own VCO says.
TEST(ReferenceBemf, FollowsTheBridgeThatAnotherDriveHolds) {
  Bemf bemf({.blanking = 2e-6, .sample_every = 1e-6, .samples = 4});
  // Step 1, v floats: low before its crossing at 0.5.  Up to 0.1 the bridge still stands in step 0,
  // where v is the low side: no "before" of step 1.
  double t = 0;
  bool seen_too_early = false, crossing = false;
  for (; t < kStep; t += 1e-6) {
    const double phase = t / kStep;
    const bool bridge_there = phase > 0.1;
    Pins pins;
    pins.comparator[1] = bridge_there && (phase < 0.2 || phase > 0.5);  // freewheels up to 0.2
    pins.comparator[2] = true;  // w floats in step 0: "after" all the time
    bemf.update(t, pins, {bridge_there ? 1 : 0, true}, phase, false, true);
    seen_too_early |= phase < 0.2 && bemf.before_seen(1) && bridge_there;
    crossing |= bemf.crossing();
  }
  EXPECT_FALSE(seen_too_early);
  EXPECT_TRUE(crossing);
  EXPECT_NEAR(bemf.crossing_phase(), 0.5, 1e-3);
}

// A step's freewheeling and level stand until the next one shows its own, and what never ended counts as a whole step.
TEST(ReferenceBemf, TellsOfTheStepThatEndedUntilTheNextOneShows) {
  Bemf bemf({.blanking = 2e-6, .sample_every = 1e-6, .samples = 4});
  double t = 0;
  // To the end of the step; the floating phase is at `after` up to the turn `freewheel` of it.
  const auto step = [&](int step, int phase, double freewheel, double from, double to) {
    for (double turn = from; turn < to; turn += 1e-6 / kStep, t += 1e-6) {
      Pins pins;
      pins.comparator[phase] = (turn < freewheel) == crossing_rises(step, false);
      bemf.update(t, pins, {step, true}, turn, false, true);
    }
  };
  step(1, 1, 0.2, 0, 1);
  EXPECT_NEAR(bemf.freewheel(), 0.2, 5e-6 / kStep);
  EXPECT_TRUE(bemf.before_seen(1));
  step(2, 0, 1, 0, 0.4);  // the own oscillator has not commutated yet: it ends step 1
  EXPECT_NEAR(bemf.freewheel(), 0.2, 5e-6 / kStep);
  EXPECT_TRUE(bemf.before_seen(1));
  EXPECT_FALSE(bemf.before_seen(2));
  step(2, 0, 1, 0.4, 1);
  step(3, 2, 0.3, 0, 0.2);
  EXPECT_FALSE(bemf.before_seen(2));
  EXPECT_EQ(bemf.freewheel(), 1);
  step(3, 2, 0.3, 0.2, 0.5);
  EXPECT_NEAR(bemf.freewheel(), 0.3, 5e-6 / kStep);
  EXPECT_TRUE(bemf.before_seen(3));
}

// A crossing inside a blind gap is put into the gap's middle: wrong by half the gap at most, and
// right on the average.
TEST(ReferenceBemf, BlindGapsLeaveNoBias) {
  auto p = kPlain;
  p.sampling = design::Sampling::kOnTime;
  const double period = 33e-6, duty = 0.4;
  const double gap = ((1 - duty) * period + p.blanking + p.sample_every) / kStep;
  double sum = 0;
  int count = 0;
  for (double crossing = 0.3; crossing < 0.7; crossing += 0.00137, ++count) {
    const auto found = detect(p, {.crossing = crossing, .period = period, .duty = duty});
    ASSERT_EQ(found.crossings, 1);
    ASSERT_NEAR(found.place, crossing, gap / 2 * 1.01);
    sum += found.place - crossing;
  }
  // Uniform errors of +-gap/2, some 290 of them: the mean within four standard deviations.
  EXPECT_NEAR(sum / count, 0, 4 * gap / std::sqrt(12.0 * count));
}

}  // namespace
}  // namespace steplock::reference
