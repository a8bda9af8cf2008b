// A profile of set speeds and loads, in the loop, of either drive.
#include "testbench/run/profile.hpp"

#include <gtest/gtest.h>

#include "testbench/run/timeline.hpp"
#include "testbench/drive/sinusoidal/run.hpp"
#include "tests/testbench/short_drive.hpp"

namespace steplock {
namespace {

// The scenario of a drive with nothing but a profile: set speeds and one load.
design::Settings with_profile(design::Settings s, double duration_s, std::vector<double> at_s, std::vector<double> rpm, double load_s,
                              double load_nm = 0.02) {
  auto& n = s.scenario;
  drop_events(n);
  n.duration_s = duration_s;
  n.set_speed_s = std::move(at_s), n.set_speed_rpm = std::move(rpm);
  n.load_s = {load_s}, n.load_nm = {load_nm};
  return s;
}
design::Settings six_step() { return with_profile(short_drive(), 1.3, {0.6, 0.95}, {2000, 2800}, 0.4); }
design::Settings sinusoidal_drive(const std::string& name) { return open_drive_file(STEPLOCK_DRIVES "/" + name + ".toml").settings; }

// What the rotor does in the last half of each piece is what was asked for, and what is asked for is what the scenario says.
void expect_followed(const std::vector<Piece>& all, const std::vector<std::array<double, 3>>& wanted) {
  ASSERT_EQ(all.size(), wanted.size());
  for (std::size_t k = 0; k < all.size(); ++k) {
    const auto& [from, rpm, load] = wanted[k];
    EXPECT_NEAR(all[k].from_s, from, 1e-6);
    EXPECT_NEAR(all[k].set_rpm, rpm, 1e-9) << from;
    EXPECT_DOUBLE_EQ(all[k].load_nm, load) << from;
    EXPECT_TRUE(all[k].locked) << from;
    EXPECT_LT(std::abs(all[k].error_percent()), 0.5) << from;
    EXPECT_LE(all[k].speed_rpm.least, all[k].mean_rpm);
    EXPECT_GE(all[k].speed_rpm.greatest, all[k].mean_rpm);
  }
}

TEST(Profile, ASixStepDriveFollowsIt) {
  for (const EngineKind engine : {EngineKind::kRtl, EngineKind::kFixed, EngineKind::kFloat}) {
    const Summary sum = run_short(six_step(), engine);
    EXPECT_TRUE(sum.failures().empty()) << why(sum);
    expect_followed(sum.profile, {{0.4, 3000, 0.02}, {0.6, 2000, 0.02}, {0.95, 2800, 0.02}});
  }
}

TEST(Profile, InReverseItsSpeedsAreNegative) {
  design::Settings s = six_step();
  s.scenario.reverse = true;
  const Summary sum = run_short(s, EngineKind::kFixed);
  expect_followed(sum.profile, {{0.4, -3000, 0.02}, {0.6, -2000, 0.02}, {0.95, -2800, 0.02}});
}

TEST(Profile, ASinusoidalDriveFollowsIt) {
  const design::Settings s = with_profile(sinusoidal_drive("m2310p_sinusoidal"), 2.7, {0.9, 1.5}, {1500, 2500}, 2.1);
  for (const EngineKind engine : {EngineKind::kFixed, EngineKind::kFloat}) {
    const RunOptions options{.engine = engine};
    const auto result = sinusoidal::summarise(s, options, sinusoidal::run(s, options));
    EXPECT_TRUE(result.failures().empty()) << result.failures().front();
    expect_followed(result.profile, {{0.9, 1500, 0}, {1.5, 2500, 0}, {2.1, 2500, 0.02}});
  }
}

// Rows of Matsui's Table III from his drive's file: 100 r/min within its 0.4 %, and 35, below what a start may ask for.
TEST(Profile, SpeedsOfTableThreeRunFromAFile) {
  design::Settings s = with_profile(sinusoidal_drive("matsui1996"), 6, {1.2, 3.5}, {100, 35}, 2.4, 5.7);
  const RunOptions options{.engine = EngineKind::kFixed};
  const auto result = sinusoidal::summarise(s, options, sinusoidal::run(s, options));
  EXPECT_TRUE(result.failures().empty()) << result.failures().front();
  ASSERT_EQ(result.profile.size(), 3u);
  for (const Piece& p : result.profile) EXPECT_LT(std::abs(p.error_percent()), 0.4) << p.from_s;
  s.scenario.speed_rpm = 35;
  EXPECT_FALSE(design::problems(s).empty()) << "a start asks for more";
}

// A rotor that is held loses its lock; the run fails, and says where.
TEST(Profile, ALockThatIsLostFails) {
  design::Settings s = six_step();
  s.scenario.load_s = {1}, s.scenario.load_nm = {20};
  const Summary sum = run_short(s, EngineKind::kFixed);
  ASSERT_EQ(sum.profile.size(), 3u);
  EXPECT_TRUE(sum.profile[0].locked);
  EXPECT_FALSE(sum.profile[2].locked);
  EXPECT_NE(why(sum).find("not locked at 1.300 s, with 2800 rpm and 20 N m"), std::string::npos) << why(sum);
}

TEST(Profile, WithoutOneThereAreNoPieces) {
  EXPECT_TRUE(pieces(short_drive(), 10).empty());
  EXPECT_EQ(pieces(six_step(), 0.5).size(), 1u) << "nor those that the run did not come to";
}

// The load is what the plant has; an event that comes after keeps both.
TEST(Profile, ItsEventsHoldUntilTheNext) {
  design::Settings s = six_step();
  s.load.opposing_nm = 0.001;
  s.scenario.reverse_s = 1.1;
  const Timeline t = timeline(s);
  ASSERT_EQ(t.events.size(), 6u);
  const Event& last = t.events.back();
  EXPECT_EQ(last.what, "reverse");
  EXPECT_DOUBLE_EQ(last.load_nm, 0.021);
  EXPECT_DOUBLE_EQ(last.command.set_speed, design::steps_per_second(s, 2800));
  EXPECT_DOUBLE_EQ(t.steady_end_s, 0.4);
}

}  // namespace
}  // namespace steplock
