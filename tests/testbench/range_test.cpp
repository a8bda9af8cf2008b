#include "testbench/range/range.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "testbench/drive_file/drive_file.hpp"

namespace steplock {
namespace {

design::Settings drone() {
  return load_drive_file(STEPLOCK_DRIVES "/br2804_drone.toml").settings;
}

const RangeSettings kQuick = {"quick", 48e6, 48e3, 1e-6, 0.25e-6, 2};

// The goal of the drive: 1 degree up to 500,000 eRPM with ideal comparators.
TEST(Range, CommutatesWithinADegreeUpToHalfAMillion) {
  for (const double erpm : {10037., 100370., 301110., 501850.}) {
    const RangePoint p = six_step_range().measure(drone(), kQuick, erpm);
    EXPECT_TRUE(p.locked) << erpm;
    EXPECT_LT(p.worst_deg, 1) << erpm;
    // Delays are compensated, so what is left has no bias: a clock, and six deviations of a mean over
    // 240 crossings, each somewhere within the time between two samples.
    const double degrees_per_second = 360 * erpm / 60;
    const double spread = kQuick.sample_every_s / std::sqrt(12.0 * 240);
    EXPECT_LT(std::abs(p.mean_deg), degrees_per_second * (1 / kQuick.clock_hz + 6 * spread)) << erpm;
  }
}

TEST(Range, HoldsAMillion) {
  EXPECT_TRUE(six_step_range().measure(drone(), kQuick, 1.0037e6).locked);
}

// A step of 10 us cannot be seen through a filter of 8 us and 4 us of blanking.
TEST(Range, DoesNotClaimALockThatIsNone) {
  EXPECT_FALSE(six_step_range().measure(drone(), {"slow"}, 1.0037e6).locked);
}

TEST(Range, CapIsTheLastSpeedBeforeTheFirstLostLock) {
  const RangeCurve c{{"x"}, {{1e3, true, 0, 0}, {2e3, true, 0, 0}, {3e3, false, 0, 0}, {4e3, true, 0, 0}}};
  EXPECT_EQ(c.cap_erpm(), 2e3);
  EXPECT_EQ(RangeCurve({{"y"}, {{1e3, false, 0, 0}}}).cap_erpm(), 0);
}

TEST(Range, PageShowsLocksAndTheirLoss) {
  const Range r{{{{"name"}, {{10e3, true, 0.25, 0.5}, {20e3, false, 0, 0}}}}};
  EXPECT_THAT(range_page(six_step_range(), r), testing::HasSubstr("| name | 10000 | +0.25, 0.50 | - |"));
}

}  // namespace
}  // namespace steplock
