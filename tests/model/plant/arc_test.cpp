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
             double active = 0, const Legs& open = {}) {
  Planned out{Dynamics(p), {}, step};
  Inputs in;
  in.gates = gates;
  in.source_voltage = p.bus.voltage;
  in.active_torque = active;
  in.open = open;
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
  for (int n = 0; y[kIu] != 0; ++n) {
    ASSERT_LT(n, 1000);
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

TEST(Arc, EndsWhereTheTerminalMeetsTheUpperClamp) {
  // The same at the other rail, half a turn on.
  const double speed = 2 * std::numbers::pi * 50;
  const double emf = 0.03966 * 200;
  const auto run = plan(bench(), {.uh = true}, {0, 0, 0, speed, 151 * kDegree, 24}, 20e-6);
  ASSERT_EQ(run.arc.regime().circuit.mode[1], LegMode::kFloating);
  const Point& end = run.arc.points()[2];
  EXPECT_GT(end.out.terminals.voltage[1], 24.55);
  EXPECT_NEAR(end.y[kAngle] / kDegree, 150 + 30 * 0.55 / emf, 1e-6);
}

// A contact that opens under current lets it run out, whichever way it flows: V against W through U is what drives it down.
TEST(Arc, EndsWhenTheCurrentOfAContactThatOpensReachesZero) {
  for (const double current : {2.0, 0.5, -0.5, -2.0}) {
    const Gates against = current > 0 ? Gates{.ul = true, .vh = true} : Gates{.uh = true, .vl = true};
    Variables y = {current, -current, 0, 0, 0, 24};
    double elapsed = 0;
    for (int n = 0; y[kIu] != 0; ++n) {
      ASSERT_LT(n, 1000);
      const auto run = plan(bench(), against, y, 50e-6, 0, {true, false, false});
      ASSERT_TRUE(run.arc.regime().opening[0]);
      elapsed += run.arc.length();
      y = run.arc.settled(run.arc.length());
    }
    const double r = 2 * (0.382 + 0.01), l = 2 * 188e-6;
    EXPECT_NEAR(elapsed, l / r * std::log(1 + std::abs(current) * r / 24), 1e-9);
    EXPECT_EQ(y[kIv], 0);
  }
}

// u's diode lets go after some 4 us, as it does far from a corner; a corner 2 us away ends the arc, though it is looked at last.
TEST(Arc, EndsAtTheEarliestOfSeveralEnds) {
  Parameters p = bench();
  const double speed = 2 * std::numbers::pi * 50, per_degree = 1 / (200 * 360.0);
  const double corner = 2e-6;
  const auto at = [&](double degrees) { return plan(p, {.vl = true}, {0.2, -0.2, 0, speed, degrees * kDegree, 24}, 20e-6); };
  const auto alone = at(80);
  EXPECT_EQ(alone.arc.settled(alone.arc.length())[kIu], 0);
  EXPECT_GT(alone.arc.length(), 1.5 * corner);
  const auto both = at(90 - corner / per_degree);
  EXPECT_NEAR(both.arc.length(), corner, 1e-11);
  EXPECT_GT(both.arc.settled(both.arc.length())[kIu], 0.05);
}

// A guard that stands at zero to the last bit, as a bus at rest does at its source's voltage, ends nothing.
TEST(Arc, ABusAtItsSourcesVoltageEndsNothing) {
  Parameters p = bench();
  p.bus = {.voltage = 24, .resistance = 0.05, .capacitance = 470e-6, .sinks = false};
  EXPECT_EQ(plan(p, {}, {0, 0, 0, 0, 0, 24}, 20e-6).arc.length(), 20e-6);
}

// What comes next begins where an arc ends, to the last bit; its middle is the middle of what is left of it.
TEST(Arc, ItsPointsAreThoseOfItsLength) {
  const double speed = 2 * std::numbers::pi * 50;
  int cut = 0;
  for (double angle = 60; angle < 90; angle += 0.37) {
    const double current = -0.7 + 0.005 * (angle - 60);  // ends near zero, where what a difference rounds shows most
    const auto run = plan(bench(), {.uh = true, .vl = true}, {current, -current, 0, speed, angle * kDegree, 24}, 33e-6);
    const Arc& arc = run.arc;
    EXPECT_EQ(arc.points()[0].elapsed, 0);
    EXPECT_EQ(arc.points()[1].elapsed, arc.length() / 2);
    EXPECT_EQ(arc.points()[1].y, arc.at(arc.length() / 2));
    EXPECT_EQ(arc.points()[2].y, arc.at(arc.length()));
    if (arc.length() < 33e-6) {
      ++cut;
      continue;
    }
    DormandPrinceStep<8, 6> whole;  // the same step, without an arc around it
    whole.attempt(arc.points()[0].y, 33e-6, run.dynamics.scale(), [&](const Variables& y, Variables& slope, Powers& power) {
      run.dynamics.derivative(arc.regime(), y, slope, power);
    });
    EXPECT_EQ(arc.points()[2].y, whole.end());
  }
  EXPECT_GT(cut, 3);
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
  for (int n = 0; y[kSpeed] != 0; ++n) {
    ASSERT_LT(n, 1000);
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

// A step is kept if its error is within the tolerance, and only then.
TEST(Arc, KeepsAStepWhoseErrorIsWithinTheTolerance) {
  Parameters p = bench();
  p.accuracy = {.tolerance = 1e-8, .max_step = 1};
  p.motor.static_friction = 1;
  int kept = 0, tried_again = 0;
  for (double h = 1e-5; h < 1e-3; h *= 1.02) {
    const Variables y = {0, 0, 0, 0, 60 * kDegree, 24};
    const auto run = plan(p, {.uh = true, .vl = true}, y, h);
    const auto error = [&](double length) {
      DormandPrinceStep<8, 6> step;
      return step.attempt(y, length, run.dynamics.scale(), [&](const Variables& at, Variables& slope, Powers& power) {
        run.dynamics.derivative(run.arc.regime(), at, slope, power);
      });
    };
    EXPECT_LE(error(run.arc.length()), 1e-8);
    EXPECT_EQ(run.arc.length() == h, error(h) <= 1e-8) << h;
    (run.arc.length() == h ? kept : tried_again)++;
  }
  EXPECT_GT(kept, 10);
  EXPECT_GT(tried_again, 10);
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
