#include <gtest/gtest.h>

#include "tests/model/plant/six_step.hpp"

namespace steplock::plant {
namespace {

// The law: what the source gave = heat + work on the load + rise of what is stored, after every
// event of a run through start, load step, regeneration, coast and brake.
double worst_residual(const Parameters& p, double& supplied) {
  Plant plant(p, {.angle = 0.2});
  double worst = 0;
  const auto observe = [&](const Plant& at) {
    worst = std::max(worst, std::abs(at.state().energy.residual()));
  };
  SixStep drive(30e3, 0.5);
  drive.run(plant, 0.05, observe);
  plant.set_load_torque(0.03);
  drive.run(plant, 0.07, observe);
  plant.set_active_torque(-0.2);  // a falling weight drives it
  drive.run(plant, 0.09, observe);
  plant.set_load_torque(0);
  plant.set_active_torque(0);
  const auto hold = [&](const Gates& gates, double until) {
    plant.set_gates(gates);
    while (plant.time() < until) {
      plant.advance_to(std::min(until, plant.next_event()));
      observe(plant);
    }
  };
  hold({}, 0.10);
  hold({.ul = true, .vl = true, .wl = true}, 0.12);
  supplied = plant.state().energy.copper + plant.state().energy.kinetic;
  return worst;
}

Parameters everything() {
  Parameters p;
  p.motor.mutual = -20e-6;
  p.motor.cogging_torque = 2e-3;
  p.motor.static_friction = 2e-3;
  p.motor.viscous_friction = 1e-6;
  p.motor.fan_friction = 1e-8;
  p.load.inertia = 5e-6;
  p.bus.sinks = false;
  return p;
}

TEST(Energy, BalancesAfterEveryEventToTheToleranceForEachShape) {
  for (const auto kind : {BackEmfShape::Kind::kTrapezoidal, BackEmfShape::Kind::kSinusoidal,
                          BackEmfShape::Kind::kTable}) {
    Parameters p = everything();
    p.motor.shape.kind = kind;
    for (int n = 0; n < 36; ++n) {  // used by kTable alone
      const double angle = n * 10 * kDegree;
      p.motor.shape.table.push_back(1.1 * std::sin(angle) + 0.1 * std::sin(3 * angle));
    }
    double turned_over = 0;
    const double worst = worst_residual(p, turned_over);
    EXPECT_GT(turned_over, 0.1);
    // Some 40000 steps of 1e-8 of the 0.14 J in the capacitor, of either sign.
    EXPECT_LT(worst, 2e-6);
  }
}

TEST(Energy, ResidualFallsWithTheTolerance) {
  double worst[2], turned_over;
  for (int n = 0; n < 2; ++n) {
    Parameters p = everything();
    p.accuracy.tolerance = n == 0 ? 1e-6 : 1e-9;
    worst[n] = worst_residual(p, turned_over);
  }
  EXPECT_LT(worst[1], worst[0] / 30);
}

TEST(Energy, AStiffBusBalancesToo) {
  Parameters p = everything();
  p.bus = {.voltage = 24, .resistance = 0, .capacitance = 0};
  double turned_over;
  EXPECT_LT(worst_residual(p, turned_over), 2e-6);
}

}  // namespace
}  // namespace steplock::plant
