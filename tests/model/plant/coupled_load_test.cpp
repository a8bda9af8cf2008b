#include "model/plant/coupled_load.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "model/plant/dynamics.hpp"
#include "model/plant/plant.hpp"
#include "tests/model/plant/six_step.hpp"

namespace steplock::plant {
namespace {

// Nothing but inertia, with open windings.
Parameters bare() {
  Parameters p;
  p.motor.coulomb_friction = p.motor.static_friction = 0;
  p.motor.flux = 0;
  p.motor.inertia = 2e-5;
  return p;
}

// s, from one rise of `value` through zero to the one after next, over two periods.
template <class Value>
double period(Plant& plant, const Value& value) {
  std::vector<double> rises;
  double last = value(plant.state()), before = 0;
  while (rises.size() < 3) {
    before = plant.time();
    plant.advance_to(before + 1e-5);
    const double now = value(plant.state());
    if (last < 0 && now >= 0) rises.push_back(before + 1e-5 * last / (last - now));
    last = now;
  }
  return (rises[2] - rises[0]) / 2;
}

TEST(CoupledLoad, AWeightSwingsAtThePendulumsFrequency) {
  Parameters p = bare();
  p.load.unbalance_torque = 0.05;
  p.load.unbalance_angle = 1;
  constexpr double kAmplitude = 0.1;
  Plant plant(p, {.angle = 1 + kAmplitude});
  const double measured = period(plant, [](const State& s) { return s.angle - 1; });
  // The first term of the amplitude's series; the next one is 1e-6 of the period.
  const double small = kTurn * std::sqrt(p.motor.inertia / p.load.unbalance_torque);
  EXPECT_NEAR(measured / (small * (1 + kAmplitude * kAmplitude / 16)), 1, 2e-6);
  EXPECT_LT(std::abs(plant.state().energy.residual()), 1e-9);
}

TEST(CoupledLoad, TwoMassesOnASpringSwingAtTheirCommonFrequency) {
  Parameters p = bare();
  p.load.inertia = 6e-5;
  p.load.spring_stiffness = 2;
  Plant plant(p, {.speed = 0});
  plant.set_active_torque(-0.1);
  plant.advance_to(5e-4);
  plant.set_active_torque(0);
  const double mean = 0.1 * 5e-4 / (p.motor.inertia + p.load.inertia);
  const double measured = period(plant, [&](const State& s) { return s.speed - mean; });
  const double expected = kTurn / std::sqrt(p.load.spring_stiffness * (1 / p.motor.inertia + 1 / p.load.inertia));
  EXPECT_NEAR(measured / expected, 1, 1e-5);
  // Where both turn alike the spring is wound most, and what it holds is a part of the balance.
  const Energy energy = plant.state().energy;
  EXPECT_GT(energy.spring, 1e-6);
  EXPECT_LT(std::abs(energy.residual()), 1e-9);
}

TEST(CoupledLoad, ASpringsDampingTakesItsShareOfEverySwing) {
  Parameters p = bare();
  p.load.inertia = 6e-5;
  p.load.spring_stiffness = 2;
  p.load.spring_damping = 1e-3;
  Plant plant(p, {.speed = 0});
  plant.set_active_torque(-0.1);
  plant.advance_to(5e-4);
  plant.set_active_torque(0);
  plant.advance_to(1);
  // Both turn alike in the end, with the momentum that they were given.
  EXPECT_NEAR(plant.state().speed, 0.1 * 5e-4 / (p.motor.inertia + p.load.inertia), 1e-6);
  EXPECT_GT(plant.state().energy.friction, 1e-5);
  EXPECT_LT(std::abs(plant.state().energy.residual()), 1e-9);
}

TEST(CoupledLoad, WindTurnsAFanUntilFrictionHoldsTheBalance) {
  for (const double wind : {60.0, -60.0}) {
    Parameters p = bare();
    p.motor.fan_friction = 1e-5;
    p.motor.coulomb_friction = p.motor.static_friction = 9e-3;
    p.load.wind_speed = wind;
    Plant plant(p);
    plant.advance_to(3);
    // F (wind - w)^2 = friction
    EXPECT_NEAR(plant.state().speed, std::copysign(60 - std::sqrt(9e-3 / 1e-5), wind), 1e-4);
    EXPECT_LT(std::abs(plant.state().energy.residual()), 1e-7);
  }
}

TEST(CoupledLoad, WindThatFrictionHoldsTurnsNothing) {
  Parameters p = bare();
  p.motor.fan_friction = 1e-5;
  p.motor.coulomb_friction = p.motor.static_friction = 0.037;  // F wind^2 is 0.036
  p.load.wind_speed = 60;
  Plant plant(p);
  plant.advance_to(1);
  EXPECT_EQ(plant.state().angle, 0);
  EXPECT_TRUE(plant.state().stuck);
}

TEST(CoupledLoad, ALoadThatHasBrokenAwayHoldsNoMore) {
  Parameters p = bare();
  p.motor.coulomb_friction = p.motor.static_friction = 5e-3;
  p.load.breakaway_torque = 0.02;
  Plant plant(p);
  plant.set_active_torque(-0.0249);
  plant.advance_to(0.1);
  EXPECT_TRUE(plant.state().stuck);
  plant.set_active_torque(-0.0251);
  plant.advance_to(0.2);
  EXPECT_FALSE(plant.state().stuck);
  plant.set_active_torque(0);
  plant.advance_to(2);
  EXPECT_TRUE(plant.state().stuck);
  plant.set_active_torque(-0.0051);
  plant.advance_to(2.1);
  EXPECT_FALSE(plant.state().stuck);
}

TEST(CoupledLoad, ACoupledInertiaKeepsTheSpeedAndDividesTheAcceleration) {
  Parameters p = bare();
  Plant plant(p, {.speed = 100});
  plant.advance_to(0.01);
  plant.set_coupled_inertia(3 * p.motor.inertia);
  EXPECT_DOUBLE_EQ(plant.state().speed, 100);
  plant.set_active_torque(0.02);
  plant.advance_to(0.02);
  EXPECT_NEAR(plant.state().speed, 100 - 0.02 * 0.01 / (4 * p.motor.inertia), 1e-9);
  EXPECT_LT(std::abs(plant.state().energy.residual()), 1e-9);
  EXPECT_THROW(plant.set_coupled_inertia(-1), std::invalid_argument);
}

TEST(CoupledLoad, WhatItNeedsIsNamed) {
  Parameters p = bare();
  p.load.wind_speed = 10;
  p.load.spring_stiffness = 1;
  const auto problems = validate(p);
  ASSERT_EQ(problems.size(), 2U);
  EXPECT_NE(problems[0].find("wind turns a fan"), std::string::npos);
  EXPECT_NE(problems[1].find("needs an inertia behind it"), std::string::npos);
}

double between(double low, double high) { return low + (high - low) * *rc::gen::inRange(0, 1000001) * 1e-6; }

// Power from the source = heat + load + rate of stored energy, whatever the load does.  What is stored is
// differentiated here, by hand, along the slope under test.
RC_GTEST_PROP(CoupledLoad, PowerBalancesAtEveryState, ()) {
  Parameters p;
  p.motor.fan_friction = 1e-7;
  p.load.inertia = 3e-6;
  p.load.unbalance_torque = *rc::gen::element(0.0, 0.03);
  p.load.unbalance_angle = 0.7;
  p.load.wind_speed = *rc::gen::element(0.0, 80.0, -200.0);
  p.load.spring_stiffness = *rc::gen::element(0.0, 0.5);
  p.load.spring_damping = 1e-5;
  const Dynamics dynamics(p);
  Inputs in;
  in.gates = {.uh = true, .vl = true};
  in.source_voltage = 24;
  const double iu = between(-20, 20), iv = between(-20, 20);
  const Variables y = {iu, iv, -iu - iv, between(-900, 900), between(-7, 7), 24, between(-900, 900), between(-1, 1)};
  Variables slope;
  Powers power;
  dynamics.derivative(dynamics.regime(y, in, 3), y, slope, power);
  const bool spring = p.load.spring_stiffness > 0;
  const double angle = y[kAngle] / 4 + 3 * kTurn / 4;
  const double inertia = p.motor.inertia + (spring ? 0 : p.load.inertia);
  double stored = (p.motor.inductance - p.motor.mutual) * (y[0] * slope[0] + y[1] * slope[1] + y[2] * slope[2]) +
                  inertia * y[kSpeed] * slope[kSpeed] + p.bus.capacitance * y[kBus] * slope[kBus] +
                  p.load.unbalance_torque * std::sin(angle - 0.7) * y[kSpeed];
  if (spring) {
    stored += p.load.inertia * y[kLoadSpeed] * slope[kLoadSpeed] + p.load.spring_stiffness * y[kTwist] * slope[kTwist];
  }
  const double spent = power[kCopper] + power[kBridge] + power[kBusResistance] + power[kFriction] + power[kLoad];
  RC_ASSERT(std::abs(power[kSupplied] - spent - stored) < 1e-5);
  RC_ASSERT(power[kFriction] >= 0);
}

}  // namespace
}  // namespace steplock::plant
