// The sinusoidal drive's speed range: a motor wound for each speed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testbench/drive_file/drive_file.hpp"
#include "testbench/range/range.hpp"

namespace steplock {
namespace {

design::Settings servo() { return load_drive_file(STEPLOCK_DRIVES "/m2310p_sinusoidal.toml").settings; }

RangePoint point(double pwm_hz, double erpm) { return sinusoidal_range().measure(servo(), {"", 24e6, pwm_hz}, erpm); }

// The estimate is good to a few degrees where a turn has many samples, and no better than they allow where it has few.
TEST(SinusoidalRange, ATurnOfManySamplesIsFollowedMoreCloselyThanOneOfFew) {
  const RangePoint many = point(40e3, 20.1e3), few = point(5e3, 20.1e3);
  ASSERT_TRUE(many.locked);
  EXPECT_LT(many.worst_deg, 5);
  EXPECT_TRUE(!few.locked || few.worst_deg > many.worst_deg);
}

// A turn of less than two samples has no angle.
TEST(SinusoidalRange, NoLockIsClaimedWhereATurnHasNoSamples) { EXPECT_FALSE(point(5e3, 200.7e3).locked); }

TEST(SinusoidalRange, PageShowsLocksAndTheirLoss) {
  const Range r{{{{"name"}, {{10e3, true, 0.25, 0.5}, {20e3, false, 0, 0}}}}};
  EXPECT_THAT(range_page(sinusoidal_range(), r), testing::HasSubstr("| name | 10000 | +0.25, 0.50 | - |"));
  EXPECT_THAT(range_page(sinusoidal_range(), r), testing::HasSubstr("figures/sinusoidal_range.svg"));
}

}  // namespace
}  // namespace steplock
