#include "model/plant/replay.hpp"

#include <gtest/gtest.h>

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

TEST(Replay, EventsOutOfOrderAndAnEmptyGridAreRefused) {
  EXPECT_THROW(run({{2e-5, {}, 0}, {1e-5, {}, 0}}, 1e-5, 1e-3), std::invalid_argument);
  EXPECT_THROW(run({{-1e-5, {}, 0}}, 1e-5, 1e-3), std::invalid_argument);
  EXPECT_THROW(run({}, 0, 1e-3), std::invalid_argument);
  EXPECT_THROW(run({}, 1e-5, -1), std::invalid_argument);
}

}  // namespace
}  // namespace steplock::plant
