// How the page of Matsui 1996 measures, and what it says of a miss.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testbench/drive_file/drive_file.hpp"
#include "testbench/paper/matsui1996.hpp"

namespace steplock::matsui1996 {
namespace {

using design::Estimator;
using testing::HasSubstr;

design::Settings drive() { return load_drive_file(STEPLOCK_DRIVES "/matsui1996.toml").settings; }

// The mean speed over whole turns is right but for the angle's swing at both ends, a degree of
// 2000.
TEST(Matsui1996, EveryTorqueIsMeasuredInItsPlaceAndBothWays) {
  const auto points = measure(
      drive(), drive(), {.engine = EngineKind::kFloat, .rpm = 500, .torques = {0, 1, -1}}, {}, "");
  ASSERT_EQ(points.size(), 3u);
  EXPECT_TRUE(all_held(points));
  EXPECT_LT(worst_error(points), 0.1);
  EXPECT_EQ(points[2].torque, -1);
}

// Three times the resistance that the drive believes, at a speed where it takes all voltage.
TEST(Matsui1996, ALostDriveIsSaidToBeLost) {
  design::Settings real = drive();
  real.motor.resistance_ohm *= 3;
  const auto points =
      measure(drive(), real, {.engine = EngineKind::kFloat, .rpm = 100, .torques = {1}}, {}, "");
  EXPECT_FALSE(all_held(points));
}

TEST(Matsui1996, TableThreeHasThePapersNumbersAndMarksAMiss) {
  const auto page = [](const Found& found) {
    return to_markdown(
        {.name = "p", .title = "P", .introduction = "i", .sections = {comparison(drive(), found)}});
  };
  const Found good{.slowest = {50, 10}, .error_percent = {0.3, 0.1}, .swing_percent = {24, 248}, .loop_khz = 50};
  EXPECT_THAT(page(good),
              HasSubstr("| voltage model: minimum speed | 100 r/min | 50 r/min | -50.0 % | reached | by its mean, with"));
  EXPECT_THAT(page(good), HasSubstr("| current model: accuracy | 0.4 % | 0.1 % | -75.0 % | reached |"));
  const Found slow{.slowest = {100, 35}, .error_percent = {0.3, 0.1}};
  EXPECT_THAT(
      page(slow),
      HasSubstr(
          "| current model: minimum speed | 35 r/min | 35 r/min | +0.0 % | reached | **missed** (10 r/min)"));
  EXPECT_THAT(page(good), HasSubstr("| 5 kHz | 50 kHz | +900.0 % | reached | below; at 24 MHz"));
  EXPECT_THAT(page(slow), HasSubstr("| **missed** (20 and 50 kHz)"));
  EXPECT_THAT(page(good), HasSubstr("swings by 2.5e+02 % there"));
}

}  // namespace
}  // namespace steplock::matsui1996
