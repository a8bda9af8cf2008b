#include "model/reference/sinusoidal/protection.hpp"

#include <gtest/gtest.h>

namespace steplock::reference::sinusoidal {
namespace {

const design::sinusoidal::Protection kLimits{.over_current = 20, .saturated_s = 1e-3, .slow_speed = 3,
                                             .slow_s = 2e-3, .emf_low = 0.4, .emf_high = 2.5,
                                             .emf_speed = 10, .emf_s = 1e-3, .lost_samples = 3};
Protection protection() { return {kLimits, 0.332, 100e-6}; }

// What fails after how many samples of the same.
std::pair<Reason, int> outlasts(const Protection::In& in) {
  Protection p = protection();
  for (int n = 1; n < 100; ++n) {
    p.sampled(in);
    if (p.failed() != Reason::kNone) return {p.failed(), n};
  }
  return {Reason::kNone, 0};
}

TEST(SinusoidalProtection, AHealthyRunIsLeftAlone) {
  EXPECT_EQ(outlasts({.current = {19, -10, -9}, .regulating = true, .locked = true, .speed = 100,
                      .emf = 33}).first, Reason::kNone);
}

TEST(SinusoidalProtection, EachFailureHasItsTime) {
  using In = Protection::In;
  const auto saturated = outlasts(In{.regulating = true, .saturated = true, .speed = 100, .emf = 33});
  EXPECT_EQ(saturated.first, Reason::kSaturated);
  EXPECT_NEAR(saturated.second, 11, 1);
  const auto slow = outlasts(In{.locked = true, .speed = 2, .emf = 0.6});
  EXPECT_EQ(slow.first, Reason::kTooSlow);
  EXPECT_NEAR(slow.second, 21, 1);
  // 80,000 r/min that exist in the estimator alone.
  const auto phantom = outlasts(In{.locked = true, .speed = 8000, .emf = 30});
  EXPECT_EQ(phantom.first, Reason::kEmf);
  EXPECT_NEAR(phantom.second, 11, 1);
}

TEST(SinusoidalProtection, AHintThatPassesIsForgotten) {
  Protection p = protection();
  for (int n = 0; n < 200; ++n) {
    p.sampled({.regulating = true, .saturated = n % 8 != 0});
    ASSERT_EQ(p.failed(), Reason::kNone);
  }
}

TEST(SinusoidalProtection, OverCurrentEndsItInOneSampleInAnyPhaseAndSign) {
  for (const Phases& i : {Phases{21, -10, -11}, Phases{10, -21, 11}, Phases{0, -20.5, 20.5}}) {
    Protection p = protection();
    p.sampled({.current = i});
    EXPECT_EQ(p.fatal(), Reason::kOverCurrent);
  }
}

TEST(SinusoidalProtection, ThreeLostSamplesInARowAreAFaultTwoAreNot) {
  Protection p = protection();
  p.missed(), p.missed();
  EXPECT_EQ(p.fatal(), Reason::kNone);
  p.sampled({});
  p.missed(), p.missed();
  EXPECT_EQ(p.fatal(), Reason::kNone);
  p.missed();
  EXPECT_EQ(p.fatal(), Reason::kLostSample);
}

}  // namespace
}  // namespace steplock::reference::sinusoidal
