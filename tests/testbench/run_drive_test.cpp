// A whole scenario in closed loop, with each engine.
#include "testbench/drive/six_step/run.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/testbench/short_drive.hpp"

namespace steplock {
namespace {

class EachEngine : public testing::TestWithParam<EngineKind> {};

TEST_P(EachEngine, StartsLocksHoldsSpeedTakesTheLoadReversesAndStops) {
  const Summary s = run_short(short_drive(), GetParam());
  EXPECT_TRUE(s.failures().empty()) << why(s);
  EXPECT_TRUE(s.locked);
  EXPECT_EQ(s.step_outs, 0u);
  EXPECT_LT(std::abs(s.steady.error_percent), kSpeedTolerancePercent);
  ASSERT_TRUE(s.reversed.has_value());
  EXPECT_LT(s.reversed->mean_rpm, -2900);
  ASSERT_TRUE(s.load_dip_percent.has_value());
  EXPECT_GT(*s.load_dip_percent, 1);  // the load did arrive
  EXPECT_EQ(s.shoot_throughs, 0u);
  // The plant's own books balance to its tolerance, 1e-7 per step.
  EXPECT_LT(std::abs(s.energy_residual), 1e-5);
  // And so do the powers of a span; what the load gets is torque times speed.
  ASSERT_TRUE(s.loaded_power.has_value());
  const Power& p = *s.loaded_power;
  EXPECT_NEAR(p.load, *s.load_step_nm * s.loaded->mean_rpm * std::numbers::pi / 30, 1e-6 * p.load);
  EXPECT_NEAR(p.input, p.copper + p.switches + p.bus_resistance + p.friction + p.load + p.stored, 1e-5 * p.input);
  EXPECT_GT(p.copper, 1e-3 * p.input);
}

INSTANTIATE_TEST_SUITE_P(RunDrive, EachEngine,
                         testing::Values(EngineKind::kRtl, EngineKind::kFixed, EngineKind::kFloat),
                         [](const auto& info) { return name_of(info.param); });

nlohmann::ordered_json without_wall(const Summary& s) {
  nlohmann::ordered_json j = to_json(s);
  j.erase("wall_s");
  j.erase("clocks_per_cpu_second");
  return j;
}

TEST(RunDrive, TheSameFileTwiceGivesTheSameSummary) {
  EXPECT_EQ(without_wall(run_short(short_drive(), EngineKind::kFixed)),
            without_wall(run_short(short_drive(), EngineKind::kFixed)));
}

TEST(RunDrive, AnotherSeedGivesAnotherRunOfTheSameDrive) {
  design::Settings s = short_drive();
  s.sensors.seed = 2;
  const Summary a = run_short(short_drive(), EngineKind::kFixed);
  const Summary b = run_short(s, EngineKind::kFixed);
  EXPECT_NE(without_wall(a), without_wall(b));
  EXPECT_TRUE(b.failures().empty()) << why(b);
}

// The negative control of the step-out judge, end to end: the protection is made blind and the load
// stalls the rotor.  The drive goes on believing in its lock for a while; the plant knows better.
TEST(RunDrive, ARotorThatIsTornOutOfStepIsCounted) {
  design::Settings s = short_drive();
  s.protection.misses = 63;
  s.protection.wrong_lock_s = 0;
  s.protection.slip_duty = 2;
  s.protection.stall_rpm = 0;
  s.scenario.load_step_nm = 20 * 0.2;  // far beyond what the bus voltage can push
  s.scenario.load_off_s.reset();
  s.scenario.reverse_s.reset();
  s.scenario.stop_s.reset();
  s.scenario.duration_s = 0.5;
  const Summary sum = run_short(s, EngineKind::kFixed);
  EXPECT_GT(sum.step_outs, 0u);
  EXPECT_FALSE(sum.failures().empty());
}

TEST(RunDrive, AnInterruptedRunKeepsWhatWasSimulated) {
  RunOptions options{.engine = EngineKind::kFixed};
  options.progress = [](double) { return false; };
  design::Settings s = short_drive();
  s.scenario.duration_s = 50;  // far longer than a tenth of a second of wall time
  const Record record = run_drive(s, options);
  EXPECT_TRUE(record.interrupted);
  EXPECT_GT(record.clocks, 0u);
  EXPECT_LT(record.simulated_s, 50);
  EXPECT_FALSE(record.overview.empty());
}

}  // namespace
}  // namespace steplock
