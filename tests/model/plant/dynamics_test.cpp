#include "model/plant/dynamics.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace steplock::plant {
namespace {

Parameters full_parameters() {
  Parameters p;
  p.motor.mutual = -30e-6;
  p.motor.cogging_torque = 5e-3;
  p.motor.cogging_phase = 0.4;
  p.motor.viscous_friction = 1e-5;
  p.motor.fan_friction = 1e-7;
  p.load.inertia = 3e-6;
  return p;
}

double between(double low, double high) {
  return low + (high - low) * *rc::gen::inRange(0, 1000001) * 1e-6;
}

// Power from the source = heat + load + rate of stored energy, at any state and for any gates.
// The stored energies are differentiated here, by hand, along the slope under test.
RC_GTEST_PROP(Dynamics, PowerBalancesAtEveryState, ()) {
  Parameters p = full_parameters();
  const auto kinds = *rc::gen::inRange(0, 2);
  if (kinds == 1) p.motor.shape.kind = BackEmfShape::Kind::kSinusoidal;
  const Dynamics dynamics(p);

  const auto bits = *rc::gen::inRange(0, 64);
  Inputs in;
  in.gates = {bool(bits & 1), bool(bits & 2),  bool(bits & 4),
              bool(bits & 8), bool(bits & 16), bool(bits & 32)};
  in.opposing_torque = between(0, 0.05);
  in.active_torque = between(-0.05, 0.05);
  in.source_voltage = between(10, 30);
  const double iu = between(-20, 20), iv = between(-20, 20);
  const Variables y = {iu, iv, -iu - iv, between(-900, 900), between(-7, 7), between(8, 30)};

  const Regime regime = dynamics.regime(y, in, 3);
  Variables slope;
  Powers power;
  dynamics.derivative(regime, y, slope, power);
  const double inductance = p.motor.inductance - p.motor.mutual;
  const double inertia = p.motor.inertia + p.load.inertia;
  const double mechanical = y[kAngle] / 4 + 3 * kTurn / 4;
  const double cogging_rate =
      p.motor.cogging_torque * std::sin(p.motor.cogging_periods * mechanical + 0.4) * y[kSpeed];
  const double stored_rate = inductance * (y[0] * slope[0] + y[1] * slope[1] + y[2] * slope[2]) +
                             inertia * y[kSpeed] * slope[kSpeed] +
                             p.bus.capacitance * y[kBus] * slope[kBus] + cogging_rate;
  const double spent =
      power[kCopper] + power[kBridge] + power[kBusResistance] + power[kFriction] + power[kLoad];
  // Terms reach 1e5 W; 1e-10 of that is a few hundred roundings.
  RC_ASSERT(std::abs(power[kSupplied] - spent - stored_rate) < 1e-5);
  RC_ASSERT(std::abs(slope[0] + slope[1] + slope[2]) < 1e-6);
  for (Power heat : {kCopper, kBridge, kBusResistance, kFriction}) RC_ASSERT(power[heat] >= 0);
}

TEST(Dynamics, FrictionHoldsTheRotorUpToItsBreakawayTorque) {
  Parameters p;
  p.motor.static_friction = 3e-3;
  const Dynamics dynamics(p);
  Inputs in;
  in.opposing_torque = 1e-3;
  in.source_voltage = 24;
  for (double active : {-3.9e-3, 0.0, 3.9e-3}) {
    in.active_torque = active;
    EXPECT_EQ(dynamics.regime({0, 0, 0, 0, 0, 24}, in, 0).turning, 0) << active;
  }
  for (double active : {-4.1e-3, 4.1e-3}) {
    in.active_torque = active;
    const Regime regime = dynamics.regime({0, 0, 0, 0, 0, 24}, in, 0);
    EXPECT_EQ(regime.turning, 1);
    EXPECT_EQ(regime.direction, active > 0 ? -1 : 1);
  }
}

TEST(Dynamics, TorqueOfAFlatTopIsTwiceTheTorqueConstant) {
  const Parameters p;
  const Dynamics dynamics(p);
  Inputs in;
  in.gates = {.uh = true, .vl = true};
  in.source_voltage = 24;
  const Variables y = {2, -2, 0, 10, 60 * kTurn / 360, 24};
  const auto out = dynamics.outputs(dynamics.regime(y, in, 0), y);
  EXPECT_NEAR(out.torque, 2 * p.motor.flux * p.motor.pole_pairs * 2, 1e-12);
}

TEST(Dynamics, ABlockingSourceGivesNoCurrentAboveItsVoltage) {
  Parameters p;
  p.bus.sinks = false;
  const Dynamics dynamics(p);
  Inputs in;
  in.source_voltage = 24;
  const Variables high = {0, 0, 0, 0, 0, 25}, low = {0, 0, 0, 0, 0, 23};
  EXPECT_EQ(dynamics.outputs(dynamics.regime(high, in, 0), high).source_current, 0);
  EXPECT_DOUBLE_EQ(dynamics.outputs(dynamics.regime(low, in, 0), low).source_current, 20);
}

// The salient path of a motor that is round shows what the round path does, at any state and for any gates.
RC_GTEST_PROP(Dynamics, BothWindingsShowTheSameWhereTheyAreTheSame, ()) {
  Parameters round = full_parameters();
  round.motor.mutual = 0;
  round.motor.shape.kind = BackEmfShape::Kind::kSinusoidal;
  Parameters salient = round;
  salient.motor.inductance_d = salient.motor.inductance_q = round.motor.inductance;
  const Dynamics a(round), b(salient);
  const auto bits = *rc::gen::inRange(0, 64);
  Inputs in;
  in.gates = {bool(bits & 1), bool(bits & 2), bool(bits & 4), bool(bits & 8), bool(bits & 16), bool(bits & 32)};
  in.active_torque = between(-0.05, 0.05);
  in.source_voltage = between(10, 30);
  const double iu = between(-20, 20), iv = between(-20, 20);
  const Variables y = {iu, iv, -iu - iv, between(-900, 900), between(-7, 7), between(8, 30)};
  const Outputs x = a.outputs(a.regime(y, in, 0), y), z = b.outputs(b.regime(y, in, 0), y);
  // Volts and amperes up to a hundred, by another order of sums.
  for (int k = 0; k < 3; ++k) {
    RC_ASSERT(std::abs(x.shape[k] - z.shape[k]) < 1e-12);
    RC_ASSERT(std::abs(x.emf[k] - z.emf[k]) < 1e-10);
    RC_ASSERT(std::abs(x.terminals.voltage[k] - z.terminals.voltage[k]) < 1e-10);
  }
  RC_ASSERT(std::abs(x.terminals.neutral - z.terminals.neutral) < 1e-10);
  RC_ASSERT(std::abs(x.torque - z.torque) < 1e-10);
  RC_ASSERT(std::abs(x.pull - z.pull) < 1e-10);
  RC_ASSERT(std::abs(x.bridge_current - z.bridge_current) < 1e-10);
  RC_ASSERT(std::abs(x.source_current - z.source_current) < 1e-10);
}

// What the error of a step is judged by: a hundredth of the motor's current at rest and of its speed without load at this bus.
TEST(Dynamics, ErrorsAreScaledByWhatTheMotorCouldReach) {
  Parameters p;
  p.bus.voltage = 36;
  const Variables scale = Dynamics(p).scale();
  for (const Variable phase : {kIu, kIv, kIw}) EXPECT_DOUBLE_EQ(scale[phase], 0.36 / p.motor.resistance);
  for (const Variable speed : {kSpeed, kLoadSpeed}) EXPECT_DOUBLE_EQ(scale[speed], 0.36 / (p.motor.flux * p.motor.pole_pairs));
  EXPECT_EQ(scale[kBus], 36);
  p.motor.flux = 0;
  EXPECT_EQ(Dynamics(p).scale()[kSpeed], 1) << "iron without a magnet has no such speed";
}

// On a corner of the back-EMF a rotor that stood goes into the piece that its torque pulls it to.
TEST(Dynamics, ARotorLeavesRestIntoThePieceOnItsWay) {
  const Parameters p;
  const Dynamics dynamics(p);
  const BackEmf back_emf(p.motor.shape);
  Inputs in;
  in.source_voltage = 24;
  for (const double pushed : {0.5, -0.5}) {  // an active torque slows what turns forward
    in.active_torque = pushed;
    const double way = pushed > 0 ? -1 : 1;
    for (int corner = 0; corner < 6; ++corner) {
      const double angle = (corner * 60 + 30) * kTurn / 360;
      const Regime regime = dynamics.regime({0, 0, 0, 0, angle, 24}, in, 0);
      ASSERT_NE(back_emf.piece(angle, 1).low, back_emf.piece(angle, -1).low) << corner;
      EXPECT_EQ(regime.direction, way);
      EXPECT_EQ(regime.piece.low, back_emf.piece(angle, way).low) << corner;
      EXPECT_EQ(regime.piece.high, back_emf.piece(angle, way).high) << corner;
    }
  }
}

}  // namespace
}  // namespace steplock::plant
