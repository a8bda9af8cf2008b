#include "model/plant/sensors.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "tests/model/plant/coasting.hpp"

namespace steplock::plant {
namespace {

TEST(Sensors, CoastingComparatorsSwitchAtTheBemfsCrossings) {
  const auto edges = coast(steady(), {.angle = 10 * kDegree / 4, .speed = kSpeed3000}, 5e-3);
  std::vector<double> crossings;
  for (std::size_t n = 0; n < edges.size(); ++n) {
    const auto& before =
        n == 0 ? Pins{{true, false, true}, false, {false, false, true}} : edges[n - 1].pins;
    if (before.comparator != edges[n].pins.comparator) crossings.push_back(edges[n].time);
  }
  ASSERT_EQ(crossings.size(), 6u);  // 10 to 370 degrees: 60, 120, ... 360
  for (int n = 0; n < 6; ++n) EXPECT_NEAR(crossings[n], (50 + 60 * n) * kPerDegree, 2e-9);
}

TEST(Sensors, HallsSwitchAtTheIdealCommutationAnglesShiftedByTheirErrors) {
  Parameters p = steady();
  p.sensing.hall_error_deg = {0, 2, -3};
  const auto edges = coast(p, {.angle = 10 * kDegree / 4, .speed = kSpeed3000}, 5e-3);
  std::vector<double> times;
  for (std::size_t n = 0; n < edges.size(); ++n) {
    const bool changed = n == 0 || edges[n - 1].pins.hall != edges[n].pins.hall;
    if (changed) times.push_back(edges[n].time);
  }
  ASSERT_EQ(times.size(), 6u);
  const double error[] = {0, -3, 2};  // u rises at 30, w falls at 90, v rises at 150, ...
  for (int n = 0; n < 6; ++n) {
    EXPECT_NEAR(times[n], (20 + 60 * n + error[n % 3]) * kPerDegree, 2e-9) << n;
  }
}

TEST(Sensors, HallsSwitchAtTheSameAnglesBackwards) {
  const auto edges = coast(steady(), {.angle = 10 * kDegree / 4, .speed = -kSpeed3000}, 5e-3);
  int halls = 0;
  for (std::size_t n = 0; n < edges.size(); ++n) {
    if (n > 0 && edges[n - 1].pins.hall == edges[n].pins.hall) continue;
    const double angle = 10 - edges[n].time / kPerDegree;
    const double from_edge = std::remainder(angle - 30, 60);
    halls += std::abs(from_edge) < 1e-3;
  }
  EXPECT_EQ(halls, 6);
}

TEST(Sensors, DelayShiftsThePinAndNothingElse) {
  Parameters p = steady();
  const auto prompt = coast(p, {.angle = 40 * kDegree / 4, .speed = kSpeed3000}, 2e-3);
  for (auto& c : p.sensing.comparator) c.delay = 3e-6;
  const auto late = coast(p, {.angle = 40 * kDegree / 4, .speed = kSpeed3000}, 2e-3);
  ASSERT_EQ(prompt.size(), late.size());
  for (std::size_t n = 0; n < late.size(); ++n) {
    const bool hall = n > 0 ? prompt[n].pins.hall != prompt[n - 1].pins.hall : false;
    EXPECT_NEAR(late[n].time - prompt[n].time, hall ? 0 : 3e-6, 1e-11);
  }
}

TEST(Sensors, AnEdgeUnderwayArrivesEvenIfTheGatesChangeBeforeIt) {
  Parameters p = steady();
  for (auto& c : p.sensing.comparator) c.delay = 5e-6;
  Plant plant(p, {.angle = 45 * kDegree / 4, .speed = 0});
  plant.set_gates({.uh = true, .vl = true});  // u above, v below the virtual neutral
  EXPECT_FALSE(plant.pins().comparator[0]);
  plant.advance_to(2e-6);
  plant.set_gates({.ul = true, .vl = true});
  plant.advance_to(4.999e-6);
  EXPECT_FALSE(plant.pins().comparator[0]);
  plant.advance_to(5.001e-6);
  EXPECT_TRUE(plant.pins().comparator[0]);  // the first change, though u is low by now
  plant.advance_to(7.001e-6);
  EXPECT_FALSE(plant.pins().comparator[0]);  // the second
}

// Two in one instant: the pin takes them in the order in which they came.
TEST(Sensors, TheLaterOfTwoChangesInOneInstantStands) {
  Parameters p = steady();
  for (auto& c : p.sensing.comparator) c.delay = 5e-6;
  Plant plant(p, {.angle = 45 * kDegree / 4});
  plant.set_gates({.uh = true, .vl = true});
  plant.set_gates({.ul = true, .vh = true});
  plant.advance_to(6e-6);
  EXPECT_FALSE(plant.pins().comparator[0]);
  EXPECT_TRUE(plant.pins().comparator[1]);
}

// Within the hysteresis a comparator starts low.
TEST(Sensors, StartsLowBetweenItsThresholds) {
  Parameters p = steady();
  for (auto& c : p.sensing.comparator) c.hysteresis = 2;
  const Plant within(p, {.angle = 3 * kDegree / 4, .speed = kSpeed3000});  // u at 0.4 V
  EXPECT_EQ(within.pins().comparator, (std::array<bool, 3>{false, false, true}));
  const Plant above(p, {.angle = 10 * kDegree / 4, .speed = kSpeed3000});  // at 1.4 V
  EXPECT_EQ(above.pins().comparator, (std::array<bool, 3>{true, false, true}));
}

TEST(Sensors, TheFirstPinsAreThoseOfTheAngleWhateverTheDelays) {
  const std::array<bool, 3> code[6] = {{0, 0, 1}, {1, 0, 1}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 1, 1}};
  Parameters p = steady();
  p.sensing.hall_delay = p.sensing.limit.delay = 20e-6;
  for (auto& c : p.sensing.comparator) c.delay = 20e-6;
  for (int sector = 0; sector < 6; ++sector) {
    Plant plant(p, {.angle = (10 + 60 * sector) * kDegree / 4, .speed = kSpeed3000});
    const Pins pins = plant.pins();
    EXPECT_EQ(pins.hall, code[sector]) << sector;
    plant.advance_to(100e-6);
    EXPECT_EQ(plant.pins(), pins) << sector;
  }
}

// A Hall that the begin of an arc already lies beyond changes there, and its next edge is still to come.
TEST(Sensors, AnArcThatBeginsBeyondAHallsEdgeSaysSoAtOnce) {
  const Parameters p = steady();
  const Dynamics dynamics(p);
  const auto arc_from = [&](double degrees, double length) {
    const Variables y = {0, 0, 0, kSpeed3000, degrees * kDegree, 24};
    Arc arc;
    arc.plan(dynamics, dynamics.regime(y, {.source_voltage = 24}, 0), y, p.accuracy, length);
    return arc;
  };
  for (int k = 0; k < 3; ++k) {
    for (const double rises : {0.0, 180.0}) {
      const double edge = 30 + 120 * k + rises;
      Sensing sensing = p.sensing;
      sensing.hall_delay = 3e-6;
      Sensors sensors(sensing);
      sensors.start(arc_from(edge - 1, 1e-6));
      EXPECT_EQ(sensors.pins().hall[k], rises > 0);
      sensors.search(arc_from(edge + 1, 1e-6), 1e-6);
      EXPECT_DOUBLE_EQ(sensors.next_change(), 4e-6);
      sensors.reach(4e-6);
      EXPECT_EQ(sensors.pins().hall[k], rises == 0);
    }
  }
}

TEST(Sensors, ACrossingThatTheGatesForestallNeverReachesItsPin) {
  Parameters p = steady();
  p.sensing.limit_threshold = 3;
  p.sensing.limit = {.hysteresis = 0, .delay = 0};
  Plant plant(p, {.angle = 60 * kDegree / 4});
  plant.set_gates({.uh = true, .vl = true});  // would reach 3 A after 48 us
  plant.advance_to(45e-6);
  plant.set_limit_threshold(3.0);  // plans afresh: the crossing is now foreseen
  EXPECT_NEAR(plant.next_event(), 48e-6, 3e-6);
  plant.advance_to(46e-6);
  plant.set_gates({.vl = true});
  while (plant.time() < 200e-6) {
    plant.advance_to(plant.next_event());
    ASSERT_FALSE(plant.pins().limit) << plant.time();
  }
}

TEST(Sensors, HysteresisGivesOneEdgeEachWayHalfItsWidthOnEitherSide) {
  Parameters p = steady();
  p.sensing.comparator[1] = {.offset = 0.2, .hysteresis = 0.1, .delay = 0};
  const auto edges = coast(p, {.angle = 100 * kDegree / 4, .speed = kSpeed3000}, 1.0 / 240);
  std::vector<double> degrees;
  for (std::size_t n = 0; n < edges.size(); ++n) {
    const bool before = n > 0 && edges[n - 1].pins.comparator[1];
    if (edges[n].pins.comparator[1] != before) degrees.push_back(100 + edges[n].time / kPerDegree);
  }
  ASSERT_EQ(degrees.size(), 2u);
  const double emf = 0.03966 * 200;
  EXPECT_NEAR(degrees[0], 120 + std::asin(0.25 / emf) / kDegree, 1e-4);
  EXPECT_NEAR(degrees[1], 300 - std::asin(0.15 / emf) / kDegree, 1e-4);
}

TEST(Sensors, LimitSwitchesWhenTheShuntCurrentReachesItsThreshold) {
  Parameters p = steady();
  p.sensing.limit_threshold = 3;
  p.sensing.limit = {.hysteresis = 0.2, .delay = 200e-9};
  Plant plant(p, {.angle = 60 * kDegree / 4});
  plant.set_gates({.uh = true, .vl = true});
  while (!plant.pins().limit) plant.advance_to(plant.next_event());
  const double r = 2 * (0.382 + 0.01), l = 2 * 188e-6;
  const double expected = -l / r * std::log(1 - 3.1 * r / 24) + 200e-9;
  EXPECT_NEAR(plant.time(), expected, 1e-8);  // the rotor hardly moves, but it does move
  plant.set_gates({.vl = true});              // freewheels above the shunt: reads zero at once
  plant.advance_to(plant.time() + 201e-9);
  EXPECT_FALSE(plant.pins().limit);
}

TEST(Sensors, HalfBusAndStarPointReferencesDoWhatTheySay) {
  for (const auto reference : {Sensing::Reference::kHalfBus, Sensing::Reference::kStarPoint}) {
    Parameters p = steady();
    p.motor.shape.kind = BackEmfShape::Kind::kTrapezoidal;
    p.sensing.reference = reference;
    Plant plant(p, {.angle = 50 * kDegree / 4, .speed = kSpeed3000});
    plant.set_gates({.uh = true, .vl = true});  // on-time: w floats and falls through 60 degrees
    while (plant.pins().comparator[2]) plant.advance_to(plant.next_event());
    EXPECT_NEAR(plant.time() / kPerDegree, 10, 1e-4);
  }
}

}  // namespace
}  // namespace steplock::plant
