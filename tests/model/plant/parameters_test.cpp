#include "model/plant/parameters.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "model/plant/plant.hpp"

namespace steplock::plant {
namespace {

std::string only_problem(const Parameters& p) {
  const auto problems = validate(p);
  return problems.size() == 1 ? problems[0] : "(" + std::to_string(problems.size()) + " problems)";
}

TEST(Parameters, DefaultsAreAUsableMotor) { EXPECT_TRUE(validate({}).empty()); }

TEST(Parameters, AProblemNamesTheKeyItsValueAndTheRule) {
  Parameters p;
  p.motor.resistance = 0;
  EXPECT_EQ(only_problem(p), "motor.resistance is 0; must be above 0");
}

TEST(Parameters, EveryProblemIsReportedNotJustTheFirst) {
  Parameters p;
  p.motor.pole_pairs = 0;
  p.bridge.diode_drop = -1;
  p.sensing.comparator[2].noise = -1;
  const auto problems = validate(p);
  ASSERT_EQ(problems.size(), 3u);
  EXPECT_EQ(problems[0], "motor.pole_pairs is 0; must be from 1 to 100");
  EXPECT_EQ(problems[1], "bridge.diode_drop is -1; must be above 0");
  EXPECT_EQ(problems[2], "sensing.comparator[2].noise is -1; must be 0 or above");
}

TEST(Parameters, NotANumberIsNeverInRange) {
  Parameters p;
  p.motor.inertia = std::nan("");
  p.motor.cogging_phase = std::nan("");
  p.accuracy.tolerance = std::nan("");
  EXPECT_EQ(validate(p).size(), 3u);
}

struct Key {
  const char* name;
  std::function<double&(Parameters&)> of;
  std::vector<double> taken, refused;  // the ends of its range, and what lies just beyond
};

const std::vector<Key>& keys() {
  constexpr double kInfinite = std::numeric_limits<double>::infinity(), kTiny = 1e-300;
  static const std::vector<double> above = {kTiny, 1, 1e6}, not_above = {0, -kTiny, kInfinite}, from_0 = {0, kTiny, 1e6},
                                   below_0 = {-kTiny, kInfinite}, any = {-1e6, 0, 1e6}, infinite = {kInfinite, -kInfinite};
#define STEPLOCK_KEY(key, ...) {#key, [](Parameters& p) -> double& { return p.key; }, __VA_ARGS__}
  static const std::vector<Key> all = {
      STEPLOCK_KEY(motor.shape.flat_top_deg, {0, 175}, {-1e-9, 175.001}),
      STEPLOCK_KEY(motor.resistance, above, not_above),
      STEPLOCK_KEY(motor.saturation_current, above, not_above),
      STEPLOCK_KEY(motor.flux, from_0, below_0),
      STEPLOCK_KEY(motor.inertia, above, not_above),
      STEPLOCK_KEY(motor.cogging_torque, from_0, below_0),
      STEPLOCK_KEY(motor.cogging_phase, any, infinite),
      STEPLOCK_KEY(motor.coulomb_friction, {0, 1e-3}, {-kTiny}),  // static friction is 1e-3
      STEPLOCK_KEY(motor.static_friction, {1e-3, 1}, {kInfinite}),
      STEPLOCK_KEY(motor.viscous_friction, from_0, below_0),
      STEPLOCK_KEY(motor.fan_friction, from_0, below_0),
      STEPLOCK_KEY(load.inertia, from_0, below_0),
      STEPLOCK_KEY(load.opposing_torque, from_0, below_0),
      STEPLOCK_KEY(load.active_torque, any, infinite),
      STEPLOCK_KEY(load.breakaway_torque, from_0, below_0),
      STEPLOCK_KEY(load.unbalance_torque, from_0, below_0),
      STEPLOCK_KEY(load.unbalance_angle, any, infinite),
      STEPLOCK_KEY(load.spring_damping, from_0, below_0),
      STEPLOCK_KEY(bus.voltage, above, not_above),
      STEPLOCK_KEY(bus.resistance, from_0, below_0),
      STEPLOCK_KEY(bus.capacitance, above, not_above),
      STEPLOCK_KEY(bridge.on_resistance, from_0, below_0),
      STEPLOCK_KEY(bridge.diode_drop, above, not_above),
      STEPLOCK_KEY(bridge.diode_resistance, from_0, below_0),
      STEPLOCK_KEY(sensing.comparator[1].offset, any, infinite),
      STEPLOCK_KEY(sensing.comparator[1].hysteresis, from_0, below_0),
      STEPLOCK_KEY(sensing.comparator[1].delay, from_0, below_0),
      STEPLOCK_KEY(sensing.comparator[1].noise, from_0, below_0),
      STEPLOCK_KEY(sensing.comparator[1].noise_interval, {1e-9, 1}, {0.99e-9, 1.01}),
      STEPLOCK_KEY(sensing.limit.offset, any, infinite),
      STEPLOCK_KEY(sensing.limit.noise_interval, {1e-9, 1}, {0.99e-9, 1.01}),
      STEPLOCK_KEY(sensing.limit_threshold, above, not_above),
      STEPLOCK_KEY(sensing.hall_error_deg[2], {-30, 30}, {-30.01, 30.01}),
      STEPLOCK_KEY(sensing.hall_delay, from_0, below_0),
      STEPLOCK_KEY(accuracy.tolerance, {1e-12, 1e-3}, {0.9e-12, 1.1e-3}),
      STEPLOCK_KEY(accuracy.max_step, {1e-9, 1}, {0.99e-9, 1.01}),
  };
#undef STEPLOCK_KEY
  return all;
}

TEST(Parameters, EveryKeyIsTakenWithinItsRangeAndRefusedBeyondByName) {
  for (const Key& key : keys()) {
    for (const double value : key.taken) {
      Parameters p;
      key.of(p) = value;
      EXPECT_TRUE(validate(p).empty()) << key.name << " = " << value << ": " << only_problem(p);
    }
    for (const double value : key.refused) {
      Parameters p;
      key.of(p) = value;
      EXPECT_EQ(only_problem(p).find(std::string(key.name) + " is "), 0u) << key.name << " = " << value << ": " << only_problem(p);
    }
    Parameters p;
    key.of(p) = std::nan("");
    EXPECT_EQ(only_problem(p).find(std::string(key.name) + " is "), 0u) << key.name << ": " << only_problem(p);
  }
}

TEST(Parameters, ASalientMotorsKeysToo) {
  for (const bool along : {true, false}) {
    Parameters p;
    p.motor.shape.kind = BackEmfShape::Kind::kSinusoidal;
    double& inductance = along ? p.motor.inductance_d : p.motor.inductance_q;
    for (const double value : {0.0, 1e-300, 0.1}) {
      inductance = value;
      EXPECT_TRUE(validate(p).empty()) << value;
    }
    inductance = -1e-300;
    EXPECT_EQ(only_problem(p).find(along ? "motor.inductance_d is" : "motor.inductance_q is"), 0u) << only_problem(p);
    inductance = 1e-300;
    p.motor.shape.kind = BackEmfShape::Kind::kTrapezoidal;
    EXPECT_EQ(only_problem(p).find("motor.shape is not sinusoidal"), 0u) << only_problem(p);
  }
  Parameters p;
  p.motor.shape.kind = BackEmfShape::Kind::kSinusoidal;
  p.motor.saturation = 0.9;
  EXPECT_TRUE(validate(p).empty());
  p.motor.saturation = 0.91;
  EXPECT_EQ(only_problem(p), "motor.saturation is 0.91; must be from 0 to 0.9");
}

TEST(Parameters, WholeNumbersHaveTheirRangesToo) {
  Parameters p;
  for (const int pairs : {1, 100}) {
    p.motor.pole_pairs = pairs;
    EXPECT_TRUE(validate(p).empty());
  }
  p.motor.pole_pairs = 101;
  EXPECT_EQ(only_problem(p), "motor.pole_pairs is 101; must be from 1 to 100");
  p = {};
  p.motor.cogging_periods = 1;
  EXPECT_TRUE(validate(p).empty());
  p.motor.cogging_periods = 0;
  EXPECT_EQ(only_problem(p), "motor.cogging_periods is 0; must be 1 or above");
}

TEST(Parameters, AFlatTopIsOnlyATrapezoids) {
  Parameters p;
  p.motor.shape = {.kind = BackEmfShape::Kind::kSinusoidal, .flat_top_deg = -1};
  EXPECT_TRUE(validate(p).empty());
}

TEST(Parameters, WindNeedsAFanAndASpringAnInertia) {
  Parameters p;
  p.load.wind_speed = 1;
  EXPECT_EQ(only_problem(p).find("load.wind_speed is not 0"), 0u) << only_problem(p);
  p.load.wind_speed = std::nan("");
  p.motor.fan_friction = 1e-300;
  EXPECT_EQ(only_problem(p).find("load.wind_speed is nan"), 0u) << only_problem(p);
  p.load.wind_speed = -1;
  EXPECT_TRUE(validate(p).empty());
  p.load.spring_stiffness = 1e-300;
  EXPECT_EQ(only_problem(p).find("load.spring_stiffness is not 0"), 0u) << only_problem(p);
  p.load.inertia = 1e-300;
  EXPECT_TRUE(validate(p).empty());
  p.load.spring_stiffness = -1;
  EXPECT_EQ(only_problem(p).find("load.spring_stiffness is -1"), 0u) << only_problem(p);
}

TEST(Parameters, MutualInductanceMustLeaveSomeInductance) {
  Parameters p;
  p.motor.mutual = p.motor.inductance;
  EXPECT_EQ(only_problem(p), "motor.mutual must be below motor.inductance");
  p.motor.mutual = std::nextafter(p.motor.inductance, 0);
  EXPECT_TRUE(validate(p).empty());
  p.motor.mutual = -1e-3;
  p.motor.inductance = 0;
  EXPECT_EQ(only_problem(p), "motor.inductance is 0; must be above 0");
}

TEST(Parameters, BreakawayBelowSlidingFrictionIsRefused) {
  Parameters p;
  p.motor.static_friction = p.motor.coulomb_friction / 2;
  EXPECT_NE(only_problem(p).find("static_friction"), std::string::npos);
}

TEST(Parameters, AStiffBusNeedsNoCapacitorButMustSink) {
  Parameters p;
  p.bus.resistance = 0;
  p.bus.capacitance = 0;
  EXPECT_TRUE(validate(p).empty());
  p.bus.sinks = false;
  EXPECT_EQ(only_problem(p), "bus.sinks is false with bus.resistance 0; a stiff bus always sinks, give a resistance");
}

TEST(Parameters, AShortOrWildBemfTableIsRefused) {
  Parameters p;
  p.motor.shape.kind = BackEmfShape::Kind::kTable;
  p.motor.shape.table = {0, 1, 0, -1};
  EXPECT_NE(only_problem(p).find("has 4 values"), std::string::npos);
  p.motor.shape.table = std::vector<double>(7, 0.5);
  EXPECT_NE(only_problem(p).find("has 7 values"), std::string::npos);
  p.motor.shape.table = {-2, 2, 0, 0, 0, 0, 0, 0};
  EXPECT_TRUE(validate(p).empty());
  p.motor.shape.table = std::vector<double>(12, 0.5);
  p.motor.shape.table[7] = 30;
  EXPECT_EQ(only_problem(p), "motor.shape.table[7] is 30; must be from -2 to 2");
}

TEST(Parameters, ThePlantRefusesWhatValidateRefuses) {
  Parameters p;
  p.motor.inductance = -1;
  EXPECT_THROW(Plant{p}, std::invalid_argument);
  EXPECT_THROW(Plant({}, {.current = {1, 0, 0}}), std::invalid_argument);
}

}  // namespace
}  // namespace steplock::plant
