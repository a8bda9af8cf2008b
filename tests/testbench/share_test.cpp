// Bounds of a share beside the formulas that they are known by.
#include "testbench/sweep_page/share.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace steplock {
namespace {

// The chance of `hits` or fewer of `all`, term by term.
double at_most(std::size_t hits, std::size_t all, double p) {
  double sum = 0;
  for (std::size_t k = 0; k <= hits; ++k) {
    const double ways = std::lgamma(double(all) + 1) - std::lgamma(double(k) + 1) - std::lgamma(double(all - k) + 1);
    sum += std::exp(ways + double(k) * std::log(p) + double(all - k) * std::log1p(-p));
  }
  return sum;
}

TEST(Share, OfNoneLostIsBoundedByTheRuleOfThree) {
  for (const std::size_t n : {1u, 60u, 10000u}) {
    EXPECT_NEAR(share_at_most(0, n), 1 - std::pow(0.05, 1.0 / double(n)), 1e-12);
    EXPECT_NEAR(share_at_least(n, n), std::pow(0.05, 1.0 / double(n)), 1e-12);
  }
  EXPECT_LT(share_at_most(0, 10000), 0.0003);
}

TEST(Share, AtItsBoundsWhatWasSeenHasAChanceOfFivePercent) {
  for (const std::size_t hits : {1u, 7u, 250u}) {
    EXPECT_NEAR(at_most(hits, 300, share_at_most(hits, 300)), 0.05, 1e-9);
    EXPECT_NEAR(1 - at_most(hits - 1, 300, share_at_least(hits, 300)), 0.05, 1e-9);
  }
}

TEST(Share, OfNothingIsUnknown) {
  EXPECT_EQ(share_at_least(0, 0), 0);
  EXPECT_EQ(share_at_most(0, 0), 1);
}

}  // namespace
}  // namespace steplock
