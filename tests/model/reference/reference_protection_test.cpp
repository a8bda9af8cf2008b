// Protection of the reference: each cause, and what must not cause it.
#include <gtest/gtest.h>

#include "model/reference/protection.hpp"

namespace steplock::reference {
namespace {

constexpr design::ProtectionParameters kLimits{.misses = 18,
                                               .stall = 40,
                                               .slip = 0.5,
                                               .freewheel = 0.45,
                                               .wrong_lock = 0.1,
                                               .over_current = 8};

struct Case : Protection {
  Case() : Protection(kLimits, 1e-3) {}
  Reason after(int times, Protection::In in) {
    in.running = true;
    if (in.frequency == 0) in.frequency = 100;
    for (int k = 0; k < times; ++k) update(in);
    return lost();
  }
};

TEST(ReferenceProtection, FiveMissesOrEighteenHiddenCrossingsInARowAreAStepOut) {
  Case missed, hidden;
  EXPECT_EQ(missed.after(4, {.missed = true, .lags = true}), Reason::kNone);
  EXPECT_EQ(missed.after(1, {.missed = true, .lags = true}), Reason::kStepOut);
  EXPECT_EQ(hidden.after(17, {.missed = true}), Reason::kNone);
  EXPECT_EQ(hidden.after(1, {.missed = true}), Reason::kStepOut);
}

TEST(ReferenceProtection, HalfMayBeHiddenForGoodButNotASixthMissed) {
  Case hidden;
  for (int k = 0; k < 100; ++k) {
    EXPECT_EQ(hidden.after(1, {.missed = true}), Reason::kNone);
    EXPECT_EQ(hidden.after(1, {.good = true}), Reason::kNone);
  }
  Case stuck;
  Reason reason = Reason::kNone;
  for (int turn = 0; turn < 15 && reason == Reason::kNone; ++turn) {
    for (const bool lags : {true, false}) {
      reason = stuck.after(1, {.missed = true, .lags = lags});
      if (reason == Reason::kNone) reason = stuck.after(2, {.good = true});
    }
  }
  EXPECT_EQ(reason, Reason::kStepOut);
}

TEST(ReferenceProtection, EighteenFarCrossingsInARowAreAStepOutButNotWithHalls) {
  Case c;
  EXPECT_EQ(c.after(17, {.updated = true}), Reason::kNone);
  EXPECT_EQ(c.after(1, {.updated = true}), Reason::kStepOut);
  Case hall;
  EXPECT_EQ(hall.after(100, {.updated = true, .hall = true}), Reason::kNone);
}

TEST(ReferenceProtection, SixSlowStepsAreAStall) {
  Case c;
  EXPECT_EQ(c.after(5, {.commutated = true, .frequency = 30}), Reason::kNone);
  EXPECT_EQ(c.after(1, {.commutated = true, .frequency = 50}), Reason::kNone);
  EXPECT_EQ(c.after(6, {.commutated = true, .frequency = 30}), Reason::kStall);
}

TEST(ReferenceProtection, SlipOrLongFreewheelingIsAWrongLockInTime) {
  Case slip, freewheel, brief;
  EXPECT_EQ(slip.after(49, {.tick = true, .slip = 0.6}), Reason::kNone);
  EXPECT_EQ(slip.after(1, {.tick = true, .slip = 0.6}), Reason::kWrongLock);
  EXPECT_EQ(freewheel.after(50, {.tick = true, .freewheel = 0.5}), Reason::kWrongLock);
  brief.after(49, {.tick = true, .slip = 0.6});
  brief.after(1, {.tick = true});
  EXPECT_EQ(brief.after(1, {.tick = true, .slip = 0.6}), Reason::kNone);
  EXPECT_EQ(brief.after(1, {.tick = true, .slip = 0.6}), Reason::kWrongLock);
}

TEST(ReferenceProtection, HoldsOnlyInLock) {
  Protection p(kLimits, 1e-3);
  for (int k = 0; k < 50; ++k) p.update({.tick = true, .missed = true, .slip = 1});
  EXPECT_EQ(p.lost(), Reason::kNone);
}

TEST(ReferenceProtection, OverCurrentAndFaultPinAreFatalInAnyState) {
  Protection p(kLimits, 1e-3);
  p.update({.stuck = 8});
  EXPECT_EQ(p.fatal(), Reason::kOverCurrent);
  p.update({.fault_pin = true, .stuck = 0});
  EXPECT_EQ(p.fatal(), Reason::kFaultPin);
  p.update({});
  EXPECT_EQ(p.fatal(), Reason::kNone);
}

TEST(ReferenceProtection, AnIllegalHallCodeCountsInTheSecondTick) {
  Case c;
  EXPECT_EQ(c.after(1, {.tick = true, .hall = true, .hall_illegal = true}), Reason::kNone);
  EXPECT_EQ(c.after(1, {.tick = true, .hall = true, .hall_illegal = true}), Reason::kHallCode);
}

}  // namespace
}  // namespace steplock::reference
