// Phase detector and loop filter of the reference.
#include <gtest/gtest.h>

#include <tuple>

#include "model/design/loop_filter.hpp"
#include "model/reference/phase_locked_loop.hpp"

namespace steplock::reference {
namespace {

constexpr design::Components kPrinted{.c1 = 1.291e-6, .c2 = 11.621e-6, .r = 3.997e3};

design::LoopParameters paper() {
  const auto f = design::per_second(kPrinted, 0.0189);
  return {.form = design::LoopForm::kPerSecond,
          .integral = f.integral,
          .proportional = f.proportional,
          .pole = f.omega_p,
          .minimum = 0,
          .maximum = 1e6};
}

// Fig. 4 integrated with tiny steps: a current into C1, beside it R and C2 in series.
double circuit_after(double error, double seconds) {
  double v1 = 100, v2 = 100;
  constexpr int kSteps = 200000;
  const double dt = seconds / kSteps;
  for (int k = 0; k < kSteps; ++k) {
    const double through_r = (v1 - v2) / kPrinted.r;
    v1 += dt * (0.0189 * error - through_r) / kPrinted.c1;
    v2 += dt * through_r / kPrinted.c2;
  }
  return v1;
}

TEST(ReferenceLoopFilter, IsThePapersCircuit) {
  for (const double seconds : {1e-3, 10e-3, 100e-3}) {
    LoopFilter filter(paper());
    filter.load(100);
    for (int k = 0; k < 10; ++k) filter.run(0.1, seconds / 10);
    EXPECT_NEAR(filter.frequency(), circuit_after(0.1, seconds), 1e-3);  // Euler's own error
  }
}

TEST(ReferenceLoopFilter, DoesNotDependOnHowTimeIsCut) {
  LoopFilter once(paper()), often(paper());
  once.load(100), often.load(100);
  once.run(-0.2, 0.05);
  for (int k = 0; k < 50; ++k) often.run(-0.2, 0.001);
  EXPECT_NEAR(once.frequency(), often.frequency(), 1e-9);
}

TEST(ReferenceLoopFilter, PerStepScalesWithSpeed) {
  const auto f = design::per_step(0.3, 1, 0);
  const design::LoopParameters p{.form = design::LoopForm::kPerStep,
                                 .integral = f.integral,
                                 .proportional = f.proportional,
                                 .pole = 1,
                                 .minimum = 1,
                                 .maximum = 1e6};
  LoopFilter slow(p), fast(p);
  slow.load(100), fast.load(1000);
  for (const double e : {0.1, -0.05, 0.2, 0.0}) slow.step(e), fast.step(e);
  EXPECT_NEAR(fast.frequency(), 10 * slow.frequency(), 1e-9);
}

TEST(ReferenceLoopFilter, LeavesItsLimitAtOnce) {
  auto p = paper();
  p.minimum = 50, p.maximum = 200;
  LoopFilter filter(p);
  filter.load(100);
  for (int k = 0; k < 2000; ++k) filter.run(0.5, 1e-3);
  EXPECT_DOUBLE_EQ(filter.frequency(), 200);
  filter.run(-0.5, 1e-3);  // no wind-up to work off
  EXPECT_LT(filter.frequency(), 200);
  // Towards the lower limit only as far as the output is above it: 68 * 0.001 away from it.
  for (int k = 0; k < 500000; ++k) filter.run(-0.001, 1e-3);
  for (int k = 0; k < 100; ++k) filter.run(0, 1e-3);
  EXPECT_NEAR(filter.frequency(), 50, 0.07);
}

TEST(ReferenceLoopFilter, TakesTheKnownDelayBack) {
  auto p = paper();
  p.delay = 1e-5;
  LoopFilter filter(p);
  filter.load(100);
  filter.run(-100 * 1e-5, 1e-3);  // all of the error is the delay's
  EXPECT_NEAR(filter.frequency(), 100, 1e-9);
}

// As if it had run at this frequency with this error for long: from then on, only the integral moves it.
TEST(ReferenceLoopFilter, JoinsInMidRunWithoutAJump) {
  constexpr double kError = 0.1, kFrequency = 240, kTick = 1e-3;
  LoopFilter by_time(paper());
  by_time.join(kFrequency, kError);
  by_time.run(kError, kTick);
  const double slope = paper().integral * kError;
  EXPECT_NEAR(by_time.frequency(), kFrequency + slope * kTick, slope / paper().pole);

  const design::LoopParameters p{.form = design::LoopForm::kPerStep, .integral = 0.16,
                                 .proportional = 0.8, .maximum = 1e6};
  LoopFilter by_step(p);
  by_step.join(kFrequency, kError);
  by_step.step(kError);
  EXPECT_NEAR(by_step.frequency(), kFrequency * (1 + 0.16 * kError), 1e-9);
}

TEST(ReferenceLoopFilter, CatchesAnUnknownPeriodInADozenChanges) {
  for (const double truth : {30.0, 100.0, 900.0}) {
    LoopFilter filter({.minimum = 1, .maximum = 1e4});
    filter.load(100);
    for (int k = 0; k < 12; ++k) filter.catch_up(filter.frequency() / truth);
    EXPECT_NEAR(filter.frequency(), truth, 1e-3 * truth);
  }
}

TEST(ReferencePhaseDetector, EarlyCrossingMeansHurry) {
  PhaseDetector detector({.expected = 0.5, .lead_error = 0.25});
  detector.update({.crossing = true, .crossing_phase = 0.4, .window = 0.2});
  EXPECT_NEAR(detector.error(), 0.1, 1e-12);
  EXPECT_TRUE(detector.updated() && detector.good());
}

TEST(ReferencePhaseDetector, TellsALeadingRotorFromALaggingOne) {
  PhaseDetector detector({.expected = 0.5, .lead_error = 0.25});
  detector.update({.step_ended = true});  // the step in which it was started
  EXPECT_FALSE(detector.missed());
  for (const double error : {0.0, 0.25}) {  // once, freewheeling may have hidden it
    detector.update({.before_seen = false, .step_ended = true});
    EXPECT_TRUE(detector.missed());
    EXPECT_DOUBLE_EQ(detector.error(), error);
  }
  detector.update({.before_seen = true, .step_ended = true});
  EXPECT_DOUBLE_EQ(detector.error(), -0.5);
}

TEST(ReferencePhaseDetector, AHiddenCrossingTellsWhatTheOneBeforeItTold) {
  for (const auto& [lead, masked_lead, error] :
       {std::tuple(-0.25, false, 0.), std::tuple(0.0625 - 1e-9, false, 0.),
        std::tuple(0.0625 + 1e-9, true, 0.), std::tuple(0.125 - 1e-9, true, 0.),
        std::tuple(0.125 + 1e-9, true, 0.25)}) {
    PhaseDetector detector({.expected = 0.5, .lead_error = 0.25});
    detector.update({.crossing = true, .crossing_phase = 0.5 - lead});
    detector.update({.step_ended = true});
    EXPECT_FALSE(detector.missed() || detector.masked_lead());
    detector.update({.step_ended = true});
    EXPECT_TRUE(detector.missed());
    EXPECT_EQ(detector.masked_lead(), masked_lead) << lead;
    EXPECT_DOUBLE_EQ(detector.error(), error) << lead;
  }
}

TEST(ReferencePhaseDetector, LooksOnlyAtStepsThatCount) {
  PhaseDetector detector({.expected = 0.5});
  detector.update({.step_ended = true});
  detector.update({.crossing = true, .crossing_phase = 0.1, .counts = false});
  EXPECT_FALSE(detector.updated());
  detector.update({.step_ended = true, .counts = false});
  EXPECT_FALSE(detector.missed());
}

}  // namespace
}  // namespace steplock::reference
