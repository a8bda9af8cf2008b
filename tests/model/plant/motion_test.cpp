// What a motor does that can be worked out on paper.
#include <gtest/gtest.h>

#include "tests/model/plant/six_step.hpp"

namespace steplock::plant {
namespace {

Parameters frictionless() {
  Parameters p;
  p.motor.coulomb_friction = p.motor.static_friction = 0;
  p.bus.resistance = 0;
  return p;
}

TEST(Motion, CurrentOfALockedRotorRisesExponentially) {
  Parameters p = frictionless();
  p.motor.static_friction = p.motor.coulomb_friction = 10;
  p.motor.mutual = -50e-6;
  Plant plant(p);
  plant.set_gates({.uh = true, .vl = true});
  const double r = 2 * (0.382 + 0.01), l = 2 * (188e-6 + 50e-6);
  for (double t = 50e-6; t < 3e-3; t *= 2) {
    plant.advance_to(t);
    const double expected = 24 / r * (1 - std::exp(-t * r / l));
    EXPECT_NEAR(plant.state().current[0], expected,
                1e-7 * 24 / r);  // 1e-8 per step, in units of V/R
    EXPECT_TRUE(plant.state().stuck);
  }
}

TEST(Motion, NoLoadSpeedIsWhereTwoFlatTopsMeetTheBus) {
  const Parameters p = frictionless();
  Plant plant(p, {.angle = 0.2});
  SixStep drive(20e3, 1.0);
  drive.run(plant, 1.0);
  const double expected = 24 / (2 * p.motor.flux * 4);
  // Commutation leaves a ripple of torque about zero, and it costs a little speed.
  EXPECT_NEAR(plant.state().speed, expected, 0.005 * expected);
}

TEST(Motion, SpeedUnderLoadFallsByTheVoltageOverTheResistances) {
  Parameters p = frictionless();
  p.motor.inductance = 5e-6;  // so that commutation takes no time worth mentioning
  p.load.inertia = 1e-4;
  Plant plant(p, {.angle = 0.2});
  const double torque = 0.1;
  plant.set_load_torque(torque);
  SixStep drive(20e3, 1.0);
  drive.run(plant, 1.0);
  const double k = 2 * p.motor.flux * 4, r = 2 * (0.382 + 0.01);
  const double expected = (24 - torque / k * r) / k;
  EXPECT_NEAR(plant.state().speed, expected, 0.01 * expected);
}

TEST(Motion, ShortedTerminalsBrakeWithTheSteadyCurrentOfTheWinding) {
  Parameters p = frictionless();
  p.motor.shape.kind = BackEmfShape::Kind::kSinusoidal;
  p.load.inertia = 10;
  p.bridge.on_resistance = 0;
  const double speed = 2 * std::numbers::pi * 50, electrical = 4 * speed;
  Plant plant(p, {.speed = speed});
  plant.set_gates({.ul = true, .vl = true, .wl = true});
  plant.advance_to(20e-3);  // 40 time constants
  const double x = electrical * 188e-6, z2 = 0.382 * 0.382 + x * x;
  const double emf = electrical * p.motor.flux;
  const State s = plant.state();
  const double expected = 1.5 * emf * emf * 0.382 / z2 / speed;  // copper loss over speed
  EXPECT_NEAR(s.torque, -expected, 1e-4 * expected);             // the rotor has slowed by 3e-5
  const double square =
      s.current[0] * s.current[0] + s.current[1] * s.current[1] + s.current[2] * s.current[2];
  EXPECT_NEAR(square, 1.5 * emf * emf / z2, 2e-4 * square);
  EXPECT_NEAR(s.shunt_current, 0, 1e-12);
}

TEST(Motion, ACoastingRotorStopsWhenFrictionHasTakenItsEnergyAndStays) {
  Parameters p;
  p.motor.coulomb_friction = 1e-3;
  p.motor.static_friction = 2e-3;
  const double speed = 50;
  Plant plant(p, {.speed = speed});
  const double stop = speed * p.motor.inertia / 1e-3;
  plant.advance_to(stop * (1 - 1e-6));
  EXPECT_FALSE(plant.state().stuck);
  plant.advance_to(stop * (1 + 1e-6));
  EXPECT_TRUE(plant.state().stuck);
  EXPECT_EQ(plant.state().speed, 0);
  EXPECT_NEAR(plant.state().angle, speed * stop / 2, 1e-6);
  const auto steps = plant.steps();
  plant.advance_to(stop + 1);
  EXPECT_EQ(plant.state().speed, 0);
  EXPECT_LT(plant.steps() - steps, 1.1 / p.accuracy.max_step);  // it does not chatter
}

TEST(Motion, StictionHoldsBelowTheBreakawayTorqueAndReleasesAbove) {
  Parameters p;
  p.motor.coulomb_friction = 1e-3;
  p.motor.static_friction = 3e-3;
  Plant plant(p);
  plant.set_active_torque(-2.9e-3);
  plant.advance_to(0.1);
  EXPECT_EQ(plant.state().angle, 0);
  plant.set_active_torque(-3.1e-3);
  plant.advance_to(0.101);
  EXPECT_NEAR(plant.state().speed, 2.1e-3 / p.motor.inertia * 1e-3, 1e-9);
}

TEST(Motion, AnOpposingLoadBrakesButNeverDrives) {
  Plant plant(Parameters{}, {.speed = -30});
  plant.set_load_torque(0.01);
  plant.advance_to(1);
  EXPECT_EQ(plant.state().speed, 0);
  EXPECT_GT(plant.state().energy.load, 0);
}

TEST(Motion, ACoggingRotorSettlesInADetent) {
  Parameters p;
  p.motor.cogging_torque = 10e-3;
  p.motor.cogging_periods = 24;
  Plant plant(p, {.angle = 0.1 * kTurn / 24});
  plant.advance_to(0.5);
  const State s = plant.state();
  EXPECT_TRUE(s.stuck);
  // Where friction can hold it: within asin(1/10) of the detent.
  EXPECT_LE(std::abs(s.angle) * 24, std::asin(0.1) + 1e-9);
}

TEST(Motion, TwoHighOneLowAlignsTheRotor) {
  Parameters p;
  p.motor.shape.kind = BackEmfShape::Kind::kSinusoidal;
  p.motor.viscous_friction = 1e-4;
  p.motor.coulomb_friction = p.motor.static_friction = 1e-5;
  p.bus.voltage = 1;
  Plant plant(p, {.angle = 1.0});
  plant.set_gates({.uh = true, .vh = true, .wl = true});
  plant.advance_to(2);
  // Torque is zero and restoring where the BEMF of w is crossing: theta_e = 240 - 180 = 60 degrees
  // is the unstable one, 240 the stable one (w carries negative current).
  const double degrees = std::remainder(plant.state().electrical_angle / kDegree - 240, 360);
  EXPECT_NEAR(degrees, 0, 0.5);
}

}  // namespace
}  // namespace steplock::plant
