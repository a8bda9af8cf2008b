// Advice after a run that failed: it names a key and a value, and the run passes with them.
#include "testbench/drive/six_step/advice.hpp"
#include "testbench/run/advice.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <tuple>

#include "model/design/design.hpp"
#include "testbench/drive/sinusoidal/run.hpp"
#include "tests/testbench/short_drive.hpp"

namespace steplock {
namespace {

using testing::HasSubstr;

// The keys that a drive file must have, and nothing else: no friction, and the chopping that is the default.
constexpr const char* kRequired = R"(
[drive]
name = "required keys alone"
source = "tests/testbench/advice_test.cpp"
[motor]
resistance_ohm = 0.38
inductance_h = 0.2e-3
flux_vs = 6.37e-3
pole_pairs = 4
inertia_kgm2 = 7.06e-6
rated_current_a = 5
[inverter]
bus_v = 24
[sensors]
limit_a = 15
[control]
clock_hz = 12e6
pwm_hz = 30e3
[scenario]
speed_rpm = 3000
duration_s = 0.8
)";

design::Settings required() { return parse_drive_file(kRequired, "required.toml").settings; }

Summary run_of(const design::Settings& s) { return run_short(s, EngineKind::kFixed); }

// The number behind a key in a line of advice.
double value_behind(const std::string& line, const std::string& key) {
  const auto at = line.find(key);
  EXPECT_NE(at, line.npos) << line;
  return std::stod(line.substr(at + key.size()));
}

TEST(Advice, ARunThatPassesGetsNone) {
  design::Settings s = required();
  s.motor.coulomb_nm = 3e-3;
  const Summary passed = run_of(s);
  EXPECT_TRUE(passed.failures().empty()) << why(passed);
  EXPECT_TRUE(passed.advice.empty());
}

TEST(Advice, ARotorThatNothingBrakesIsToldToUseTheOtherChopping) {
  design::Settings s = required();
  const Summary failed = run_of(s);
  EXPECT_FALSE(failed.failures().empty());
  ASSERT_EQ(failed.advice.size(), 1u);
  EXPECT_THAT(failed.advice[0], HasSubstr("control.chopping"));
  EXPECT_THAT(failed.advice[0], HasSubstr("\"complementary\""));
  EXPECT_THAT(to_text(failed), HasSubstr("advice: with control.chopping"));
  s.control.chopping = design::Chopping::kComplementary;
  const Summary followed = run_of(s);
  EXPECT_TRUE(followed.failures().empty()) << why(followed);
}

TEST(Advice, ALoadThatTheLimitCannotMoveIsToldWhichLimitCan) {
  design::Settings s = required();
  s.control.chopping = design::Chopping::kComplementary;
  s.motor.coulomb_nm = 0.2, s.motor.rated_current_a = 2, s.sensors.limit_a = 4;  // which move 0.18
  s.scenario.speed_rpm = 1500, s.scenario.duration_s = 8;
  const Summary failed = run_of(s);
  EXPECT_FALSE(failed.lock_time_s);
  ASSERT_EQ(failed.advice.size(), 1u);
  s.sensors.limit_a = value_behind(failed.advice[0], "raise sensors.limit_a to ");
  s.scenario.duration_s = 2;
  const Summary followed = run_of(s);
  EXPECT_TRUE(followed.failures().empty()) << why(followed);
}

TEST(Advice, ALoadThatNoCurrentOfThisBusCanMoveIsToldHowMuchCanBe) {
  design::Settings s = required();
  s.motor.coulomb_nm = 2;
  s.scenario.duration_s = 8;
  const Summary failed = run_of(s);
  ASSERT_EQ(failed.advice.size(), 1u);
  EXPECT_THAT(failed.advice[0], HasSubstr("and this bus is good for"));
}

// Two rotors, the second nine times as heavy: what they may have differs by as much.
TEST(Advice, AStartWhoseBackEmfTheHysteresisHidesIsToldHowMuchItMayBe) {
  for (const double heavier : {1.0, 9.0}) {
    design::Settings s = required();
    s.motor.coulomb_nm = 3e-3;
    s.load.inertia_kgm2 = (heavier - 1) * s.motor.inertia_kgm2;
    s.scenario.duration_s = 0.8 * heavier;
    s.control.chopping = design::Chopping::kComplementary;
    EXPECT_TRUE(run_of(s).failures().empty());
    s.sensors.comparator_hysteresis_v = 8;
    const Summary failed = run_of(s);
    ASSERT_EQ(failed.advice.size(), 1u) << to_text(failed);
    s.sensors.comparator_hysteresis_v = value_behind(failed.advice[0], "lower sensors.comparator_hysteresis_v to ");
    EXPECT_LT(s.sensors.comparator_hysteresis_v, 4);
    const Summary followed = run_of(s);
    EXPECT_TRUE(followed.failures().empty()) << heavier << ": " << why(followed);
  }
}

TEST(Advice, ASpeedThatTheBusDoesNotGiveIsToldWhichItDoes) {
  design::Settings s = required();
  s.control.chopping = design::Chopping::kComplementary;
  s.motor.coulomb_nm = 0.3;
  s.scenario.speed_rpm = 4200, s.scenario.duration_s = 2;
  const Summary failed = run_of(s);
  EXPECT_FALSE(failed.failures().empty());
  ASSERT_EQ(failed.advice.size(), 1u) << to_text(failed);
  s.scenario.speed_rpm = value_behind(failed.advice[0], "lower scenario.speed_rpm to ");
  const Summary followed = run_of(s);
  EXPECT_TRUE(followed.failures().empty()) << why(followed);
}

TEST(Advice, ARunThatEndsWhileTheRotorStillGainsIsToldHowLongItTakes) {
  design::Settings s = required();
  s.control.chopping = design::Chopping::kComplementary;
  s.motor.coulomb_nm = 3e-3;
  s.scenario.duration_s = 0.25;
  for (const bool loaded : {false, true}) {
    const std::string key = loaded ? "load_step_s" : "duration_s";
    if (loaded) s.scenario.load_step_s = 0.25, s.scenario.load_off_s = 0.3, s.scenario.duration_s = 0.5;
    const Summary failed = run_of(s);
    EXPECT_FALSE(failed.failures().empty()) << key;
    ASSERT_EQ(failed.advice.size(), 1u) << to_text(failed);
    const double until = value_behind(failed.advice[0], "raise scenario." + key + " to ");
    design::Settings longer = s;
    longer.scenario.duration_s += until - 0.25;
    if (loaded) *longer.scenario.load_step_s = until, *longer.scenario.load_off_s = until + 0.3, longer.scenario.duration_s = until + 0.8;
    const Summary followed = run_of(longer);
    EXPECT_TRUE(followed.failures().empty()) << key << ": " << why(followed);
  }
}

TEST(Advice, ALoadStepThatTheLimitDoesNotCarryIsToldWhichItDoes) {
  design::Settings s = required();
  s.control.chopping = design::Chopping::kComplementary;
  s.motor.coulomb_nm = 3e-3;
  s.scenario.duration_s = 2.5, s.scenario.load_step_s = 1, s.scenario.load_off_s = 1.6, s.scenario.load_step_nm = 1;
  const Summary failed = run_of(s);
  EXPECT_FALSE(failed.failures().empty());
  ASSERT_EQ(failed.advice.size(), 1u) << to_text(failed);
  s.scenario.load_step_nm = value_behind(failed.advice[0], "lower scenario.load_step_nm to ");
  const Summary followed = run_of(s);
  EXPECT_TRUE(followed.failures().empty()) << why(followed);
}

// Or how much current it takes, where the bus has the voltage for it.
TEST(Advice, ALoadStepThatMoreCurrentOfASinusoidalDriveWouldCarryIsToldHowMuch) {
  const RunOptions options{.engine = EngineKind::kFixed};
  const auto run = [&](const design::Settings& x) { return sinusoidal::summarise(x, options, sinusoidal::run(x, options)); };
  design::Settings s = open_drive_file(STEPLOCK_DRIVES "/matsui1996.toml").settings;
  s.scenario.stop_s.reset();
  s.scenario.load_step_nm = 15;  // 14.4 of which its limit of 1.5 times the rated current gives
  const auto failed = run(s);
  EXPECT_FALSE(failed.failures().empty());
  ASSERT_EQ(failed.advice.size(), 1u) << to_text(failed);
  s.sinusoidal.current_limit_a = value_behind(failed.advice[0], "or raise sinusoidal.current_limit_a to ");
  const auto followed = run(s);
  EXPECT_TRUE(followed.failures().empty()) << to_text(followed);
  s.sinusoidal.current_limit_a.reset();
  s.scenario.load_step_nm = 20;  // for whose current the bus has no voltage at this speed
  EXPECT_THAT(run(s).advice.at(0), testing::Not(HasSubstr("raise")));
}

// The sinusoidal drive gets the same of both.
TEST(Advice, ASinusoidalDriveIsToldHowLongItTakesAndWhichLoadItCarries) {
  design::Settings s = open_drive_file(STEPLOCK_DRIVES "/m2310p_sinusoidal.toml").settings;
  s.scenario.stop_s.reset();
  const auto run = [](const design::Settings& x) {
    const RunOptions options{.engine = EngineKind::kFixed, .angle_deg = 0};
    return sinusoidal::summarise(x, options, sinusoidal::run(x, options));
  };
  design::Settings soon = s;
  soon.scenario.load_step_s.reset(), soon.scenario.load_off_s.reset(), soon.scenario.load_step_nm.reset();
  soon.scenario.duration_s = 0.25;
  const auto failed = run(soon);
  ASSERT_EQ(failed.advice.size(), 1u) << to_text(failed);
  EXPECT_THAT(to_text(failed), HasSubstr("advice"));
  soon.scenario.duration_s = value_behind(failed.advice[0], "raise scenario.duration_s to ");
  const auto longer = run(soon);
  EXPECT_TRUE(longer.failures().empty()) << to_text(longer);

  s.scenario.load_step_nm = 2;
  const auto heavy = run(s);
  ASSERT_EQ(heavy.advice.size(), 1u) << to_text(heavy);
  s.scenario.load_step_nm = value_behind(heavy.advice[0], "lower scenario.load_step_nm to ");
  const auto lighter = run(s);
  EXPECT_TRUE(lighter.failures().empty()) << to_text(lighter);
}

// At low speed without load; with the current that is named they swing half as far at most.  Two noises of the ADCs each.
TEST(Advice, ARotorThatSwingsForWantOfCurrentIsToldWhichCurrent) {
  const RunOptions options{.engine = EngineKind::kFixed};
  const auto run = [&](const design::Settings& s) { return sinusoidal::summarise(s, options, sinusoidal::run(s, options)); };
  const auto swing = [](const sinusoidal::Result& r) { return r.profile.at(0).speed_rpm.greatest - r.profile.at(0).speed_rpm.least; };
  const std::tuple<const char*, double, double> slow[] = {
      {"matsui1996", 35, 0.9}, {"ipm_2k2", 30, 0.9}, {"m2310p_sinusoidal", 100, 0.5}};
  for (const auto& [file, rpm, running_s] : slow) {
    for (const int seed : {1, 2}) {
      design::Settings s = open_drive_file(std::string(STEPLOCK_DRIVES "/") + file + ".toml").settings;
      drop_events(s.scenario);
      s.sensors.seed = seed;
      s.scenario.duration_s = running_s + 1.5;
      s.scenario.set_speed_s = {running_s}, s.scenario.set_speed_rpm = {rpm};
      const auto swings = run(s);
      ASSERT_EQ(swings.advice.size(), 1u) << file << to_text(swings);
      EXPECT_THAT(swings.advice[0], HasSubstr("the rotor swings from"));
      EXPECT_THAT(to_text(swings), HasSubstr(swings.advice[0]));
      s.sinusoidal.i_gamma_a = value_behind(swings.advice[0], "write sinusoidal.i_gamma_a = ");
      const auto followed = run(s);
      EXPECT_TRUE(followed.failures().empty()) << to_text(followed);
      EXPECT_TRUE(followed.advice.empty()) << to_text(followed);
      EXPECT_LT(swing(followed), swing(swings) / 2) << file << ", " << seed << "\n" << to_text(followed);
    }
  }
}

// A rotor that a weight swings at 1200 r/min is told nothing of dead time: there it takes a twentieth of the EMF.
TEST(Advice, ARotorThatAWeightSwingsIsToldOfNoCurrent) {
  const RunOptions options{.engine = EngineKind::kFixed};
  design::Settings s = open_drive_file(STEPLOCK_DRIVES "/matsui1996.toml").settings;
  drop_events(s.scenario);
  s.load.unbalance_nm = 8;
  s.scenario.duration_s = 1.5;
  const auto r = sinusoidal::summarise(s, options, sinusoidal::run(s, options));
  ASSERT_TRUE(r.locked) << to_text(r);
  EXPECT_GT(r.ripple.speed_rpm.greatest - r.ripple.speed_rpm.least, 0.25 * 1200) << to_text(r);
  EXPECT_THAT(r.advice, testing::Not(testing::Contains(HasSubstr("i_gamma_a"))));
}

// And one that swings little is told nothing.
TEST(Advice, ASinusoidalDriveThatRunsWellGetsNone) {
  const RunOptions options{.engine = EngineKind::kFixed};
  for (const char* file : {"m2310p_sinusoidal", "br2804_sinusoidal", "ipm_2k2", "matsui1996"}) {
    const design::Settings s = open_drive_file(std::string(STEPLOCK_DRIVES "/") + file + ".toml").settings;
    const auto r = sinusoidal::summarise(s, options, sinusoidal::run(s, options));
    EXPECT_TRUE(r.failures().empty()) << to_text(r);
    EXPECT_TRUE(r.advice.empty()) << to_text(r);
  }
}

}  // namespace
}  // namespace steplock
