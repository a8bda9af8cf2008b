#include "model/plant/salient.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "model/plant/dynamics.hpp"
#include "tests/model/plant/six_step.hpp"

namespace steplock::plant {
namespace {

// The 2.2 kW class of motor of docs/plant.md, with iron that saturates.
Parameters salient_motor(double saturation = 0.3) {
  Parameters p;
  p.motor = {.resistance = 3.6, .inductance = 43e-3, .inductance_d = 36e-3, .inductance_q = 51e-3,
             .saturation = saturation, .saturation_current = 6, .flux = 0.545, .pole_pairs = 3,
             .shape = {.kind = BackEmfShape::Kind::kSinusoidal}, .inertia = 0.015,
             .coulomb_friction = 0.1, .static_friction = 0.2};
  p.bus = {.voltage = 540, .resistance = 0.1, .capacitance = 1e-3};
  p.bridge = {.on_resistance = 0.05, .diode_drop = 1.2, .diode_resistance = 0.02};
  return p;
}

double between(double low, double high) {
  return low + (high - low) * *rc::gen::inRange(0, 1000001) * 1e-6;
}

// Power from the source = heat + load + rate of stored energy, at any state and for any gates; the
// stored energy is differentiated numerically along the slope under test.
RC_GTEST_PROP(Salient, PowerBalancesAtEveryState, ()) {
  const Parameters p = salient_motor(between(0, 0.9));
  const Dynamics dynamics(p);
  const auto bits = *rc::gen::inRange(0, 64);
  Inputs in;
  in.gates = {bool(bits & 1), bool(bits & 2),  bool(bits & 4),
              bool(bits & 8), bool(bits & 16), bool(bits & 32)};
  in.active_torque = between(-5, 5);
  in.source_voltage = between(300, 600);
  const double iu = between(-20, 20), iv = between(-20, 20);
  const Variables y = {iu, iv, -iu - iv, between(-200, 200), between(-7, 7), between(300, 600)};
  const Regime regime = dynamics.regime(y, in, 0);
  Variables slope;
  Powers power;
  dynamics.derivative(regime, y, slope, power);
  const double h = 1e-7;
  Variables before = y, after = y;
  for (std::size_t n = 0; n < y.size(); ++n) before[n] -= h * slope[n], after[n] += h * slope[n];
  const double rate =
      (dynamics.stored(regime, after).stored() - dynamics.stored(regime, before).stored()) / (2 * h);
  const double spent =
      power[kCopper] + power[kBridge] + power[kBusResistance] + power[kFriction] + power[kLoad];
  // 1e5 W of flows; 500 J stored, to 1e-16, over 2e-7 s.
  RC_ASSERT(std::abs(power[kSupplied] - spent - rate) < 5e-2);
  RC_ASSERT(std::abs(slope[0] + slope[1] + slope[2]) < 1e-6);
}

TEST(Salient, EnergyBalancesThroughStartBrakeAndFloatingPhases) {
  const Parameters p = salient_motor();
  Plant plant(p, {.angle = 0.2});
  double worst = 0;
  SixStep drive(5e3, 0.5);
  drive.run(plant, 0.1, [&](const Plant& at) {
    worst = std::max(worst, std::abs(at.state().energy.residual()));
  });
  EXPECT_GT(plant.state().speed, 10);
  for (const Gates& gates : {Gates{}, Gates{.ul = true, .vl = true, .wl = true}, Gates{.uh = true}}) {
    plant.set_gates(gates);
    const double until = plant.time() + 0.01;
    while (plant.time() < until) {
      plant.advance_to(std::min(until, plant.next_event()));
      worst = std::max(worst, std::abs(plant.state().energy.residual()));
    }
  }
  // Some 10^4 steps of 1e-8 of the 146 J in the capacitor, of either sign.
  EXPECT_LT(worst, 1e-3);
}

// With L_d = L_q and no saturation the other path of the same plant.
TEST(Salient, WithEqualInductancesItIsTheRoundMotor) {
  Parameters round = salient_motor(0);
  round.motor.inductance_d = round.motor.inductance_q = 0;
  Parameters salient = round;
  salient.motor.inductance_d = salient.motor.inductance_q = round.motor.inductance;
  Plant a(round, {.angle = 0.2}), b(salient, {.angle = 0.2});
  SixStep drive_a(5e3, 0.5), drive_b(5e3, 0.5);
  drive_a.run(a, 0.05);
  drive_b.run(b, 0.05);
  const State x = a.state(), y = b.state();
  ASSERT_GT(x.speed, 5);
  // A few thousand steps of 1e-8 of the scale.
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(x.current[k], y.current[k], 1e-4);
    EXPECT_NEAR(x.voltage[k], y.voltage[k], 1e-2);
  }
  EXPECT_NEAR(x.speed, y.speed, 1e-6 * x.speed);
  EXPECT_NEAR(x.torque, y.torque, 1e-4);
  EXPECT_NEAR(x.energy.magnetic, y.energy.magnetic, 1e-5);
}

// Virtual work: at constant currents without a magnet, torque = d(stored energy) / d(angle).
RC_GTEST_PROP(Salient, ReluctanceTorqueIsTheSlopeOfTheStoredEnergy, ()) {
  Parameters p = salient_motor(0);
  p.motor.flux = 0;
  const SalientWinding winding(p.motor);
  const double angle = between(-4, 4), iu = between(-20, 20), iv = between(-20, 20);
  const Phases i = {iu, iv, -iu - iv};
  const double h = 1e-4;
  const double rate = (winding.stored(winding.field(angle + h, i)) -
                       winding.stored(winding.field(angle - h, i))) / (2 * h);
  RC_ASSERT(std::abs(winding.torque(winding.field(angle, i)) - 3 * rate) < 1e-4);
}

// What salient.hpp's first lines say of the iron: l_d is the slope of lambda_d, lambda_d at no current is the magnet's, and what
// flows in against both is what is stored.
RC_GTEST_PROP(Salient, TheIronKeepsItsLaw, ()) {
  const SalientWinding winding(salient_motor(between(0, 0.9)).motor);
  const double angle = between(-4, 4);
  const auto field = [&](double i_d, double i_q) {  // the d axis at angle + 180 degrees
    const double c = -std::cos(angle), s = -std::sin(angle), alpha = c * i_d - s * i_q, beta = s * i_d + c * i_q;
    return winding.field(angle, {alpha, -alpha / 2 + beta * std::sqrt(0.75), -alpha / 2 - beta * std::sqrt(0.75)});
  };
  const double d = between(-20, 20), q = between(-20, 20), h = 1e-3;
  RC_ASSERT(std::abs(field(0, q).lambda_d - 0.545) < 1e-12);
  RC_ASSERT(std::abs(winding.stored(field(0, 0))) < 1e-12);
  // Third derivatives: 36 mH / 6 A^2 of lambda, at 20 A 40 times of the energy; h^2 / 6 of them.
  RC_ASSERT(std::abs((field(d + h, q).lambda_d - field(d - h, q).lambda_d) / (2 * h) - field(d, q).l_d) < 1e-8);
  RC_ASSERT(std::abs((winding.stored(field(d + h, q)) - winding.stored(field(d - h, q))) / (2 * h) - 1.5 * d * field(d, q).l_d) < 1e-7);
  RC_ASSERT(std::abs((winding.stored(field(d, q + h)) - winding.stored(field(d, q - h))) / (2 * h) - 1.5 * 51e-3 * q) < 1e-7);
}

// An inductance that is not given is the round one, L - M.
TEST(Salient, AnAxisThatIsNotGivenHasTheRoundInductance) {
  Parameters p = salient_motor();
  p.motor.mutual = -14e-3;
  const Phases i = {7, -2, -5};
  const auto full = [&](double l_d, double l_q) {
    Motor m = p.motor;
    m.inductance_d = l_d;
    m.inductance_q = l_q;
    return SalientWinding(m).field(0.3, i);
  };
  const double round = 43e-3 + 14e-3;
  EXPECT_DOUBLE_EQ(full(0, 51e-3).lambda_d, full(round, 51e-3).lambda_d);
  EXPECT_DOUBLE_EQ(full(0, 51e-3).l_d, full(round, 51e-3).l_d);
  EXPECT_DOUBLE_EQ(full(36e-3, 0).lambda_q, full(36e-3, round).lambda_q);
}

TEST(Salient, TheRotorOfAnIronLobeAlignsWithTheCurrentOnItsDAxis) {
  // L_d > L_q and no magnet: stable with d along the current, from either side.
  Parameters p = salient_motor(0);
  p.motor.flux = 0;
  std::swap(p.motor.inductance_d, p.motor.inductance_q);
  const SalientWinding winding(p.motor);
  const Phases i = {10, -5, -5};  // along u
  const double d_at_u = std::numbers::pi;
  EXPECT_LT(winding.torque(winding.field(d_at_u + 0.1, i)), -0.1);
  EXPECT_GT(winding.torque(winding.field(d_at_u - 0.1, i)), 0.1);
}

// Held rotor, U against V and W in parallel: after ten time constants only resistance is left.
TEST(Salient, AVoltageVectorAtStandstillEndsInItsResistiveCurrent) {
  for (const double angle : {0.0, 0.3, 1.1, 2.5}) {
    Parameters p = salient_motor();
    p.bus = {.voltage = 20, .resistance = 0, .capacitance = 0};
    p.motor.static_friction = p.motor.coulomb_friction = 100;
    Plant plant(p, {.angle = angle / 3});
    plant.set_gates({.uh = true, .vl = true, .wl = true});
    plant.advance_to(0.25);
    const State s = plant.state();
    ASSERT_TRUE(s.stuck);
    const double expected = 20 / (1.5 * (3.6 + 0.05));
    EXPECT_NEAR(s.current[0], expected, 1e-4 * expected);
    EXPECT_NEAR(s.current[1], -expected / 2, 1e-4 * expected);
  }
}

// Matsui's Eq. (21) with L_d = 3/2 (L_g0 - L_g2), L_q = 3/2 (L_g0 + L_g2).
TEST(Salient, APilotPulseRisesAsEquation21Says) {
  Parameters p = salient_motor(0);
  p.bus = {.voltage = 540, .resistance = 0, .capacitance = 0};
  const double g0 = (36e-3 + 51e-3) / 3, g2 = (51e-3 - 36e-3) / 3;
  for (int n = 0; n < 12; ++n) {
    const double d = n * 30 * kDegree;  // of the d axis, so theta_e = d - 180 degrees
    Plant plant(p, {.angle = (d - std::numbers::pi) / 3});
    plant.set_gates({.uh = true, .vl = true, .wl = true});
    plant.advance_to(1e-6);
    const double slope = 4.0 / 9 * (g0 + g2 * std::cos(2 * d)) / (g0 * g0 - g2 * g2) * 540;
    // The switches' resistance takes 1e-5 of it in that time.
    EXPECT_NEAR(plant.state().current[0] / 1e-6, slope, 1e-4 * slope);
  }
}

TEST(Salient, SaturationShowsThePolarityInALongPulseAndHardlyInAShortOne) {
  const auto peak = [](double saturation, double d, double seconds) {
    Plant plant(salient_motor(saturation), {.angle = (d - std::numbers::pi) / 3});
    plant.set_gates({.uh = true, .vl = true, .wl = true});
    plant.advance_to(seconds);
    return plant.state().current[0];
  };
  const double pi = std::numbers::pi;
  EXPECT_NEAR(peak(0, 0, 5e-4), peak(0, pi, 5e-4), 1e-6);  // without it nobody can tell
  const auto excess = [&](double seconds) {
    return peak(0.3, 0, seconds) / peak(0.3, pi, seconds) - 1;
  };
  EXPECT_GT(excess(1e-3), 0.2);
  EXPECT_GT(excess(1e-3), 5 * excess(5e-5));
  EXPECT_GT(excess(5e-5), 0);
}

TEST(Salient, ANonsenseWindingIsRefusedByName) {
  Parameters p = salient_motor();
  p.motor.saturation = 1.2;
  p.motor.shape.kind = BackEmfShape::Kind::kTrapezoidal;
  const auto lines = validate(p);
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_NE(lines[0].find("motor.saturation is 1.2"), std::string::npos);
  EXPECT_NE(lines[1].find("motor.shape is not sinusoidal"), std::string::npos);
}

}  // namespace
}  // namespace steplock::plant
