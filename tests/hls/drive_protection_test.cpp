// Each reason comes when it is due, not a sample earlier, and only where it applies.

#include "hls/sinusoidal/drive_protection.hpp"

#include <gtest/gtest.h>

namespace steplock {
namespace {

using Reason = SinusoidalReason;

class Watched {
 public:
  // Well: regulating, locked, fast, plausible; limits of 10 samples, 3 lost ones.
  DriveProtection::In in{.regulating = true, .locked = true, .fast = true, .plausible = true,
                              .config = {.saturated = 10, .slow = 10, .emf = 10, .lost_samples = 3}};

  DriveProtection::Out sample(bool lost = false) {
    in.period = true;
    tick();
    in.period = false;
    in.sampled = !lost;
    tick();
    in.sampled = false;
    tick();
    return tick();
  }
  DriveProtection::Out tick() { return dut_.tick(in); }

 private:
  DriveProtection dut_;
};

// Samples until a try failed, and why; 1000 is never.
template <class Spoil>
std::pair<int, Reason> fails(Spoil&& spoil) {
  Watched w;
  for (int n = 0; n < 20; ++n) EXPECT_EQ(w.sample().failed, Reason::kNone);
  spoil(w.in);
  for (int n = 1; n < 1000; ++n) {
    const auto out = w.sample();
    EXPECT_EQ(out.fatal, Reason::kNone);
    if (out.failed != Reason::kNone) return {n, out.failed};
  }
  return {1000, Reason::kNone};
}

TEST(DriveProtection, EachFailureComesAfterItsTimeWithItsReason) {
  using In = DriveProtection::In;
  EXPECT_EQ(fails([](In& in) { in.saturated = true; }), std::pair(11, Reason::kSaturated));
  EXPECT_EQ(fails([](In& in) { in.plausible = false; }), std::pair(11, Reason::kEmf));
  EXPECT_EQ(fails([](In& in) { in.slow = true; }), std::pair(11, Reason::kTooSlow));
}

TEST(DriveProtection, WhereItDoesNotApplyNothingFails) {
  using In = DriveProtection::In;
  const std::pair never(1000, Reason::kNone);
  EXPECT_EQ(fails([](In& in) { in.saturated = true, in.regulating = false; }), never);
  EXPECT_EQ(fails([](In& in) { in.plausible = in.fast = false; }), never);
  EXPECT_EQ(fails([](In& in) { in.plausible = in.locked = false; }), never);
  EXPECT_EQ(fails([](In& in) { in.slow = true, in.locked = false; }), never);
  EXPECT_EQ(fails([](In& in) {
    in.saturated = in.slow = true, in.plausible = false;
    in.config.saturated = in.config.slow = in.config.emf = 0;
  }), never);
}

TEST(DriveProtection, SlowCountsAsABalance) {
  Watched w;
  for (int n = 0; n < 300; ++n) {
    w.in.slow = n % 2 == 0;
    EXPECT_EQ(w.sample().failed, Reason::kNone);
  }
  Reason reason = Reason::kNone;
  for (int n = 0; n < 60; ++n) {
    w.in.slow = n % 3 != 0;
    reason = w.sample().failed;
  }
  EXPECT_EQ(reason, Reason::kTooSlow);
}

TEST(DriveProtection, OverCurrentAndThreeLostSamplesAreFatal) {
  Watched w;
  EXPECT_EQ(w.sample().fatal, Reason::kNone);
  // A loss shows when the next period begins.
  EXPECT_EQ(w.sample(true).fatal, Reason::kNone);
  EXPECT_EQ(w.sample(true).fatal, Reason::kNone);
  EXPECT_EQ(w.sample(false).fatal, Reason::kNone) << "two in a row are not three";
  for (int n = 0; n < 3; ++n) EXPECT_EQ(w.sample(true).fatal, Reason::kNone);
  EXPECT_EQ(w.sample(true).fatal, Reason::kLostSample);
  w.in.restart = true;
  w.tick();
  w.in.restart = false;
  w.in.over_current = true;
  EXPECT_EQ(w.sample().fatal, Reason::kOverCurrent);
}

TEST(DriveProtection, AsManyLostSamplesAsTheWordSaysAreFatalAndNoneForZero) {
  for (const int most : {0, 1, 2, 15}) {
    Watched w;
    w.in.config.lost_samples = most;
    w.sample();
    int lost = 0;
    while (lost < 40 && w.sample(true).fatal == Reason::kNone) ++lost;
    EXPECT_EQ(lost, most == 0 ? 40 : most) << "the period after the last shows it";
  }
}

}  // namespace
}  // namespace steplock
