// The loop filter's machine against its law, bit for bit: every loop, random words and corners, state kept.
#include "hls/six_step/loop_filter_law.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "model/reference/phase_locked_loop.hpp"
#include "tests/hls/random_config.hpp"

namespace steplock {
namespace {

using In = LoopFilter::In;

constexpr Loop kLoops[] = {Loop::kRamp, Loop::kTrack, Loop::kCatchSpin, Loop::kHall, Loop::kFollow};

class Config : public RandomConfig {
 public:
  using RandomConfig::RandomConfig;

  PhaseError error() {
    constexpr int kCorners[] = {0, 1, -1, 0x3fff, 0x4000, 0x4001, -0x3fff, -0x4000, -0x4001, 0xffff, -0x10000};
    if (one_in(4)) return PhaseError(kCorners[below(std::size(kCorners))]);
    return wrap<PhaseError>(Int<18>(static_cast<int>(below(0x20000)) - 0x10000) >> static_cast<int>(below(16)));
  }
  In in(Loop loop) {
    In in{.loop = loop, .error = error()};
    in.ramp = word<20>();
    in.backoff = word<2>();
    in.bandwidth = one_in(2) ? Bandwidth::kPerStep : Bandwidth::kPerSecond;
    in.delay = word<10>();
    in.ki = word<16>(), in.kp = word<16>();
    in.alpha = wrap<UInt<16>>(UInt<17>(below(0x8001)));
    in.scale = word<26>();
    in.minimum = word<26>(), in.maximum = word<26>();
    in.hand_over = word<26>(), in.stall = word<26>();
    return in;
  }
  Loop loop() { return kLoops[below(std::size(kLoops))]; }

};

struct Seen {
  Frequency frequency;
  bool fast, slow;
  bool operator==(const Seen&) const = default;
};

// One update of the machine, worked on to its end.
Seen update(LoopFilter& dut, In in) {
  dut.tick(in);  // a new `loop` counts from the next clock on
  in.update = in.tick = true;
  dut.tick(in);
  in.update = in.tick = false;
  LoopFilter::Out out;
  for (int clocks = 0; (out = dut.tick(in)).busy; ++clocks) EXPECT_LT(clocks, 200);
  const LoopFilter::Out later = dut.tick(in);
  EXPECT_EQ(out.fast, later.fast) << "in the result's first clock";
  return {later.frequency, later.fast, later.slow};
}

Seen seen(const LoopFilterLaw& law) { return {law.frequency(), law.fast, law.slow}; }

// Updates in which machine and law differ, of so many; now and then the loop changes, and the words, and it stops.
int differences(Config config, int updates, const std::function<void(In&)>& spoil = [](In&) {}) {
  LoopFilter dut;
  LoopFilterLaw law;
  Loop loop = Loop::kRamp;
  In in = config.in(loop);
  int differ = 0;
  for (int k = 0; k < updates; ++k) {
    if (config.one_in(40)) {
      dut.tick({.loop = Loop::kStop});
      dut.tick({.loop = Loop::kStop});
      law.stop();
    }
    if (config.one_in(8)) in = config.in(loop = config.loop());
    in.error = config.error();
    In other = in;
    spoil(other);
    law.update(other);
    differ += update(dut, in) != seen(law);
  }
  return differ;
}

TEST(LoopFilterLaw, IsWhatTheMachineDoes) {
  for (std::uint32_t seed = 1; seed <= 20; ++seed) ASSERT_EQ(differences(Config(seed), 3000), 0) << seed;
}

// The comparison sees a last bit of each word, and Hall sensors' smoothing at its very edge.
TEST(LoopFilterLaw, ADifferenceOfOneBitIsFound) {
  const auto found = [](const std::function<void(In&)>& spoil) { return differences(Config(7), 20000, spoil) > 0; };
  EXPECT_TRUE(found([](In& in) { in.error = wrap<PhaseError>(in.error ^ PhaseError(1)); }));
  EXPECT_TRUE(found([](In& in) { in.ki = in.ki ^ UInt<16>(1); }));
  EXPECT_TRUE(found([](In& in) { in.kp = in.kp ^ UInt<16>(1); }));
  EXPECT_TRUE(found([](In& in) { in.alpha = in.alpha ^ UInt<16>(2); }));
  EXPECT_TRUE(found([](In& in) { in.delay = in.delay ^ UInt<10>(1); }));
  EXPECT_TRUE(found([](In& in) { in.stall = in.stall ^ Frequency(1); }));
  EXPECT_TRUE(found([](In& in) { in.hand_over = in.hand_over ^ Frequency(1); }));
  EXPECT_TRUE(found([](In& in) { in.minimum = in.minimum ^ Frequency(1); }));
  EXPECT_TRUE(found([](In& in) { in.maximum = in.maximum ^ Frequency(1); }));
  EXPECT_TRUE(found([](In& in) { if (in.error == -0x4000) in.error = -0x4001; }));
  EXPECT_TRUE(found([](In& in) { if (in.error == 0x4000) in.error = 0x3fff; }));
}

// Law by law, what a reader computes by hand: with f = 2^-8 turns per clock and e = 1/16 turn, e f is 2^-12.
TEST(LoopFilterLaw, IsItsEquations) {
  constexpr int kF = 1 << 24;  // u0.32
  LoopFilterLaw at;
  at.x = Int<34>(kF) << 4;
  at.y = UInt<30>(kF) << 4;
  at.fresh = false;
  const auto moved = [&](In in) {
    LoopFilterLaw law = at;
    in.error = 0x1000;
    in.maximum = Frequency::max();
    law.update(in);
    return static_cast<int>(law.frequency().raw()) - kF;
  };
  EXPECT_EQ(moved({.loop = Loop::kCatchSpin}), 1 << 20) << "Newton";
  EXPECT_EQ(moved({.loop = Loop::kHall}), 1 << 18) << "a quarter of it";
  EXPECT_EQ(moved({.loop = Loop::kTrack, .ki = 0x2000, .alpha = 0x8000}), 1 << 19) << "ki = 1/2";
  EXPECT_EQ(moved({.loop = Loop::kTrack, .kp = 0x4000, .alpha = 0x4000}), 1 << 19) << "kp = 1, half of it by the pole";
  EXPECT_EQ(moved({.loop = Loop::kTrack, .delay = 16, .ki = 0x4000, .alpha = 0x8000}), 1 << 21) << "16 f are 1/16 turn more";
  EXPECT_EQ(moved({.loop = Loop::kTrack, .bandwidth = Bandwidth::kPerSecond, .ki = 0x4000, .alpha = 0x8000, .scale = kF / 4}), 1 << 18);
  EXPECT_EQ(moved({.loop = Loop::kRamp, .ramp = 1000}), 1000) << "1/16 of a turn stands for the ramp";
}

// The reference in doubles beside the law, in turns per clock; the law may be away from it by what its truncations can have made by then:
// a product drops less than one last place, the frequency that gains a product has 28 bits.  The times that it is further away.
int beyond_truncations(
    Config config, int updates,
    const std::function<void(design::LoopParameters&)>& spoil = [](design::LoopParameters&) {}) {
  constexpr double kPlace = 0x1p-36, kError = 0x1p-22, kGained = 0x1p-28;
  int beyond = 0;
  for (int run = 0; run < updates / 50; ++run) {
    In in{.loop = Loop::kTrack, .delay = config.below(64), .ki = 600 + config.below(4000), .kp = 6000 + config.below(14000)};
    in.alpha = 2 * (0x1000 + config.below(0x3001)), in.minimum = 1, in.maximum = Frequency::max();
    const double ki = std::ldexp(double(in.ki.raw()), -14), kp = std::ldexp(double(in.kp.raw()), -14);
    const double pole = std::ldexp(double(in.alpha.raw()), -15), delay = double(in.delay.raw());
    design::LoopParameters p{.delay = delay, .integral = ki, .proportional = kp, .pole = pole, .minimum = 0, .maximum = 1};
    spoil(p);
    reference::LoopFilter filter(p);
    LoopFilterLaw law;
    law.y = UInt<30>::of((1u << 22) + config.below(1u << 26));
    law.x = law.y;
    const auto value = [](auto x) { return std::ldexp(double(x.raw()), -36); };
    filter.load(value(law.y));
    double of_x = 0, of_y = 0;  // how far the law may be away
    for (int k = 0; k < 50; ++k) {
      const double f = filter.frequency();
      in.error = PhaseError(int(config.below(4000)) - 2000 - int(65536 * delay * f));
      const double e = std::ldexp(double(in.error.raw()), -16) + delay * f;
      law.update(in);
      filter.step(std::ldexp(double(in.error.raw()), -16));
      const double of_e = of_y * delay + kError, of_s = of_y + kGained;
      const double of_p = std::abs(e) * of_s + f * of_e + of_e * of_s + kPlace;
      of_x += ki * of_p + kPlace;
      of_y = pole * (of_x + kp * of_p + kPlace) + (1 - pole) * of_y + 2 * kPlace;
      EXPECT_FALSE(law.at_bottom || law.at_top);
      beyond += std::abs(value(law.y) - filter.frequency()) > of_y;
    }
  }
  return beyond;
}

TEST(LoopFilterLaw, EqualsTheReferenceWithinItsTruncations) {
  EXPECT_EQ(beyond_truncations(Config(5), 20000), 0);
  // A last bit of a coefficient is more.
  EXPECT_GT(beyond_truncations(Config(5), 20000, [](design::LoopParameters& p) { p.proportional += 0x1p-14; }), 0);
  EXPECT_GT(beyond_truncations(Config(5), 20000, [](design::LoopParameters& p) { p.integral += 0x1p-14; }), 0);
  EXPECT_GT(beyond_truncations(Config(5), 20000, [](design::LoopParameters& p) { p.pole -= 0x1p-14; }), 0);
  EXPECT_GT(beyond_truncations(Config(5), 20000, [](design::LoopParameters& p) { p.delay += 1; }), 0);
}

}  // namespace
}  // namespace steplock
