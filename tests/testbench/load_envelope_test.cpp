#include "testbench/range/load_envelope.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "model/design/design.hpp"

namespace steplock {
namespace {

// The servo: quick to start, with a known torque constant.
struct LoadEnvelopeOfTheServo : testing::Test {
  design::Settings settings = load_drive_file(STEPLOCK_DRIVES "/m2310p_servo.toml").settings;
  design::MotorConstants motor = design::motor_constants(settings);
  double limit_nm() const { return motor.k_e * settings.sensors.limit_a; }
};

TEST_F(LoadEnvelopeOfTheServo, EndsBelowWhatTheCurrentLimitCanGive) {
  const LoadPoint p = measure_load(settings, 2000, 1.2 * limit_nm());
  ASSERT_TRUE(p.locked);
  EXPECT_NE(p.how, "kept");    // more than the limit's torque cannot be carried
  EXPECT_NE(p.how, "silent");  // and the drive says so
  // Torque of the limit's current is the bound; ripple takes some of it, commutation the rest.
  EXPECT_LT(p.kept_nm, limit_nm());
  EXPECT_GT(p.kept_nm, 0.5 * limit_nm());
  EXPECT_LE(p.held_nm, p.kept_nm);
}

TEST_F(LoadEnvelopeOfTheServo, AHalfRatedLoadIsKept) {
  const double half = motor.k_e * settings.motor.rated_current_a / 2;
  const LoadPoint p = measure_load(settings, 2000, half);
  EXPECT_EQ(p.how, "kept");
  EXPECT_NEAR(p.kept_nm, half, 1e-9);
}

TEST(LoadEnvelope, PageShowsWhatWasMeasured) {
  const LoadEnvelope e{"Motor", "motor", 0.1, 4000, {{1000, true, 0.15, 0.2, 800, "stall"}, {50, false, 0, 0, 0, ""}}};
  const std::string page = envelope_page({e});
  EXPECT_THAT(page, testing::HasSubstr("| 1000 | 0.15 | 1.50 | 0.2 | 2.00 | 800 | stall |"));
  EXPECT_THAT(page, testing::HasSubstr("| 50 | no lock |"));
}

}  // namespace
}  // namespace steplock
