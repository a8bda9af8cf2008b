#include "model/plant/parameters.hpp"

#include <gtest/gtest.h>

#include <cmath>

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

TEST(Parameters, MutualInductanceMustLeaveSomeInductance) {
  Parameters p;
  p.motor.mutual = p.motor.inductance;
  EXPECT_EQ(only_problem(p), "motor.mutual must be below motor.inductance");
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
  EXPECT_NE(only_problem(p).find("bus.sinks"), std::string::npos);
}

TEST(Parameters, AShortOrWildBemfTableIsRefused) {
  Parameters p;
  p.motor.shape.kind = BackEmfShape::Kind::kTable;
  p.motor.shape.table = {0, 1, 0, -1};
  EXPECT_NE(only_problem(p).find("has 4 values"), std::string::npos);
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
