// Pilot pulses on a motor of two admittances, without resistance: the angle all round, the order
// and the waits of the pulses, and what cannot be told.

#include "hls/sinusoidal/pilot_pulses.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

namespace steplock {
namespace {

using Vector = std::complex<double>;
using R = SinusoidalReason;
constexpr double kPi = std::numbers::pi;

double wrapped(double x) { return std::remainder(x, 2 * kPi); }

struct Rotor {
  double theta = 0;           // rad, N pole
  double mean = 0.03;         // full scales per period of a pulse
  double swing = 0.17;        // of the mean, (22)
  double iron = 0.1;          // more current per period and current along the magnet
  int decay = 1;              // periods
};

class Bench {
 public:
  explicit Bench(const Rotor& r) : rotor(r) {}

  Rotor rotor;
  PilotPulses::In in{.enable = true,
                     .config = {.short_periods = 3, .long_periods = 12, .rounds = 4,
                               .decayed = 150, .saliency = 1000, .polarity = 470}};
  PilotPulses::Out out;
  std::vector<int> pulses;    // legs that were high, u v w as bits 0 1 2
  std::vector<int> lengths;   // periods
  std::vector<double> gaps;   // currents from which each pulse began
  bool lose = false;          // this period's sample

  // A PWM period of eight clocks: the sample at its start, taken in clock 2, worked through in 6.
  void period() {
    move();
    const Vector held = current_;
    for (int clock = 0; clock < 8; ++clock) {
      in.period = clock == 0;
      in.taken = clock == 2 && !lose;
      in.sampled = clock == 6 && !lose;
      const Vector sums(part(out.a), (part(out.a) + 2 * part(out.b)) / kRoot3);
      const Vector i = out.search ? sums : held;
      const Vector seen = i * std::polar(1.0, -2 * kPi * double(out.angle.raw()) / (1 << 24));
      in.i_gamma = saturate<Int<16>>(Int<32>(std::lround(seen.real() * 32768)));
      in.backward = seen.imag() < 0;
      const double limit = out.waiting ? part(in.config.decayed) : 0.9;
      in.over = false;
      for (int k = 0; k < 3; ++k) in.over = in.over || std::abs(along(held, 120 * k)) > limit;
      out = dut_.tick(in);
    }
  }
  bool over_with() const { return out.found || out.failed != R::kNone; }
  Bench& run(int most = 2000) {
    for (int n = 0; n < most && !over_with(); ++n) period();
    return *this;
  }
  double found() const { return 2 * kPi * double(out.angle.raw()) / (1 << 24); }

 private:
  static constexpr double kRoot3 = std::numbers::sqrt3;
  template <class T>
  static double part(T x) { return double(x.raw()) / 32768; }
  static double along(Vector i, double degrees) {
    return (i * std::polar(1.0, -degrees * kPi / 180)).real();
  }

  // What the legs did in the period that ends.
  void move() {
    const int legs = int(out.high_u) | int(out.high_v) << 1 | int(out.high_w) << 2;
    if (!out.pulse) {
      if (on_ != 0) left_ = rotor.decay;
      on_ = 0;
      current_ = left_-- > 0 ? current_ * 0.3 : Vector();
      return;
    }
    if (on_ == 0) {
      pulses.push_back(legs);
      lengths.push_back(0);
      gaps.push_back(std::abs(current_));
    }
    lengths.back() = ++on_;
    const bool reversed = legs == 3 || legs == 5 || legs == 6;
    const int winding = (legs == 1 || legs == 6) ? 0 : (legs == 2 || legs == 5) ? 1 : 2;
    const double a = 2 * kPi / 3 * winding + (reversed ? kPi : 0);
    const double towards = on_ * rotor.mean * std::cos(a - rotor.theta);
    const Vector across = std::polar(rotor.swing, 2 * rotor.theta - a);
    current_ = on_ * rotor.mean * (std::polar(1.0, a) + across) +
               std::polar(rotor.iron * towards * towards, rotor.theta);
  }

  PilotPulses dut_;
  Vector current_;
  int on_ = 0, left_ = 0;
};

// One step of the angle is 0.044 degrees, cut and not rounded; half a place of each of 12 peaks in
// a sum of 6000 is 0.03.
TEST(PilotPulses, TheAngleIsFoundAllRoundWithItsPolarity) {
  for (int n = 0; n < 128; ++n) {
    const double theta = wrapped(n * kPi / 64 + 0.001);
    Bench b({.theta = theta});
    ASSERT_TRUE(b.run().out.found) << n;
    EXPECT_NEAR(wrapped(b.found() - theta) * 180 / kPi, -0.02, 0.08) << n;
  }
}

TEST(PilotPulses, EveryWindingIsPulsedBothWaysAndTheNearestOneForPolarity) {
  Bench b({.theta = 110 * kPi / 180});
  b.run();
  std::vector<int> wanted;
  for (int round = 0; round < 4; ++round) {
    for (const int legs : {1, 6, 2, 5, 4, 3}) wanted.push_back(legs);
  }
  wanted.insert(wanted.end(), {2, 5});  // v, 10 degrees away
  EXPECT_EQ(b.pulses, wanted);
  for (std::size_t n = 0; n < b.lengths.size(); ++n) {
    EXPECT_EQ(b.lengths[n], n < 24 ? 3 : 12) << n;
  }
}

TEST(PilotPulses, ThePulseForPolarityLiesWithin34Degrees) {
  for (int degrees = 0; degrees < 360; ++degrees) {
    Bench b({.theta = degrees * kPi / 180});
    b.run();
    ASSERT_EQ(b.pulses.size(), 26u);
    const int legs = b.pulses[24];
    const double direction[] = {0, 0, 120, 60, 240, 300, 180};
    const double off = std::abs(std::remainder(degrees - direction[legs], 180));
    EXPECT_LE(off, 34) << degrees;
  }
}

TEST(PilotPulses, EachPulseWaitsUntilTheCurrentOfTheLastIsGone) {
  for (const int decay : {0, 1, 4, 9}) {
    Bench b({.theta = 1, .decay = decay});
    ASSERT_TRUE(b.run().out.found) << decay;
    // Below it in every phase; a vector is longer than its phases by 15 % at most.
    for (const double i : b.gaps) EXPECT_LT(i, 1.16 * 150 / 32768) << decay;
  }
  Bench never({.theta = 1, .decay = 10'000});
  never.in.config.decayed = 0;
  for (int n = 0; n < 40; ++n) never.period();
  EXPECT_EQ(never.pulses.size(), 1u);
  EXPECT_FALSE(never.over_with());
}

TEST(PilotPulses, WhatCannotBeToldIsSaidAndNotGuessed) {
  EXPECT_EQ(Bench({.theta = 1, .swing = 0}).run().out.failed, R::kNoSaliency);
  const Bench blind = Bench({.theta = 1, .iron = 0}).run();
  EXPECT_EQ(blind.out.failed, R::kNoPolarity);
  EXPECT_FALSE(blind.out.found);
  EXPECT_EQ(Bench({.theta = 1}).run().out.failed, R::kNone);
}

// The word is what 4 rounds give at 0.0275 of saliency: 12 peaks of 0.09.
TEST(PilotPulses, TheThresholdOfSaliencyIsThatOfItsWord) {
  const double at = 1000.0 / 32768 / (12 * 0.09);
  EXPECT_EQ(Bench({.theta = 2, .swing = 0.98 * at}).run().out.failed, R::kNoSaliency);
  EXPECT_TRUE(Bench({.theta = 2, .swing = 1.02 * at}).run().out.found);
}

TEST(PilotPulses, APeakWhoseSampleIsLostEndsTheSearch) {
  Bench b({.theta = 1});
  while (b.lengths.empty() || b.lengths.back() < 2) b.period();
  b.lose = true;
  b.period();
  b.lose = false;
  b.run();
  EXPECT_EQ(b.out.failed, R::kLostSample);
  const auto pulses = b.pulses.size();
  for (int n = 0; n < 50; ++n) b.period();
  EXPECT_EQ(b.pulses.size(), pulses) << "and no more pulses";
}

TEST(PilotPulses, WithoutEnableThereIsNothing) {
  Bench b({.theta = 1});
  b.in.enable = false;
  for (int n = 0; n < 50; ++n) {
    b.period();
    ASSERT_FALSE(b.out.pulse || b.out.waiting || b.out.search || b.out.found);
    ASSERT_EQ(b.out.angle, Angle(0));
  }
}

TEST(PilotPulses, ARestBeginsItAnew) {
  Bench b({.theta = 1});
  ASSERT_TRUE(b.run().out.found);
  b.in.rest = true;
  b.period();
  EXPECT_EQ(b.out.angle, Angle(0));
  b.in.rest = false;
  b.rotor.theta = -2;
  ASSERT_TRUE(b.run().out.found);
  EXPECT_NEAR(wrapped(b.found() + 2) * 180 / kPi, -0.02, 0.08);
}

}  // namespace
}  // namespace steplock
