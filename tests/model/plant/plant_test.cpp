#include "model/plant/plant.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstring>

#include "tests/model/plant/six_step.hpp"

namespace steplock::plant {
namespace {

std::vector<double> numbers(const State& s) {
  return {s.current[0], s.current[1], s.current[2], s.bus_voltage,    s.speed,
          s.angle,      s.torque,     s.neutral,    s.energy.supplied};
}

Parameters noisy() {
  Parameters p;
  for (auto& c : p.sensing.comparator) c.noise = 0.02;
  p.sensing.limit.noise = 0.05;
  return p;
}

TEST(Plant, TheSameRunGivesTheSameBits) {
  std::vector<double> first;
  std::vector<Pins> first_pins;
  for (int run = 0; run < 2; ++run) {
    Plant plant(noisy(), {.angle = 0.3});
    SixStep drive(30e3, 0.4);
    std::vector<Pins> pins;
    drive.run(plant, 0.05, [&](const Plant& at) { pins.push_back(at.pins()); });
    if (run == 0) {
      first = numbers(plant.state());
      first_pins = pins;
    } else {
      EXPECT_EQ(std::memcmp(numbers(plant.state()).data(), first.data(), 8 * first.size()), 0);
      EXPECT_TRUE(pins == first_pins);
    }
  }
}

TEST(Plant, AnotherSeedGivesOtherChatter) {
  std::uint64_t changes[2] = {};
  for (int run = 0; run < 2; ++run) {
    Parameters p = noisy();
    p.sensing.seed = run + 1;
    Plant plant(p, {.speed = 20});
    double hash = 0;
    while (plant.time() < 0.02) {
      plant.advance_to(plant.next_event());
      if (plant.pins().comparator[0]) hash += plant.time();
    }
    std::memcpy(&changes[run], &hash, 8);
  }
  EXPECT_NE(changes[0], changes[1]);
}

TEST(Plant, ManySmallAdvancesEqualOneLargeToTheLastBit) {
  Plant whole(noisy(), {.speed = 100}), cut(noisy(), {.speed = 100});
  for (Plant* plant : {&whole, &cut}) plant->set_gates({.uh = true, .vl = true});
  whole.advance_to(1e-3);
  for (int n = 1; n <= 10000; ++n) cut.advance_to(n * 1e-7);
  EXPECT_EQ(whole.pins(), cut.pins());
  EXPECT_EQ(numbers(whole.state()), numbers(cut.state()));
}

TEST(Plant, CuttingTheArcsThemselvesChangesNoMoreThanTheTolerance) {
  Plant whole(Parameters{}, {.speed = 100}), cut(Parameters{}, {.speed = 100});
  for (Plant* plant : {&whole, &cut}) plant->set_gates({.uh = true, .vl = true});
  whole.advance_to(1e-3);
  for (int n = 1; n <= 1000; ++n) {
    cut.advance_to(n * 1e-6);
    cut.set_limit_threshold(10 + n);  // ends the arc, changes nothing of the motion
  }
  const auto a = numbers(whole.state()), b = numbers(cut.state());
  // A thousand steps of 1e-8, contracted by the winding's resistance.
  for (std::size_t n = 0; n < a.size(); ++n) EXPECT_NEAR(a[n], b[n], 1e-6 * (1 + std::abs(a[n])));
}

TEST(Plant, HalvingTheToleranceMovesTheSpeedByLessThanATenThousandth) {
  double speed[3];
  for (int n = 0; n < 3; ++n) {
    Parameters p;
    p.load.inertia = 1e-5;
    p.load.opposing_torque = 0.02;
    p.accuracy.tolerance /= 1 << n;
    Plant plant(p, {.angle = 0.2});
    SixStep drive(20e3, 0.6);
    drive.run(plant, 0.3);
    speed[n] = plant.state().speed;
  }
  EXPECT_GT(speed[0], 100);
  EXPECT_NEAR(speed[1], speed[0], 1e-4 * speed[0]);
  EXPECT_NEAR(speed[2], speed[1], 1e-4 * speed[1]);
}

TEST(Plant, NoPinChangesBeforeTheAnnouncedEventAndItLiesAhead) {
  Plant plant(noisy(), {.angle = 0.3});
  Plant probe(noisy(), {.angle = 0.3});
  SixStep drive(30e3, 0.4), same(30e3, 0.4);
  double time = 0;
  int events = 0;
  while (time < 2e-3) {
    const double next = plant.next_event();
    ASSERT_GT(next, plant.time());
    const Pins before = plant.pins();
    plant.advance_to(std::nextafter(next, 0));
    ASSERT_EQ(plant.pins(), before);
    time = next;
    plant.advance_to(next);
    events += !(plant.pins() == before);
    if (time > 1e-3 && !plant.gates().uh) plant.set_gates({.uh = true, .wl = true});
  }
  EXPECT_GT(events, 10);
}

// Two windings let go by the diodes in the same instant, their back-EMF a third of the bus apart: what the end of one
// current leaves over must not turn the other one round, or each of them starts the other again for ever.
TEST(Plant, TwoDiodesThatStopTogetherStayStopped) {
  Parameters p;
  p.motor.flux = 0.3275e-3;
  p.motor.pole_pairs = 2;
  p.motor.inductance = 20e-6;
  p.motor.shape.kind = BackEmfShape::Kind::kSinusoidal;
  p.bus = {.voltage = 89.9735, .resistance = 0};
  Plant plant(p, {.angle = 5.24152547 / 2, .speed = 53312.4, .current = {-2.465e-7, 0, 2.465e-7}});
  plant.set_gates({.ul = true});
  plant.advance_to(1e-9);
  EXPECT_LT(plant.steps(), 20u) << "half a picosecond each when they chatter: 2000";
  for (const double current : plant.state().current) EXPECT_EQ(current, 0);
}

TEST(Plant, CoastingComparatorsSpellTheSectorAtStandardPositions) {
  // From 10 degrees on in steps of 60: u, v, w above the mean of the terminals.
  const std::array<bool, 3> code[6] = {{1, 0, 1}, {1, 0, 0}, {1, 1, 0},
                                       {0, 1, 0}, {0, 1, 1}, {0, 0, 1}};
  for (double speed : {5.0, 300.0}) {  // below and beyond the clamp of the lowest terminal
    for (int sector = 0; sector < 6; ++sector) {
      Plant plant(Parameters{}, {.angle = (30 + 60 * sector) * kDegree / 4, .speed = speed});
      plant.advance_to(1e-6);
      EXPECT_EQ(plant.pins().comparator, code[sector]) << speed << " rad/s, sector " << sector;
      Plant back(Parameters{}, {.angle = (30 + 60 * sector) * kDegree / 4, .speed = -speed});
      back.advance_to(1e-6);
      for (int k = 0; k < 3; ++k) EXPECT_EQ(back.pins().comparator[k], !code[sector][k]);
    }
  }
}

TEST(Plant, ABlockingSupplyLetsTheBusRiseUnderRegeneration) {
  for (const bool sinks : {true, false}) {
    Parameters p;
    p.bus.sinks = sinks;
    p.load.inertia = 1e-4;
    Plant plant(p, {.speed = 700});  // back-EMF line to line beyond the bus
    plant.advance_to(0.05);
    const double bus = plant.state().bus_voltage;
    if (sinks) {
      EXPECT_LT(bus, 26);
    } else {
      EXPECT_GT(bus, 30);
      EXPECT_EQ(plant.state().source_current, 0);
    }
  }
}

TEST(Plant, TheBusSagsByItsResistanceAtASteadyCurrent) {
  Parameters p;
  p.motor.static_friction = p.motor.coulomb_friction = 10;
  p.bus.resistance = 0.1;
  Plant plant(p);
  plant.set_gates({.uh = true, .vl = true});
  plant.advance_to(0.05);
  const State s = plant.state();
  EXPECT_NEAR(s.current[0], 24 / (2 * (0.382 + 0.01) + 0.1), 1e-5);
  EXPECT_NEAR(s.bus_voltage, 24 - 0.1 * s.current[0], 1e-5);
  EXPECT_NEAR(s.source_current, s.shunt_current, 1e-5);
}

double decades(double low, double high) {
  return low * std::pow(high / low, *rc::gen::inRange(0, 1001) * 1e-3);
}

// Motors from a spindle's to a washing machine's, buses from stiff to soft.
Parameters any_motor() {
  Parameters p = noisy();
  p.motor.resistance = decades(0.01, 6);
  p.motor.inductance = p.motor.resistance * decades(1e-4, 5e-3);
  p.motor.mutual = -0.3 * p.motor.inductance;
  p.motor.flux = decades(5e-4, 0.1);
  p.motor.pole_pairs = *rc::gen::inRange(1, 16);
  p.motor.inertia = decades(1e-6, 1e-2);
  p.motor.coulomb_friction = decades(1e-4, 1e-1);
  p.motor.static_friction = 1.5 * p.motor.coulomb_friction;
  p.motor.cogging_torque = *rc::gen::arbitrary<bool>() ? decades(1e-4, 0.1) : 0;
  p.motor.shape.kind = *rc::gen::arbitrary<bool>() ? BackEmfShape::Kind::kSinusoidal
                                                   : BackEmfShape::Kind::kTrapezoidal;
  p.motor.shape.flat_top_deg = *rc::gen::inRange(0, 175);
  p.bus.voltage = decades(5, 300);
  p.bus.resistance = *rc::gen::arbitrary<bool>() ? decades(0.005, 0.5) : 0;
  p.bus.capacitance = decades(20e-6, 5e-3);
  p.bus.sinks = p.bus.resistance == 0 || *rc::gen::arbitrary<bool>();
  return p;
}

// Whatever the motor and whatever the gates do, the plant stays finite, keeps Kirchhoff and its
// energy, and needs no unbounded number of steps.
RC_GTEST_PROP(Plant, SurvivesAnySequenceOfGates, ()) {
  const Parameters p = any_motor();
  const double no_load = p.bus.voltage / (p.motor.flux * p.motor.pole_pairs);
  Plant plant(p, {.angle = *rc::gen::inRange(-700, 700) * 0.01,
                  .speed = no_load * *rc::gen::inRange(-1000, 1000) * 1e-3});
  double time = 0;
  for (int n = 0; n < 60; ++n) {
    const auto bits = *rc::gen::inRange(0, 64);
    plant.set_gates({bool(bits & 1), bool(bits & 2), bool(bits & 4), bool(bits & 8),
                     bool(bits & 16), bool(bits & 32)});
    plant.set_load_torque(1e-3 * *rc::gen::inRange(0, 50));
    time += 1e-7 * *rc::gen::inRange(1, 2000);
    plant.advance_to(time);
    const State s = plant.state();
    for (double x : numbers(s)) RC_ASSERT(std::isfinite(x));
    RC_ASSERT(std::abs(s.current[0] + s.current[1] + s.current[2]) < 1e-9);
    // A few thousand steps of 1e-8, of either sign, on all the energy there is.
    const double all = std::abs(s.energy.supplied) + s.energy.stored() + s.energy.stored_at_start;
    RC_ASSERT(std::abs(s.energy.residual()) < 1e-5 * all);
  }
  RC_ASSERT(plant.steps() < 40000u);
}

}  // namespace
}  // namespace steplock::plant
