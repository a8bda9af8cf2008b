#include "model/plant/sensors.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "tests/model/plant/six_step.hpp"

namespace steplock::plant {
namespace {

constexpr double kSpeed3000 = 2 * std::numbers::pi * 50;  // 200 electrical turns per second
constexpr double kPerDegree = 1 / (200 * 360.0);          // s

Parameters steady() {
  Parameters p;
  p.load.inertia = 1;
  p.bus.resistance = 0;
  for (auto& c : p.sensing.comparator) c = {.hysteresis = 0, .delay = 0};
  p.motor.shape.kind = BackEmfShape::Kind::kSinusoidal;
  return p;
}

struct Edge {
  double time;
  Pins pins;
};

// All pin changes of a coasting rotor.
std::vector<Edge> coast(const Parameters& p, const InitialState& initial, double until) {
  Plant plant(p, initial);
  std::vector<Edge> edges;
  Pins last = plant.pins();
  while (plant.next_event() < until) {
    plant.advance_to(plant.next_event());
    if (!(plant.pins() == last)) edges.push_back({plant.time(), last = plant.pins()});
  }
  return edges;
}

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

TEST(Sensors, GaussianHasItsMomentsAndIsAFunctionOfItsArguments) {
  const int n = 200000;
  double sum = 0, square = 0, fourth = 0, product = 0, last = 0;
  for (int k = 0; k < n; ++k) {
    const double x = Sensors::gaussian(1, 0, k);
    sum += x;
    square += x * x;
    fourth += x * x * x * x;
    product += x * last;
    last = x;
  }
  // Five standard errors of each estimate.
  EXPECT_NEAR(sum / n, 0, 5 / std::sqrt(n));
  EXPECT_NEAR(square / n, 1, 5 * std::sqrt(2.0 / n));
  EXPECT_NEAR(fourth / n, 3, 5 * std::sqrt(96.0 / n));
  EXPECT_NEAR(product / n, 0, 5 / std::sqrt(n));
  EXPECT_NE(Sensors::gaussian(1, 0, 7), Sensors::gaussian(2, 0, 7));
  EXPECT_NE(Sensors::gaussian(1, 0, 7), Sensors::gaussian(1, 1, 7));
  EXPECT_EQ(Sensors::gaussian(1, 2, -7), Sensors::gaussian(1, 2, -7));
}

TEST(Sensors, NoiseMakesTheOutputChatterAroundTheCrossingOnly) {
  Parameters p = steady();
  for (auto& c : p.sensing.comparator) c = {.hysteresis = 0.01, .delay = 0, .noise = 0.03};
  const auto edges = coast(p, {.angle = 40 * kDegree / 4, .speed = kSpeed3000 / 10}, 5e-3);
  const double emf_per_degree = 0.03966 * 20 * kDegree;
  int chatter = 0;
  for (const Edge& edge : edges) {
    const double degree = 40 + edge.time * 200 * 36;
    const double away = std::min(std::abs(std::remainder(degree, 60)),
                                 std::abs(std::remainder(degree - 30, 60)));  // a Hall's
    EXPECT_LT(away * emf_per_degree, 6.7 * 0.03 + 0.01) << degree;
    chatter += degree > 45 && degree < 75;
  }
  EXPECT_GT(chatter, 5);
}

TEST(Sensors, HysteresisWiderThanTheNoiseGivesOneCleanEdge) {
  Parameters p = steady();
  p.sensing.comparator[2] = {.hysteresis = 0.2, .delay = 0, .noise = 0.01};  // 20 sigma
  const auto edges = coast(p, {.angle = 40 * kDegree / 4, .speed = kSpeed3000 / 10}, 5e-3);
  int changes = 0;  // w falls through 60 degrees; the run ends at 76
  for (std::size_t n = 0; n < edges.size(); ++n) {
    changes += edges[n].pins.comparator[2] != (n == 0 || edges[n - 1].pins.comparator[2]);
  }
  EXPECT_EQ(changes, 1);
}

TEST(Sensors, NoiseDoesNotDependOnHowTheRunIsCut) {
  Parameters p = steady();
  p.accuracy.tolerance = 1e-10;
  for (auto& c : p.sensing.comparator) c = {.hysteresis = 0.01, .delay = 0, .noise = 0.03};
  const auto whole = coast(p, {.angle = 40 * kDegree / 4, .speed = kSpeed3000 / 10}, 5e-3);
  p.accuracy.max_step = 7.3e-6;
  const auto cut = coast(p, {.angle = 40 * kDegree / 4, .speed = kSpeed3000 / 10}, 5e-3);
  ASSERT_EQ(whole.size(), cut.size());
  for (std::size_t n = 0; n < cut.size(); ++n) {
    EXPECT_NEAR(whole[n].time, cut[n].time, 1e-9);
    EXPECT_EQ(whole[n].pins, cut[n].pins);
  }
}

}  // namespace
}  // namespace steplock::plant
