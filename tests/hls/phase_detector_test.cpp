#include "hls/six_step/phase_detector.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

namespace steplock {
namespace {

using In = PhaseDetector::In;

// Begins a step, so that the next commutation has one to end.
In begin(PhaseDetector& dut, In in = {}) {
  in.detector_source = DetectorSource::kCrossings;
  dut.tick(in);
  in.commutate = true;
  dut.tick(in);
  in.commutate = false;
  return in;
}

PhaseDetector::Out after(PhaseDetector& dut, const In& in) {
  dut.tick(in);
  return dut.tick({.detector_source = in.detector_source, .window = in.window});
}

int error_of(int expected, int crossing) {
  PhaseDetector dut;
  auto in = begin(dut, {.expected = expected});
  in.crossing = true;
  in.crossing_phase = crossing;
  return int(after(dut, in).error.raw());
}

TEST(PhaseDetector, ACrossingBeforeItsPlaceHurriesTheVco) {
  EXPECT_EQ(error_of(0x8000, 0x7000), 0x1000);
}

TEST(PhaseDetector, ACrossingAfterItsPlaceSlowsTheVco) {
  EXPECT_EQ(error_of(0x8000, 0x9000), -0x1000);
}

// 12 degrees of advance: the crossing belongs to 0.7 of the step.
TEST(PhaseDetector, PhaseAdvanceMovesThePlace) { EXPECT_EQ(error_of(0xB333, 0xB333), 0); }

RC_GTEST_PROP(PhaseDetector, ErrorIsTheDistanceSaturatedToHalfAStep, ()) {
  const int expected = *rc::gen::inRange(0, 65536);
  const int crossing = *rc::gen::inRange(0, 65536);
  RC_ASSERT(error_of(expected, crossing) == std::clamp(expected - crossing, -32768, 32767));
}

TEST(PhaseDetector, AStepThatEndsBeforeTheCrossingShowsALaggingRotor) {
  PhaseDetector dut;
  auto in = begin(dut);
  in.before_seen = true;
  dut.tick(in);
  // The comparator's logic clears its memory at the commutation.
  in.before_seen = false;
  in.commutate = true;
  const auto out = after(dut, in);
  EXPECT_TRUE(out.missed);
  EXPECT_TRUE(out.update);
  // The crossing cannot have come before the step's last place: 0.5 - 0.99998.
  EXPECT_EQ(out.error, PhaseError(-0x7FFF));
}

// Once, freewheeling may have covered the crossing of a rotor that is in its place.
TEST(PhaseDetector, TwoStepsThatNeverShowedTheLevelBeforeShowALeadingRotor) {
  PhaseDetector dut;
  auto in = begin(dut, {.lead_error = 0x3000});
  for (const int error : {0, 0x3000, 0x3000}) {
    in.commutate = true;
    const auto out = after(dut, in);
    EXPECT_TRUE(out.missed);
    EXPECT_EQ(out.masked_lead, error != 0);
    EXPECT_EQ(out.error, PhaseError(error));
  }
  in.commutate = false;
  in.crossing = true;
  in.crossing_phase = 0x8000;
  dut.tick(in);
  in.crossing = false;
  in.commutate = true;
  dut.tick(in);
  EXPECT_EQ(after(dut, in).error, PhaseError(0));
}

TEST(PhaseDetector, AHiddenCrossingTellsWhatTheOneBeforeItTold) {
  struct Case {
    int lead;       // of the crossing in the step before, s0.16
    bool masked_lead;   // from 1/16
    int error;      // lead_error from 1/8
  };
  for (const auto& [lead, masked_lead, error] : {Case{-0x4000, false, 0}, Case{0xFFF, false, 0},
                                             Case{0x1000, true, 0}, Case{0x1FFF, true, 0},
                                             Case{0x2000, true, 0x3000}}) {
    PhaseDetector dut;
    auto in = begin(dut, {.lead_error = 0x3000});
    in.crossing = true;
    in.crossing_phase = 0x8000 - lead;
    EXPECT_FALSE(after(dut, in).masked_lead);
    in.crossing = false;
    in.commutate = true;
    dut.tick(in);
    const auto out = after(dut, in);
    EXPECT_TRUE(out.missed) << lead;
    EXPECT_EQ(out.masked_lead, masked_lead) << lead;
    EXPECT_EQ(out.error, PhaseError(error)) << lead;
    EXPECT_TRUE(after(dut, in).masked_lead) << lead;  // a second one in a row always
  }
}

TEST(PhaseDetector, GoodMeansWithinTheWindowOnEitherSide) {
  for (const int e : {-0x1001, -0x1000, -1, 0, 0xFFF, 0x1000}) {
    PhaseDetector dut;
    auto in = begin(dut, {.window = 0x1000});
    in.crossing = true;
    in.crossing_phase = 0x8000 - e;
    const auto out = after(dut, in);
    EXPECT_TRUE(out.update);
    EXPECT_EQ(out.good, e >= -0x1000 && e < 0x1000) << e;
  }
}

TEST(PhaseDetector, AFoundCrossingIsNoMissAtTheEndOfTheStep) {
  PhaseDetector dut;
  auto in = begin(dut);
  in.crossing = true;
  after(dut, in);
  in.crossing = false;
  in.commutate = true;
  EXPECT_FALSE(after(dut, in).missed);
}

TEST(PhaseDetector, TheFirstStepWatchedIsNoMiss) {
  PhaseDetector dut;
  EXPECT_FALSE(after(dut, {.detector_source = DetectorSource::kCrossings, .commutate = true}).missed);
}

// In the paper's form only U rising counts: step 5, or 2 in reverse, once per electrical turn.
TEST(PhaseDetector, OncePerTurnOnlyPhaseURisingCounts) {
  for (const bool reverse : {false, true}) {
    PhaseDetector dut;
    In in = {.detector_source = DetectorSource::kCrossings, .reverse = reverse, .detector = Detector::kOncePerTurn};
    dut.tick(in);
    int updates = 0;
    int counted_step = -1;
    for (int i = 0; i < 12; ++i) {
      in.step = reverse ? (12 - i) % 6 : i % 6;
      in.commutate = true;
      EXPECT_FALSE(after(dut, in).missed);
      in.commutate = false;
      in.crossing = true;
      if (after(dut, in).update) {
        ++updates;
        counted_step = int(in.step.raw());
      }
      in.crossing = false;
    }
    EXPECT_EQ(updates, 2);
    EXPECT_EQ(counted_step, reverse ? 2 : 5);
  }
}

TEST(PhaseDetector, WatchingNothingTheErrorHolds) {
  PhaseDetector dut;
  auto in = begin(dut);
  in.crossing = true;
  in.crossing_phase = 0x7000;
  after(dut, in);
  in.detector_source = DetectorSource::kNone;
  in.crossing_phase = 0;
  const auto out = after(dut, in);
  EXPECT_FALSE(out.update);
  EXPECT_EQ(out.error, PhaseError(0x1000));
}

PhaseDetector::Out change_after(double turns) {
  PhaseDetector dut;
  for (int i = 1; i <= int(turns); ++i) dut.tick({.detector_source = DetectorSource::kSectors, .elapsed = true});
  return after(dut, {.detector_source = DetectorSource::kSectors,
                     .changed = true,
                     .phase = int((turns - int(turns)) * 65536)});
}

TEST(PhaseDetector, AChangeOfSectorMeasuresTheInterval) {
  EXPECT_EQ(change_after(0.75).error, PhaseError(0x4000));
  EXPECT_EQ(change_after(1.25).error, PhaseError(-0x4000));
  EXPECT_EQ(change_after(0.25).error, PhaseError::max());
  EXPECT_EQ(change_after(1.75).error, PhaseError::min());
}

TEST(PhaseDetector, FollowingIsGoodWithinAnEighth) {
  EXPECT_TRUE(change_after(0.9).good);
  EXPECT_TRUE(change_after(1.1).good);
  EXPECT_FALSE(change_after(0.87).good);
  EXPECT_FALSE(change_after(1.13).good);
  const double bit = 1.0 / 65536;
  EXPECT_FALSE(change_after(0.875).good) << "an eighth is none within it";
  EXPECT_TRUE(change_after(0.875 + bit).good);
}

TEST(PhaseDetector, ANewStepBeginsTheTurnsAnew) {
  PhaseDetector dut;
  dut.tick({.detector_source = DetectorSource::kSectors, .elapsed = true});
  dut.tick({.detector_source = DetectorSource::kSectors, .commutate = true});
  EXPECT_EQ(after(dut, {.detector_source = DetectorSource::kSectors, .changed = true, .phase = 0xC000}).error, PhaseError(0x4000));
}

TEST(PhaseDetector, TurnsThatNobodyFollowsDoNotCount) {
  PhaseDetector dut;
  dut.tick({.detector_source = DetectorSource::kSectors, .elapsed = true});
  dut.tick({.detector_source = DetectorSource::kCrossings});
  EXPECT_EQ(after(dut, {.detector_source = DetectorSource::kSectors, .changed = true, .phase = 0xC000}).error, PhaseError(0x4000));
}

// In lock the turn ends when the sector changes, and sooner or later in the same clock.
TEST(PhaseDetector, AChangeInTheClockThatEndsTheTurnIsOneTurnLate) {
  PhaseDetector dut;
  const auto out =
      after(dut, {.detector_source = DetectorSource::kSectors, .changed = true, .elapsed = true, .phase = 0});
  EXPECT_EQ(out.error, PhaseError(0));
  EXPECT_TRUE(out.good);

  PhaseDetector slow;
  after(slow, {.detector_source = DetectorSource::kSectors, .elapsed = true});
  EXPECT_EQ(after(slow, {.detector_source = DetectorSource::kSectors, .changed = true, .elapsed = true}).error,
            PhaseError::min());
}

TEST(PhaseDetector, TwoTurnsWithoutAChangeAreAMissWithTheVcoTooFast) {
  PhaseDetector dut;
  EXPECT_FALSE(after(dut, {.detector_source = DetectorSource::kSectors, .elapsed = true}).missed);
  const auto out = after(dut, {.detector_source = DetectorSource::kSectors, .elapsed = true});
  EXPECT_TRUE(out.missed);
  EXPECT_EQ(out.error, PhaseError::min());
}

}  // namespace
}  // namespace steplock
