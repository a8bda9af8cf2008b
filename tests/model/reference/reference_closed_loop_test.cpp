// The reference drive turns every motor in drives/: from six angles, under load, reversed; with
// motors that differ from their data; caught while spinning; from Hall sensors.
#include <gtest/gtest.h>

#include <random>

#include "tests/model/reference/closed_loop.hpp"

namespace steplock {
namespace {

using reference::Reason;
using reference::State;
using test::ClosedLoop;
using test::Verdict;

design::Settings settings_of(const std::string& name) {
  return load_drive_file(DRIVES "/" + name + ".toml").settings;
}

Verdict run(const design::Settings& s, double angle_deg) {
  return ClosedLoop(s, design::design_drive(s).parameters, plant_parameters(s), angle_deg).run();
}

// Of the limit's current.  Delay and blanking let it overshoot by a fifth.  What a leading rotor drives
// through two low sides passes the shunt by, so the limit cannot hold it where a shorted motor at set
// speed already carries more.
double most_over_limit(const design::Settings& s) {
  const double w = s.scenario.speed_rpm * M_PI / 30 * s.motor.pole_pairs;
  const double impedance = std::hypot(s.motor.resistance_ohm + s.inverter.on_resistance_ohm,
                                      w * (s.motor.inductance_h - s.motor.mutual_h));
  return w * s.motor.flux_vs / impedance > 1.2 * s.sensors.limit_a ? 1.5 : 1.2;
}

// Only as far as the load step.
design::Settings until_load(design::Settings s) {
  s.scenario.duration_s = s.scenario.load_step_s.value();
  s.scenario.load_step_s = s.scenario.load_off_s = s.scenario.reverse_s = s.scenario.stop_s = {};
  return s;
}

class Drive : public testing::TestWithParam<const char*> {};

// From one of the six to the scenario's end, for want of time.  (The drive itself is, from all six:
// <drive>_runs_from_<angle>_degrees.)
TEST_P(Drive, StartsFromSixAnglesHoldsItsSpeedAndFromOneTakesALoadStepAndReverses) {
  const auto whole = settings_of(GetParam()), s = until_load(whole);
  for (int angle = 0; angle < 360; angle += 60) {
    const bool to_the_end = angle == 60;  // exactly opposite to the reset position
    const auto v = run(to_the_end ? whole : s, angle);
    ASSERT_TRUE(v.locked) << angle;
    EXPECT_EQ(v.tries, to_the_end ? 2 : 1) << angle;  // one start each way, none repeated
    EXPECT_EQ(v.locks_lost, 0) << angle;
    EXPECT_EQ(v.step_outs, 0) << angle;
    EXPECT_EQ(v.reason, Reason::kNone) << angle;
    EXPECT_NEAR(v.mean_rpm, s.scenario.speed_rpm, 0.005 * s.scenario.speed_rpm) << angle;
    if (to_the_end) {
      EXPECT_NEAR(v.loaded_rpm, s.scenario.speed_rpm, 0.01 * s.scenario.speed_rpm) << angle;
      EXPECT_NEAR(v.reversed_rpm, -s.scenario.speed_rpm, 0.01 * s.scenario.speed_rpm) << angle;
    }
    EXPECT_LT(v.peak_current, most_over_limit(s) * s.sensors.limit_a) << angle;
    EXPECT_LT(v.worst_error_deg, 20) << angle;  // a third of a step costs 6 % of torque
  }
}

// What a data sheet leaves open: every parameter up to 20 % off, friction between 0.6 and 1.6
// times, the bus 10 % off, comparator offsets and noise doubled.  The first of them is reversed as well.
TEST_P(Drive, StartsAMotorThatDiffersFromItsDataSheet) {
  const auto whole = settings_of(GetParam()), s = until_load(whole);
  const auto p = design::design_drive(whole).parameters;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> sign(-1, 1);
  const auto off = [&](double value) { return value * (1 + 0.2 * sign(random)); };
  for (int k = 0; k < 5; ++k) {
    auto plant = plant_parameters(s);
    auto& m = plant.motor;
    for (double* value : {&m.resistance, &m.inductance, &m.flux, &m.inertia, &m.fan_friction,
                          &plant.load.inertia}) {
      *value = off(*value);
    }
    m.coulomb_friction *= std::exp(sign(random) * std::log(1.6));
    m.static_friction = 1.2 * m.coulomb_friction;
    plant.bus.voltage *= 1 + 0.1 * sign(random);
    for (auto& c : plant.sensing.comparator) c.offset *= 2, c.noise *= 2;
    plant.sensing.seed = 100 + k;
    const auto v = ClosedLoop(k == 0 ? whole : s, p, plant, 180 * sign(random)).run();
    EXPECT_TRUE(v.locked) << k;
    EXPECT_EQ(v.tries, k == 0 ? 2 : 1) << k;
    EXPECT_EQ(v.locks_lost, 0) << k;
    EXPECT_EQ(v.step_outs, 0) << k;
  }
}

INSTANTIATE_TEST_SUITE_P(ReferenceDrive, Drive,
                         testing::Values("amano2003", "bly172s", "br2804_drone", "ceiling_fan",
                                         "hoverboard_hub", "m2310p_servo", "maxon_ec45_flat",
                                         "tekin_spindle"),
                         [](const auto& info) { return std::string(info.param); });

// A short scenario of the servo, without load step and reversal.
design::Settings servo(double duration) {
  auto s = settings_of("m2310p_servo");
  s.scenario.load_step_s = s.scenario.load_off_s = s.scenario.reverse_s = s.scenario.stop_s = {};
  s.scenario.duration_s = duration;
  return s;
}

TEST(ReferenceDrive, CatchesARotorThatSpinsTheRightWay) {
  auto s = servo(0.3);
  s.scenario.start_speed_rpm = 2500;
  const auto v = run(s, 0);
  EXPECT_EQ(v.tries, 0);  // never accelerated from rest
  EXPECT_LT(v.lock_time, 0.02);
  EXPECT_EQ(v.step_outs, 0);
  EXPECT_NEAR(v.mean_rpm, 3000, 15);
}

TEST(ReferenceDrive, StopsARotorThatSpinsTheOtherWayFirst) {
  auto s = servo(0.6);
  s.scenario.start_speed_rpm = -2500;
  const auto v = run(s, 0);
  EXPECT_EQ(v.tries, 1);
  EXPECT_NEAR(v.mean_rpm, 3000, 15);
  EXPECT_EQ(v.step_outs, 0);
}

TEST(ReferenceDrive, StartsInReverse) {
  auto s = servo(0.5);
  s.scenario.reverse = true;
  EXPECT_NEAR(run(s, 120).mean_rpm, -3000, 15);
}

TEST(ReferenceDrive, RunsFromHallSensors) {
  auto s = servo(1.0);
  s.control.source = design::Source::kHall;
  const auto v = run(s, 200);
  EXPECT_EQ(v.tries, 0);
  EXPECT_NEAR(v.mean_rpm, 3000, 15);
}

// An update per turn is slow to pull in, and to control: the speed's slew is a sixteenth of the other detector's.
// The run lasts as long as the slew needs for the set speed, and a second for the start and for settling.
TEST(ReferenceDrive, LocksWithThePapersPhaseDetectorToo) {
  auto s = servo(0);
  s.loop.detector = design::Detector::kOncePerTurn;
  const double steps_s = s.scenario.speed_rpm / 60 * s.motor.pole_pairs * 6;
  s.scenario.duration_s = 1 + steps_s / design::design_drive(s).parameters.speed.slew;
  for (const double degrees : {0.0, 30.0, 150.0, 270.0}) {
    const auto v = run(s, degrees);
    EXPECT_TRUE(v.locked) << degrees;
    EXPECT_EQ(v.step_outs, 0) << degrees;
    EXPECT_NEAR(v.mean_rpm, 3000, 15) << degrees;
    EXPECT_EQ(v.tries, 1) << degrees;
  }
}

TEST(ReferenceDrive, AdvancesThePhaseByWhatIsAsked) {
  auto s = servo(0.6);
  const auto plain = run(s, 0);
  s.loop.advance_deg = 15;
  const auto advanced = run(s, 0);  // its errors are counted from the advanced place
  EXPECT_NEAR(plain.mean_error_deg, 0, 1);
  EXPECT_NEAR(advanced.mean_error_deg, 0, 1);
}

TEST(ReferenceDrive, GivesUpOnABlockedRotor) {
  auto s = servo(6);  // a try lasts for 4095 ticks
  auto plant = plant_parameters(s);
  plant.motor.coulomb_friction = plant.motor.static_friction = 10;
  const auto v = ClosedLoop(s, design::design_drive(s).parameters, plant, 0).run();
  EXPECT_FALSE(v.locked);
  EXPECT_GE(v.tries, 2);
  EXPECT_EQ(v.mean_rpm, 0);
}

TEST(ReferenceDrive, NoticesARotorThatIsBlockedWhileItRuns) {
  auto s = servo(1);
  s.scenario.load_step_s = 0.4;
  s.scenario.load_off_s = 0.9;
  s.scenario.load_step_nm = 5;  // twenty times what it can give
  const auto v = run(s, 0);
  EXPECT_GE(v.locks_lost, 1);
  EXPECT_NE(v.reason, Reason::kNone);
}

}  // namespace
}  // namespace steplock
