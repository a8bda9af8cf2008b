// The four facts that a circuit simulator showed for the servo of the default parameters:
// 24 V, 3000 rpm, 0.382 ohm, 188 uH, 0.03966 V/Hz, 4 pole pairs, 20 kHz, duty 0.6.
#include <gtest/gtest.h>

#include "tests/model/plant/six_step.hpp"

namespace steplock::plant {
namespace {

using Kind = BackEmfShape::Kind;

constexpr double kRated = 2 * std::numbers::pi * 50;  // rad/s
constexpr double kEmf = 0.03966 * 200;                // V, peak
constexpr double kPeriod = 50e-6, kOnTime = 30e-6;

Parameters servo(Kind kind) {
  Parameters p;
  p.motor.shape.kind = kind;
  p.load.inertia = 1;  // holds 3000 rpm
  p.bus.resistance = 0;
  return p;
}

Plant at(const Parameters& p, double degrees, double current) {
  return Plant(p, {.angle = degrees * kDegree / p.motor.pole_pairs,
                   .speed = kRated,
                   .current = {current, -current, 0}});
}

TEST(FieldFacts, InOnTimeTheFloatingPhaseShowsItsBemfAgainstHalfTheBus) {
  for (const auto& [kind, factor] :
       {std::pair{Kind::kTrapezoidal, 1.0}, {Kind::kSinusoidal, 1.5}}) {
    for (double degrees : {40, 55, 65, 80}) {
      Plant plant = at(servo(kind), degrees, 1);
      plant.set_gates({.uh = true, .vl = true});
      plant.advance_to(5e-6);
      const State s = plant.state();
      ASSERT_TRUE(s.floating[2]);
      EXPECT_NEAR(s.neutral, 12 + (factor - 1) * s.emf[2], 1e-6);
      EXPECT_NEAR(s.voltage[2] - 12, factor * s.emf[2], 1e-6);
      EXPECT_NEAR(s.voltage[2] - s.neutral, s.emf[2], 1e-12);
    }
  }
}

TEST(FieldFacts, InOffTimeWithCurrentTheNeutralIsNearZeroAndTheTerminalShowsItsBemf) {
  Plant plant = at(servo(Kind::kTrapezoidal), 40, 3);
  plant.set_gates({.vl = true});
  plant.advance_to(5e-6);
  const State s = plant.state();
  ASSERT_TRUE(s.floating[2]);
  EXPECT_NEAR(s.neutral, -0.55 / 2, 0.05);  // half a diode drop and the resistances
  EXPECT_NEAR(s.voltage[2], s.emf[2], 0.35);
  EXPECT_GT(s.voltage[2], 4);
}

TEST(FieldFacts, PastTheCrossingInOffTimeTheTerminalClampsAndCurrentFlowsInTheFloatingPhase) {
  Plant plant = at(servo(Kind::kTrapezoidal), 75, 5);
  plant.set_gates({.vl = true});
  plant.advance_to(10e-6);
  const State s = plant.state();
  EXPECT_LT(s.emf[2], -3);
  EXPECT_FALSE(s.floating[2]);
  EXPECT_GT(s.current[2], 0.1);
  EXPECT_NEAR(s.voltage[2], -0.55, 0.01);
}

TEST(FieldFacts, InOffTimeWithoutCurrentTheNeutralRisesSoThatOnlyAMeasuredOneStillCrosses) {
  // The end of the off-time of the light-load steady state, across the sector of falling w.
  double lowest = 100, highest = -100;
  double measured = 0, half_bus = 0, zero = 0;  // last angle at which w is above each reference
  for (double degrees = 31; degrees <= 86; degrees += 0.25) {
    Plant plant = at(servo(Kind::kTrapezoidal), degrees, 0);
    plant.set_gates({.uh = true, .vl = true});
    plant.advance_to(kOnTime);
    // 8.1 V over two inductances for 30 us, less what the resistances take.
    EXPECT_NEAR(plant.state().current[0], (24 - 2 * kEmf) / (2 * 188e-6) * kOnTime, 0.03);
    plant.set_gates({.vl = true});
    plant.advance_to(kPeriod);
    const State s = plant.state();
    ASSERT_TRUE(s.floating[0]);  // the current has died
    lowest = std::min(lowest, s.neutral);
    highest = std::max(highest, s.neutral);
    const double angle = s.electrical_angle / kDegree;
    if (s.voltage[2] > s.virtual_neutral) measured = angle;
    if (s.voltage[2] > 12) half_bus = angle;
    if (s.voltage[2] > 0) zero = angle;
  }
  // v alone holds the star point at its BEMF, 7.9 V, until w's low diode shares it: 5.3 V then.
  EXPECT_NEAR(lowest, 5.3, 0.2);  // how far it sinks depends on when the main current dies
  EXPECT_NEAR(highest, kEmf, 1e-3);
  EXPECT_NEAR(measured, 60, 0.3);  // grid of 0.25 degrees
  EXPECT_LT(half_bus, 60 - 10);    // the on-time's threshold is far too early,
  EXPECT_GT(zero, 60 + 10);        // the continuous off-time's far too late
}

struct Demagnetisation {
  double seconds, degrees;
};

Demagnetisation demagnetise(double amperes, double speed, double inductance) {
  Parameters p = servo(Kind::kTrapezoidal);
  p.motor.inductance = inductance;
  // From u-v to u-w at 90 degrees: v's current must die through its high diode.
  Plant plant(p, {.angle = 90 * kDegree / 4, .speed = speed, .current = {amperes, -amperes, 0}});
  plant.set_gates({.uh = true, .wl = true});
  while (!plant.state().floating[1]) plant.advance_to(plant.next_event());
  return {plant.time(), plant.state().electrical_angle / kDegree - 90};
}

TEST(FieldFacts, DemagnetisationTakes11MicrosecondsAt0A76And89At6A6) {
  // The circuit simulator's transistors had resistances of their own: 4 % is that difference.
  const auto light = demagnetise(0.76, kRated, 188e-6), heavy = demagnetise(6.6, kRated, 188e-6);
  EXPECT_NEAR(light.seconds, 10.7e-6, 0.04 * 10.7e-6);
  EXPECT_NEAR(light.degrees, 0.77, 0.04 * 0.77);  // 10.7 us at 3000 rpm; printed as 0.8
  EXPECT_NEAR(heavy.seconds, 89e-6, 0.04 * 89e-6);
  EXPECT_NEAR(heavy.degrees, 6.4, 0.04 * 6.4);
}

TEST(FieldFacts, DemagnetisationAngleGrowsWithCurrentInductanceAndSpeed) {
  const double base = demagnetise(3, kRated, 188e-6).degrees;
  EXPECT_GT(demagnetise(6, kRated, 188e-6).degrees, 1.8 * base);
  EXPECT_GT(demagnetise(3, kRated, 376e-6).degrees, 1.8 * base);
  EXPECT_GT(demagnetise(3, 1.4 * kRated, 188e-6).degrees, 1.2 * base);
  EXPECT_GT(demagnetise(20, kRated, 400e-6).degrees, 30);  // a bad case
}

}  // namespace
}  // namespace steplock::plant
