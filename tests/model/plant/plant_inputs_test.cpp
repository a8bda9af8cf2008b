// What the plant is told: its state at the start, and what is set while it runs.
#include <gtest/gtest.h>

#include <stdexcept>

#include "model/plant/plant.hpp"
#include "tests/model/plant/six_step.hpp"

namespace steplock::plant {
namespace {

TEST(PlantInputs, LoadsOfTheParametersAreThoseThatCouldBeSet) {
  Parameters given;
  given.load.opposing_torque = 0.02;
  given.load.active_torque = 0.03;
  Plant a(given, {.speed = 100}), b(Parameters{}, {.speed = 100});
  b.set_load_torque(0.02);
  b.set_active_torque(0.03);
  a.advance_to(1e-3);
  b.advance_to(1e-3);
  EXPECT_EQ(a.state().speed, b.state().speed);
  // Both against the motion, with the dry friction: 51 N mm on 7.06e-6 kg m^2.
  EXPECT_NEAR(a.state().speed, 100 - 1e-3 * 0.051 / 7.06e-6, 1e-4);
}

// 1e-9 of 1 A and of what flows in u and v.
TEST(PlantInputs, CurrentsSumToZeroWithinRounding) {
  const auto starts = [](double u, double v, double excess) {
    try {
      Plant(Parameters{}, {.current = {u, v, -u - v + excess}});
      return true;
    } catch (const std::invalid_argument&) {
      return false;
    }
  };
  EXPECT_TRUE(starts(0, 0, 1e-9));
  EXPECT_FALSE(starts(0, 0, 1.01e-9));
  for (const double sign : {1.0, -1.0}) {
    EXPECT_TRUE(starts(sign * 1000, 0, 1.00e-6));
    EXPECT_FALSE(starts(sign * 1000, 0, 1.01e-6));
    EXPECT_TRUE(starts(0, sign * 1000, 1.00e-6));
    EXPECT_FALSE(starts(0, sign * 1000, -1.01e-6));
    EXPECT_TRUE(starts(1000, sign * 1000, 2.00e-6));
    EXPECT_FALSE(starts(1000, sign * 1000, -2.01e-6));
  }
}

TEST(PlantInputs, ABusBeginsAsToldUnlessItIsStiff) {
  Parameters p;
  for (const double volts : {0.0, 0.5, 20.0}) EXPECT_EQ(Plant(p, {.bus_voltage = volts}).state().bus_voltage, volts);
  EXPECT_EQ(Plant(p).state().bus_voltage, 24);
  p.bus.resistance = 0;
  EXPECT_EQ(Plant(p, {.bus_voltage = 20}).state().bus_voltage, 24);
}

TEST(PlantInputs, AStiffBusFollowsItsSourceAtOnceAndAnotherInItsTime) {
  Parameters p;
  for (const double resistance : {0.0, 0.05, 1.0}) {
    p.bus.resistance = resistance;
    Plant plant(p);
    plant.set_bus_voltage(30);
    EXPECT_EQ(plant.state().bus_voltage, resistance == 0 ? 30 : 24);
    plant.advance_to(1e-4);
    const double left = resistance == 0 ? 0 : 6 * std::exp(-1e-4 / (resistance * 470e-6));
    EXPECT_NEAR(plant.state().bus_voltage, 30 - left, 1e-6);
  }
}

TEST(PlantInputs, BothGatesOfALegAreCountedOncePerOccasion) {
  Plant plant{Parameters{}};
  const Gates alone[] = {{.uh = true}, {.ul = true}, {.vh = true}, {.vl = true}, {.wh = true}, {.wl = true}};
  for (const Gates& one : alone) plant.set_gates(one);
  EXPECT_EQ(plant.shoot_throughs(), 0u);
  plant.set_gates({.uh = true, .ul = true, .vl = true});
  plant.set_gates({.uh = true, .ul = true, .wl = true});  // still the same occasion
  EXPECT_EQ(plant.shoot_throughs(), 1u);
  plant.advance_to(1e-6);
  EXPECT_NEAR(plant.state().voltage[0], 12, 0.05);
  plant.set_gates({});
  plant.set_gates({.uh = true, .ul = true, .vh = true, .vl = true});
  EXPECT_EQ(plant.shoot_throughs(), 3u);
}

TEST(PlantInputs, SmallValuesAreValuesToo) {
  Plant plant(Parameters{}, {.bus_voltage = 0.5});
  plant.set_bus_voltage(0.5);
  plant.advance_to(1e-4);
  EXPECT_DOUBLE_EQ(plant.state().bus_voltage, 0.5);
  plant.set_bus_voltage(24);
  plant.set_limit_threshold(0.5);
  plant.set_gates({.uh = true, .vl = true});
  while (!plant.pins().limit) plant.advance_to(plant.next_event());
  EXPECT_LT(plant.state().current[0], 1);
  EXPECT_EQ(plant.state().time, plant.time());
}

// A mass that is coupled brings its energy with it, and takes it away again: none is made.
TEST(PlantInputs, EnergyBalancesWhateverIsCoupled) {
  Plant plant(Parameters{}, {.speed = 100});
  double time = 0;
  for (const double inertia : {1e-5, 3e-5, 3e-5, 1e-5, 0.0, 0.0, 2e-5}) {
    plant.set_coupled_inertia(inertia);
    plant.advance_to(time += 1e-3);
    const State s = plant.state();
    EXPECT_DOUBLE_EQ(s.energy.kinetic, 0.5 * (7.06e-6 + inertia) * s.speed * s.speed);
    EXPECT_NEAR(s.energy.residual(), 0, 1e-8);  // some ten steps of 1e-8 of the 0.2 J
  }
  EXPECT_THROW(plant.set_coupled_inertia(-1e-9), std::invalid_argument);
  EXPECT_THROW(plant.set_open(3, true), std::invalid_argument);
  EXPECT_THROW(plant.set_open(-1, true), std::invalid_argument);
}

TEST(PlantInputs, InputsOutsideTheirRangeAreRefused) {
  Plant plant{Parameters{}};
  plant.advance_to(1e-3);
  EXPECT_THROW(plant.advance_to(0.9e-3), std::invalid_argument);
  EXPECT_THROW(plant.set_load_torque(-1), std::invalid_argument);
  EXPECT_THROW(plant.set_bus_voltage(0), std::invalid_argument);
  EXPECT_THROW(plant.set_limit_threshold(0), std::invalid_argument);
  EXPECT_THROW(plant.set_active_torque(std::nan("")), std::invalid_argument);
}

}  // namespace
}  // namespace steplock::plant
