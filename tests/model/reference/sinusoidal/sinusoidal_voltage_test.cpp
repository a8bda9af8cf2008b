// The reconstruction against the plant, whose bridge knows switches and diodes.
#include <gtest/gtest.h>

#include "model/plant/plant.hpp"
#include "model/reference/commutation.hpp"
#include "model/reference/sinusoidal/applied_voltage.hpp"
#include "model/reference/sinusoidal/modulator.hpp"

namespace steplock::reference::sinusoidal {
namespace {

constexpr double kPeriod = 200e-6, kDeadTime = 4e-6, kBus = 270;

// A held rotor under constant duties: mean terminal voltages and currents over the tenth period.
struct Mean {
  Phases voltage = {}, current = {};
};
Mean on_the_plant(const Phases& duty) {
  plant::Parameters p;
  p.motor = {.resistance = 1.91, .inductance = 9.55e-3, .mutual = -4.775e-3, .flux = 0.27,
             .pole_pairs = 3, .shape = {.kind = plant::BackEmfShape::Kind::kSinusoidal},
             .inertia = 1e-3, .coulomb_friction = 100, .static_friction = 100};
  p.bus = {.voltage = kBus, .resistance = 0};
  p.bridge = {.on_resistance = 0, .diode_drop = 1, .diode_resistance = 0};
  plant::Plant plant(p);
  CentredPwm pwm({.period = kPeriod, .dead_time = kDeadTime});
  GateGuard guard({.dead_time = kDeadTime});
  pwm.set(duty);
  Mean mean;
  double t = 0;
  while (t < 10 * kPeriod - 1e-12) {
    pwm.update(t);
    Gates g = {};
    for (std::size_t leg = 0; leg < 3; ++leg) g[2 * leg + (pwm.high(leg, t) ? 0 : 1)] = true;
    guard.update(t, g, true);
    const Gates& on = guard.gates();
    plant.set_gates({on[0], on[1], on[2], on[3], on[4], on[5]});
    const double next = std::min({pwm.next(t), guard.next(), t + kPeriod / 1000});
    const plant::State s = plant.state();
    if (t > 9 * kPeriod - 1e-12) {
      for (std::size_t k = 0; k < 3; ++k) {
        mean.voltage[k] += s.voltage[k] * (next - t) / kPeriod;
        mean.current[k] += s.current[k] * (next - t) / kPeriod;
      }
    }
    t = next;
    plant.advance_to(t);
  }
  return mean;
}

design::sinusoidal::Applied known() {
  return {.period = kPeriod, .dead_time = kDeadTime, .diode_drop = 1, .small_current = 0.05};
}

TEST(SinusoidalVoltage, ReconstructedFromThePatternItIsThePlants) {
  const AppliedVoltage applied(known());
  for (const Phases& duty : {Phases{0.6, 0.46, 0.4}, Phases{0.3, 0.62, 0.5}, Phases{0.1, 0, 0}}) {
    const Mean m = on_the_plant(duty);
    const Phases v = applied(duty, m.current, kBus);
    // Dead time takes 5.4 V of each; the sum over the tenth period is fine to a thousandth of it.
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(v[k], m.voltage[k], 0.3) << k;
    EXPECT_GT(std::abs(duty[0] * kBus - m.voltage[0]), 5);
  }
}

TEST(SinusoidalVoltage, ACompensatedDutyComesAbout) {
  const AppliedVoltage applied(known());
  const Phases wanted = {0.6, 0.5, 0.4};
  const Phases current = on_the_plant(wanted).current;
  const Mean m = on_the_plant(applied.compensated(wanted, current, kBus));
  // What counts is the difference between two legs; v has next to no current here.
  EXPECT_NEAR(m.voltage[0] - m.voltage[2], 0.2 * kBus, 0.3);
  EXPECT_LT(on_the_plant(wanted).voltage[0] - on_the_plant(wanted).voltage[2], 0.2 * kBus - 10);
}

// A measured current of less than a step is noise; a wanted one, however small, is that.
TEST(SinusoidalVoltage, ASmallCurrentLosesInProportionAndAWantedOneIsMadeUpForByItsSign) {
  const AppliedVoltage applied(known());
  const Phases half = {0.5, 0.5, 0.5};
  const double whole = applied(half, {0.05, 0, 0}, kBus)[0] - 0.5 * kBus;
  EXPECT_NEAR(applied(half, {0.02, 0, 0}, kBus)[0] - 0.5 * kBus, 0.4 * whole, 1e-9);
  const Phases small = applied.compensated(half, {1e-6, 0, -1e-6}, kBus), large = applied.compensated(half, {9, 0, -9}, kBus);
  EXPECT_EQ(small, large);
  EXPECT_EQ(small[1], 0.5);
}

TEST(SinusoidalVoltage, ALegThatDoesNotSwitchLosesNothing) {
  const AppliedVoltage applied(known());
  const Phases v = applied({0, 1, 0.5}, {3, -3, 0}, kBus);
  EXPECT_EQ(v[0], 0);
  EXPECT_EQ(v[1], kBus);
  EXPECT_EQ(v[2], 0.5 * kBus);  // no current: as much up as down
}

}  // namespace
}  // namespace steplock::reference::sinusoidal
