// The sinusoidal drive's speed range: a motor wound for each speed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "testbench/drive_file/drive_file.hpp"
#include "testbench/range/range.hpp"

namespace steplock {
namespace {

design::Settings servo() { return load_drive_file(STEPLOCK_DRIVES "/m2310p_sinusoidal.toml").settings; }

RangePoint point(double pwm_hz, double erpm) { return sinusoidal_range().measure(servo(), {"", 24e6, pwm_hz}, erpm); }

TEST(SinusoidalRange, WhereATurnHasManySamplesItIsFollowedClosely) {
  const RangePoint many = point(40e3, 20.1e3);
  ASSERT_TRUE(many.locked);
  EXPECT_LT(many.worst_deg, 5);
  EXPECT_LT(std::abs(many.mean_deg), many.worst_deg);
}

// The words hold a sixteenth of a turn per sample.
TEST(SinusoidalRange, BeyondASixteenthOfATurnPerSampleNoLockIsClaimed) {
  EXPECT_TRUE(point(5e3, 10.04e3).locked);
  EXPECT_FALSE(point(5e3, 20.1e3).locked);
  EXPECT_FALSE(point(5e3, 200.7e3).locked);
}

TEST(SinusoidalRange, PageShowsLocksAndTheirLoss) {
  const Range r{{{{"name"}, {{10e3, true, 0.25, 0.5}, {20e3, false, 0, 0}}}}};
  EXPECT_THAT(range_page(sinusoidal_range(), r), testing::HasSubstr("| name | 10000 | +0.25, 0.50 | - |"));
  EXPECT_THAT(range_page(sinusoidal_range(), r), testing::HasSubstr("figures/sinusoidal_range.svg"));
}

}  // namespace
}  // namespace steplock
