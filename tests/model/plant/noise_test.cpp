// Noise of the comparators: its numbers, and the comparators that see it, held to their law sample by sample.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "model/plant/sensors.hpp"
#include "tests/model/plant/coasting.hpp"

namespace steplock::plant {
namespace {

// SplitMix64 from seed 0 gives 0xE220A8397B1DCDAF and then 0x6E789E6AA1B965F4, as is known of it (Steele, Lea and Flood 2014).
// The first is the stream of seed 0 and source 0; cells are chosen here so that it is scrambled to either of the two.
TEST(Noise, GaussianIsBoxAndMullersOfSplitMix64) {
  const std::uint64_t first = 0xE220A8397B1DCDAFu, second = 0x6E789E6AA1B965F4u;
  const auto normal = [](std::uint64_t bits) {
    const double radius = std::ldexp(double(bits >> 32) + 1, -32), angle = std::ldexp(double(bits & 0xFFFFFFFFu), -32);
    return std::sqrt(-2 * std::log(radius)) * std::cos(2 * std::numbers::pi * angle);
  };
  EXPECT_DOUBLE_EQ(Sensors::gaussian(0, 0, std::int64_t(first)), normal(first));
  EXPECT_DOUBLE_EQ(Sensors::gaussian(0, 0, std::int64_t(first ^ 0x9E3779B97F4A7C15u)), normal(second));
  EXPECT_EQ(Sensors::gaussian(1, 0, 7), Sensors::gaussian(0, 8, 7)) << "eight sources a seed";
  EXPECT_EQ(Sensors::gaussian(3, 2, 7), Sensors::gaussian(0, 26, 7));
}

TEST(Noise, GaussianHasItsMomentsAndIsAFunctionOfItsArguments) {
  const int n = 200000;
  double sum = 0, square = 0, fourth = 0, product = 0, last = 0;
  for (int k = 0; k < n; ++k) {
    const double x = Sensors::gaussian(1, 0, k);
    sum += x;
    square += x * x;
    fourth += x * x * x * x;
    product += x * last;
    last = x;
  }
  // Five standard errors of each estimate.
  EXPECT_NEAR(sum / n, 0, 5 / std::sqrt(n));
  EXPECT_NEAR(square / n, 1, 5 * std::sqrt(2.0 / n));
  EXPECT_NEAR(fourth / n, 3, 5 * std::sqrt(96.0 / n));
  EXPECT_NEAR(product / n, 0, 5 / std::sqrt(n));
  EXPECT_NE(Sensors::gaussian(1, 0, 7), Sensors::gaussian(2, 0, 7));
  EXPECT_NE(Sensors::gaussian(1, 0, 7), Sensors::gaussian(1, 1, 7));
  EXPECT_EQ(Sensors::gaussian(1, 2, -7), Sensors::gaussian(1, 2, -7));
}

struct Level {
  double time;
  bool high;
};

struct Scene {
  Parameters p;
  InitialState initial;
  std::vector<std::pair<double, Gates>> gates;  // from when on
  double until;
};

void switch_gates(const Scene& scene, Plant& plant, std::size_t& next, double until) {
  for (; next < scene.gates.size() && scene.gates[next].first <= until; ++next) {
    plant.advance_to(scene.gates[next].first);
    plant.set_gates(scene.gates[next].second);
  }
}

// When comparator v's pin changes.
std::vector<Level> as_simulated(const Scene& scene) {
  Plant plant(scene.p, scene.initial);
  std::vector<Level> out;
  bool level = plant.pins().comparator[1];
  std::size_t next = 0;
  while (plant.time() < scene.until) {
    const double gates = next < scene.gates.size() ? scene.gates[next].first : scene.until;
    plant.advance_to(std::min({plant.next_event(), gates, scene.until}));
    switch_gates(scene, plant, next, plant.time());
    if (plant.pins().comparator[1] != level) out.push_back({plant.time(), level = !level});
  }
  return out;
}

// And by the law: its input, and the noise of the interval, every 20 ns of the plant's own voltages.
constexpr double kLook = 20e-9;
std::vector<Level> by_law(const Scene& scene) {
  const Comparator& c = scene.p.sensing.comparator[1];
  Plant plant(scene.p, scene.initial);
  std::vector<Level> out;
  bool level = plant.pins().comparator[1];
  std::size_t next = 0;
  for (int n = 0; (n + 0.5) * kLook < scene.until; ++n) {
    const double t = (n + 0.5) * kLook;
    switch_gates(scene, plant, next, t);
    plant.advance_to(t);
    const State s = plant.state();
    const double noise = c.noise * Sensors::gaussian(scene.p.sensing.seed, 1, std::int64_t(std::floor(t / c.noise_interval)));
    const bool half = scene.p.sensing.reference == Sensing::Reference::kHalfBus;
    const double input = s.voltage[1] - (half ? s.bus_voltage / 2 : s.virtual_neutral) + noise;
    if ((input > c.offset + (level ? -c.hysteresis : c.hysteresis) / 2) != level) out.push_back({t, level = !level});
  }
  return out;
}

// `doubt`: s, how far a crossing within an interval may lie from where the parabola and its chord have it.
void expect_same(const Scene& scene, double doubt, std::size_t least) {
  const auto is = as_simulated(scene), law = by_law(scene);
  EXPECT_GE(law.size(), least);
  ASSERT_EQ(is.size(), law.size());
  for (std::size_t n = 0; n < is.size(); ++n) {
    EXPECT_NEAR(is[n].time, law[n].time - kLook / 2, kLook / 2 + doubt) << n << " at " << law[n].time;
    EXPECT_EQ(is[n].high, law[n].high) << n;
  }
}

// 7.9 V at 200 turns a second. At its flank's foot the sine is straight; at half of its height it bends by
// 4 V (1257 / s)^2 = 6.3e6 V/s^2 and rises at 8600 V/s: the chord of 5 us is 20 uV off or 2.3 ns, the parabola of 100 us,
// 7.2 degrees, 7.9 V * 0.063^3 / 15.6 = 0.13 mV or 15 ns; a chord in its place were 0.9 us off.
TEST(Noise, ComparatorsSwitchWhereTheirLawSays) {
  for (const double offset : {-0.4, 0.4, 4.0}) {
    for (int seed = 1; seed <= 4; ++seed) {
      for (const double noise : {0.05, 3.0}) {
        const double angle = (seed % 2 == 0 ? 258 : 80) + 1.7 * seed;  // falls, or rises
        const InitialState from = {.angle = angle * kDegree / 4, .speed = kSpeed3000};
        Scene scene = {.p = steady(), .initial = from, .gates = {}, .until = 1.499e-3};
        scene.p.sensing.seed = std::uint64_t(seed);
        scene.p.sensing.comparator[1] = {.offset = offset, .hysteresis = 0.02, .delay = 0, .noise = noise, .noise_interval = 5e-6};
        expect_same(scene, 18e-9, 1);
      }
    }
  }
}

// At rest without current the terminal jumps from one rail to the threshold at the other. 27 * 5 us is a time that, divided by 5 us, is
// less than 27: the interval that ends there has no say any more.
TEST(Noise, AnIntervalThatIsOverDecidesNothing) {
  ASSERT_LT(std::floor(27 * 5e-6 / 5e-6), 27);
  for (int seed = 1; seed <= 40; ++seed) {
    Scene scene = {.p = steady(), .initial = {}, .gates = {{0, {.wl = true}}, {27 * 5e-6, {.wh = true}}}, .until = 150e-6};
    scene.p.sensing.reference = Sensing::Reference::kHalfBus;
    scene.p.sensing.seed = std::uint64_t(seed);
    scene.p.sensing.comparator[1] = {.offset = 12, .hysteresis = 0.1, .delay = 0, .noise = 0.05, .noise_interval = 5e-6};
    expect_same(scene, 0, 0);
  }
}

// The input jumps between 12 V above and below its reference and what the back-EMF says.
TEST(Noise, ComparatorsFollowTheGatesThroughIt) {
  const Gates high = {.vh = true, .wl = true}, low = {.uh = true, .vl = true};
  for (int seed = 1; seed <= 8; ++seed) {
    Scene scene = {.p = steady(),
                   .initial = {.angle = 118 * kDegree / 4, .speed = kSpeed3000},
                   .gates = {{10e-6, high}, {20e-6, low}, {33e-6, {}}, {47e-6, low}, {47.5e-6, high}, {60e-6, {}}},
                   .until = 300e-6};
    scene.p.sensing.seed = std::uint64_t(seed);
    scene.p.sensing.comparator[1] = {.offset = 0.1, .hysteresis = 0.02, .delay = 0, .noise = 0.05, .noise_interval = 5e-6};
    expect_same(scene, 1e-9, 6);
  }
}

TEST(Noise, NoiseMakesTheOutputChatterAroundTheCrossingOnly) {
  Parameters p = steady();
  for (auto& c : p.sensing.comparator) c = {.hysteresis = 0.01, .delay = 0, .noise = 0.03};
  const auto edges = coast(p, {.angle = 40 * kDegree / 4, .speed = kSpeed3000 / 10}, 5e-3);
  const double emf_per_degree = 0.03966 * 20 * kDegree;
  int chatter = 0;
  for (const Edge& edge : edges) {
    const double degree = 40 + edge.time * 200 * 36;
    const double away = std::min(std::abs(std::remainder(degree, 60)),
                                 std::abs(std::remainder(degree - 30, 60)));  // a Hall's
    EXPECT_LT(away * emf_per_degree, 6.7 * 0.03 + 0.01) << degree;
    chatter += degree > 45 && degree < 75;
  }
  EXPECT_GT(chatter, 5);
}

TEST(Noise, HysteresisWiderThanTheNoiseGivesOneCleanEdge) {
  Parameters p = steady();
  p.sensing.comparator[2] = {.hysteresis = 0.2, .delay = 0, .noise = 0.01};  // 20 sigma
  const auto edges = coast(p, {.angle = 40 * kDegree / 4, .speed = kSpeed3000 / 10}, 5e-3);
  int changes = 0;  // w falls through 60 degrees; the run ends at 76
  for (std::size_t n = 0; n < edges.size(); ++n) {
    changes += edges[n].pins.comparator[2] != (n == 0 || edges[n - 1].pins.comparator[2]);
  }
  EXPECT_EQ(changes, 1);
}

TEST(Noise, NoiseDoesNotDependOnHowTheRunIsCut) {
  Parameters p = steady();
  p.accuracy.tolerance = 1e-10;
  for (auto& c : p.sensing.comparator) c = {.hysteresis = 0.01, .delay = 0, .noise = 0.03};
  const auto whole = coast(p, {.angle = 40 * kDegree / 4, .speed = kSpeed3000 / 10}, 5e-3);
  p.accuracy.max_step = 7.3e-6;
  const auto cut = coast(p, {.angle = 40 * kDegree / 4, .speed = kSpeed3000 / 10}, 5e-3);
  ASSERT_EQ(whole.size(), cut.size());
  for (std::size_t n = 0; n < cut.size(); ++n) {
    EXPECT_NEAR(whole[n].time, cut[n].time, 1e-9);
    EXPECT_EQ(whole[n].pins, cut[n].pins);
  }
}

}  // namespace
}  // namespace steplock::plant
