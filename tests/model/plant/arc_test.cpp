#include "model/plant/arc.hpp"

#include <gtest/gtest.h>

#include "tests/model/plant/six_step.hpp"

namespace steplock::plant {
namespace {

// A rotor too heavy to notice, on a bus that does not move: circuits with known solutions.
Parameters bench() {
  Parameters p;
  p.load.inertia = 1;
  p.bus.resistance = 0;
  return p;
}

struct Planned {
  Dynamics dynamics;
  Arc arc;
  double step;
};

Planned plan(const Parameters& p, const Gates& gates, const Variables& y, double step,
             double active = 0) {
  Planned out{Dynamics(p), {}, step};
  Inputs in;
  in.gates = gates;
  in.source_voltage = p.bus.voltage;
  in.active_torque = active;
  out.arc.plan(out.dynamics, out.dynamics.regime(y, in, 0), y, p.accuracy, out.step);
  return out;
}

TEST(Arc, EndsWhenTheFreewheelingCurrentReachesZero) {
  Parameters p = bench();
  p.bridge.diode_resistance = 0.01;
  const double current = 2, loop_r = 2 * 0.382 + 0.01 + 0.01, loop_l = 2 * 188e-6;
  // u freewheels through its low diode, v is on low, rotor at rest: the drop drives it to zero.
  const auto run = plan(p, {.vl = true}, {current, -current, 0, 0, 0, 24}, 1);
  double elapsed = run.arc.length();
  Arc arc = run.arc;
  Variables y = arc.settled(elapsed);
  while (y[kIu] != 0) {
    auto next = plan(p, {.vl = true}, y, 1);
    elapsed += next.arc.length();
    y = next.arc.settled(next.arc.length());
  }
  const double expected = loop_l / loop_r * std::log(1 + current * loop_r / 0.55);
  // Twenty-odd steps of 1e-8 of 2 A, at 1460 A/s.
  EXPECT_NEAR(elapsed, expected, 3e-10);
  EXPECT_EQ(y[kIv], 0);
}

TEST(Arc, EndsWhereTheTerminalMeetsTheClamp) {
  // u held low without current: v_v = e_v - e_u.  From 330 degrees on e_v stays at the bottom while
  // e_u rises by a BEMF in 30 degrees, so that v reaches -0.55 V a known angle later.
  const double speed = 2 * std::numbers::pi * 50;
  const double emf = 0.03966 * 200;
  const auto run = plan(bench(), {.ul = true}, {0, 0, 0, speed, 331 * kDegree, 24}, 20e-6);
  ASSERT_EQ(run.arc.regime().circuit.mode[1], LegMode::kFloating);
  const Point& end = run.arc.points()[2];
  EXPECT_NEAR(end.out.terminals.voltage[1], -0.55, 1e-6);
  EXPECT_LT(end.out.terminals.voltage[1], -0.55);  // beyond, or the next arc would float again
  EXPECT_NEAR(end.y[kAngle] / kDegree, 330 + 30 * 0.55 / emf, 1e-6);
}

TEST(Arc, EndsOnTheCornerOfTheTrapezoid) {
  const double speed = 2 * std::numbers::pi * 50;
  auto run = plan(bench(), {}, {0, 0, 0, speed, 85 * kDegree, 24}, 100e-6);
  EXPECT_NEAR(run.arc.points()[2].y[kAngle], 90 * kDegree, 1e-9);
  run = plan(bench(), {}, {0, 0, 0, -speed, 95 * kDegree, 24}, 100e-6);
  EXPECT_NEAR(run.arc.points()[2].y[kAngle], 90 * kDegree, 1e-9);
}

TEST(Arc, EndsWhenTheSpeedReachesZeroAndIsZeroThen) {
  Parameters p;
  p.accuracy.max_step = 1;
  const double w = 10, inertia = p.motor.inertia, dry = p.motor.coulomb_friction;
  auto run = plan(p, {}, {0, 0, 0, w, 0.1, 24}, 1);
  double elapsed = run.arc.length();
  Variables y = run.arc.settled(run.arc.length());
  while (y[kSpeed] != 0) {
    run = plan(p, {}, y, 1);
    elapsed += run.arc.length();
    y = run.arc.settled(run.arc.length());
  }
  EXPECT_NEAR(elapsed, w * inertia / dry, 1e-9);
}

TEST(Arc, EndsWhenTheRisingCurrentBreaksTheRotorAway) {
  Parameters p = bench();
  p.motor.static_friction = p.motor.coulomb_friction = 0.02;
  const double per_ampere = 2 * p.motor.flux * 4;  // both tops
  const double current = 0.02 / per_ampere, r = 2 * (0.382 + 0.01), l = 2 * 188e-6;
  const double expected = -l / r * std::log(1 - current * r / 24);
  const auto run = plan(p, {.uh = true, .vl = true}, {0, 0, 0, 0, 60 * kDegree, 24}, 50e-6);
  EXPECT_EQ(run.arc.regime().turning, 0);
  EXPECT_NEAR(run.arc.length(), expected, 1e-7 * expected);
}

TEST(Arc, EndsWhenTheBusRisesPastASourceThatCannotSink) {
  Parameters p = bench();
  p.bus = {.voltage = 24, .resistance = 0.05, .capacitance = 470e-6, .sinks = false};
  // 5 A freewheel into a bus that stands 20 mV low: 0.02 V / (5 A / C) and the source's own help.
  auto run = plan(p, {}, {5, -5, 0, 0, 0, 23.98}, 20e-6);
  const auto& end = run.arc.points()[2];
  EXPECT_EQ(run.arc.regime().source_conducts, 1);
  EXPECT_LT(run.arc.length(), 2e-6);
  EXPECT_NEAR(end.y[kBus], 24, 2e-8);  // 10 kV/s for 1e-12 s
  EXPECT_EQ(plan(p, {}, end.y, 20e-6).arc.regime().source_conducts, 0);
  // And back: a current out of the bus ends the blocking.
  run = plan(p, {.uh = true, .vl = true}, {5, -5, 0, 0, 0, 24.02}, 20e-6);
  EXPECT_EQ(run.arc.regime().source_conducts, 0);
  EXPECT_NEAR(run.arc.points()[2].y[kBus], 24, 2e-8);
}

TEST(Arc, AStepNeverTurnsMoreThanTwentyDegrees) {
  Parameters p = bench();
  p.motor.shape.kind = BackEmfShape::Kind::kSinusoidal;
  p.accuracy.max_step = 1;
  const auto run = plan(p, {}, {0, 0, 0, 2 * std::numbers::pi * 50, 0, 24}, 1);
  EXPECT_LE(run.arc.points()[2].y[kAngle], 20.0001 * kDegree);
}

TEST(Arc, ATighterToleranceTakesShorterSteps) {
  double length[2];
  for (int n = 0; n < 2; ++n) {
    Parameters p = bench();
    p.accuracy = {.tolerance = n == 0 ? 1e-5 : 1e-10, .max_step = 1e-3};
    // At rest nothing but the error limits the step.
    p.motor.static_friction = 1;
    const auto run = plan(p, {.uh = true, .vl = true}, {0, 0, 0, 0, 60 * kDegree, 24}, 1e-3);
    length[n] = run.arc.length();
  }
  EXPECT_NEAR(std::log10(length[0] / length[1]), 1, 0.3);  // five decades at order five
}

}  // namespace
}  // namespace steplock::plant
