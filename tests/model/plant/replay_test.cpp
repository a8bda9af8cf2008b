#include "model/plant/replay.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/model/plant/six_step.hpp"

namespace steplock::plant {
namespace {

std::vector<Sample> run(const std::vector<GateEvent>& events, double dt, double duration,
                        const InitialState& initial = {}) {
  std::vector<Sample> out;
  replay({}, initial, events, dt, duration, [&](const Sample& s) { out.push_back(s); });
  return out;
}

TEST(Replay, SamplesLieOnTheGridFromZeroToTheEnd) {
  const auto samples = run({}, 1e-5, 1e-3);
  ASSERT_EQ(samples.size(), 101u);
  for (int n = 0; n <= 100; ++n) EXPECT_DOUBLE_EQ(samples[n].time, n * 1e-5);
}

TEST(Replay, NoDurationIsOneSample) { EXPECT_EQ(run({}, 1e-5, 0).size(), 1u); }

TEST(Replay, EqualsThePlantDrivenByHand) {
  const Gates first = {.uh = true, .vl = true}, second = {.vl = true};
  const auto samples =
      run({{0, first, 0}, {33e-6, second, 1e-3}}, 1e-5, 1e-4, {.angle = 0.26, .speed = 100});
  Plant plant({}, {.angle = 0.26, .speed = 100});
  plant.set_gates(first);
  plant.advance_to(33e-6);
  plant.set_gates(second);
  plant.set_load_torque(1e-3);
  plant.advance_to(samples.back().time);
  const State s = plant.state();
  EXPECT_EQ(samples.back().iu, s.current[0]);
  EXPECT_EQ(samples.back().vw, s.voltage[2]);
  EXPECT_EQ(samples.back().speed_rad_s, s.speed);
  EXPECT_EQ(samples.back().angle_rad, s.angle);
}

TEST(Replay, ASampleOnAnEventShowsTheCircuitAfterIt) {
  const auto samples = run({{2e-5, {.uh = true, .vl = true}, 0}}, 1e-5, 3e-5);
  EXPECT_LT(samples[1].vu, 1);
  EXPECT_DOUBLE_EQ(samples[2].vu, 24);
}

// From what is sampled alone: what enters at the terminals is heat, work on the shaft, or stored in the windings. A trapezoid
// over a step in which a voltage jumps is wrong by half of the jump's power at most.
TEST(Replay, EnergyBalancesFromTheSamplesAlone) {
  const Parameters p;
  const double dt = 2e-8;
  const std::vector<GateEvent> events = {
      {0, {.uh = true, .vl = true}, 0}, {100e-6, {.vl = true}, 0}, {130e-6, {.uh = true, .wl = true}, 0}, {250e-6, {}, 0}};
  const auto samples = run(events, dt, 400e-6, {.angle = 0.26, .speed = 200});
  const auto terminal = [](const Sample& s) { return s.vu * s.iu + s.vv * s.iv + s.vw * s.iw; };
  const auto squares = [](const Sample& s) { return s.iu * s.iu + s.iv * s.iv + s.iw * s.iw; };
  double in = 0, heat = 0, work = 0, doubt = 0, from_source = 0, in_bus = 0;
  for (std::size_t n = 1; n < samples.size(); ++n) {
    const Sample &a = samples[n - 1], &b = samples[n];
    in += dt / 2 * (terminal(a) + terminal(b));
    heat += dt / 2 * p.motor.resistance * (squares(a) + squares(b));
    work += dt / 2 * (a.torque_nm * a.speed_rad_s + b.torque_nm * b.speed_rad_s);
    from_source += dt / 2 * p.bus.voltage * (a.source_a + b.source_a);
    in_bus += dt / 2 * p.bus.resistance * (a.source_a * a.source_a + b.source_a * b.source_a);
    if (std::abs(terminal(a) - terminal(b)) > 1) doubt += dt / 2 * std::abs(terminal(a) - terminal(b));
  }
  const double stored = (p.motor.inductance - p.motor.mutual) / 2 * (squares(samples.back()) - squares(samples.front()));
  EXPECT_GT(in, 5e-3);
  EXPECT_LT(doubt, 2e-3 * in);
  EXPECT_NEAR(in, heat + work + stored, doubt + 1e-6 * in);
  const auto at_bus = [&p](const Sample& s) { return p.bus.capacitance / 2 * s.bus_v * s.bus_v; };
  const double bridge = from_source - in_bus - (at_bus(samples.back()) - at_bus(samples.front())) - in;
  EXPECT_GT(bridge, 0) << "what switches and diodes turn into heat";
  EXPECT_LT(bridge, 0.1 * in);
}

TEST(Replay, EventsOutOfOrderAndAnEmptyGridAreRefused) {
  EXPECT_THROW(run({{2e-5, {}, 0}, {1e-5, {}, 0}}, 1e-5, 1e-3), std::invalid_argument);
  EXPECT_THROW(run({{-1e-5, {}, 0}}, 1e-5, 1e-3), std::invalid_argument);
  EXPECT_THROW(run({}, 0, 1e-3), std::invalid_argument);
  EXPECT_THROW(run({}, 1e-5, -1), std::invalid_argument);
}

}  // namespace
}  // namespace steplock::plant
