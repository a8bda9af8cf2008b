// A winding that loses its contact: when it opens, what then flows, and that no energy is lost.
#include <gtest/gtest.h>

#include "tests/model/plant/six_step.hpp"

namespace steplock::plant {
namespace {

constexpr Gates kUToV = {.uh = true, .vl = true};

TEST(OpenWinding, OpensAtTheNextZeroOfItsCurrentAndCarriesNoneAfterwards) {
  Plant plant({});
  plant.set_gates(kUToV);
  plant.advance_to(200e-6);
  ASSERT_GT(plant.state().current[0], 1);
  plant.set_open(0, true);
  plant.advance_to(210e-6);
  EXPECT_GT(plant.state().current[0], 1) << "the contact arcs";
  plant.set_gates({});
  while (plant.state().current[0] > 0) plant.advance_to(plant.next_event());
  EXPECT_EQ(plant.state().current[0], 0);
  plant.set_gates(kUToV);
  plant.advance_to(plant.time() + 1e-3);
  EXPECT_EQ(plant.state().current[0], 0);
  EXPECT_EQ(plant.state().current[1], 0);
  EXPECT_TRUE(plant.state().floating[0]);
}

// With both switches of a chopped leg in turn the current passes zero under a switch, where no diode
// stops it.
TEST(OpenWinding, OpensWhereASwitchedCurrentPassesZero) {
  Parameters p;
  p.motor.flux = 0;
  Plant plant(p);
  plant.set_gates(kUToV);
  plant.advance_to(50e-6);
  plant.set_open(0, true);
  plant.set_gates({.ul = true, .vh = true});
  plant.advance_to(300e-6);
  EXPECT_EQ(plant.state().current[0], 0);
  EXPECT_EQ(plant.state().current[1], 0);
  plant.set_open(0, false);
  plant.advance_to(400e-6);
  EXPECT_LT(plant.state().current[0], -1) << "closed again";
}

TEST(OpenWinding, LeavesTheOtherTwoAsOneLoopWithTheStarPointBetweenThem) {
  Plant plant({}, {.angle = 0.05, .speed = 100});
  plant.set_open(2, true);
  plant.set_gates(kUToV);
  plant.advance_to(100e-6);
  const State s = plant.state();
  EXPECT_EQ(s.current[2], 0);
  EXPECT_DOUBLE_EQ(s.current[0], -s.current[1]);
  EXPECT_NEAR(s.neutral, (s.voltage[0] - s.emf[0] + s.voltage[1] - s.emf[1]) / 2, 1e-9);
  EXPECT_EQ(s.voltage[2], 0) << "the comparator's divider holds the open terminal at ground";
  plant.set_gates({.uh = true, .vl = true, .wh = true});
  EXPECT_EQ(plant.state().voltage[2], plant.state().bus_voltage) << "its switch moves the terminal alone";
  EXPECT_EQ(plant.state().current[2], 0);
}

TEST(OpenWinding, OfACoastingMotorMovesNoTerminalOfTheOthersBelowADiodeDrop) {
  Plant plant({}, {.angle = 0.1, .speed = 300});
  plant.set_open(0, true);
  for (int k = 0; k < 400; ++k) {
    plant.advance_to(plant.time() + 50e-6);
    const State s = plant.state();
    EXPECT_EQ(s.voltage[0], 0);
    EXPECT_GE(std::min(s.voltage[1], s.voltage[2]), -0.55 - 1e-9);
  }
}

// The energy law through opening under load, running on two windings, and closing again.
TEST(OpenWinding, KeepsTheEnergyLaw) {
  Plant plant({}, {.angle = 0.2});
  double worst = 0;
  const auto observe = [&](const Plant& at) {
    worst = std::max(worst, std::abs(at.state().energy.residual()));
  };
  SixStep drive(30e3, 0.5);
  drive.run(plant, 0.05, observe);
  plant.set_open(1, true);
  drive.run(plant, 0.07, observe);
  EXPECT_EQ(plant.state().current[1], 0);
  plant.set_open(1, false);
  drive.run(plant, 0.09, observe);
  EXPECT_GT(plant.state().energy.copper, 0.1);
  // The tolerance per step, over what was turned over (docs/plant.md, "Measured").
  EXPECT_LT(worst, 1e-6 * plant.state().energy.supplied);
}

TEST(OpenWinding, HasOnlyThreeOfThem) {
  Plant plant({});
  EXPECT_THROW(plant.set_open(3, true), std::invalid_argument);
  EXPECT_THROW(plant.set_open(-1, true), std::invalid_argument);
}

}  // namespace
}  // namespace steplock::plant
