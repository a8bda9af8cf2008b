// Against three modulators on the block's own clock: levels, the instant that the codes are of, their time, and
// noise.

#include "hls/sinusoidal/sigma_delta.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <deque>
#include <functional>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include "tests/hls/modulator.hpp"

namespace steplock {
namespace {

constexpr int kM = 64;
constexpr int kHalf = 2;
constexpr int kBit = 2 * kHalf;  // clocks

struct Bench {
  std::function<double(double clock)> u = [](double) { return 0.0; };
  std::function<double(double clock)> v = u, dc = u;
  int delay = 1;  // clocks from a rising edge of mclk to the bits

  SigmaDelta<>::Out tick(bool sample = false) {
    in.sample = sample;
    const auto out = dut.tick(in);
    if (out.mclk && !mclk_) {
      const double now = double(clock);
      line_.push_back({clock + delay, {.u = u_.bit(u(now)), .v = v_.bit(v(now)), .dc = dc_.bit(dc(now))}});
    }
    mclk_ = out.mclk;
    while (!line_.empty() && line_.front().first <= clock) {
      in.data = line_.front().second;
      line_.pop_front();
    }
    ++clock;
    missed += out.missed;
    return out;
  }

  double noise() const { return u_.noise(); }

  SigmaDelta<> dut;
  SigmaDelta<>::In in{.sample = false, .data = {}, .config = {.half = kHalf}};
  long clock = 0;
  int missed = 0;

 private:
  Modulator u_{2, 1}, v_{2, 2}, dc_{2, 3};
  bool mclk_ = false;
  std::deque<std::pair<long, SigmaDelta<>::Streams>> line_;
};

struct Sampled {
  CurrentSense::Codes codes;
  long strobe = 0, valid = 0;  // clocks
};

// Strobes every `period` clocks; the codes in order, each with the last strobe before its window.
std::vector<Sampled> sampled(Bench& b, int period, int strobes) {
  std::vector<Sampled> all;
  std::deque<long> waiting;
  for (int k = 0; k < strobes; ++k) {
    for (int clock = 0; clock < period; ++clock) {
      if (clock == 0) waiting.push_back(b.clock);
      const long now = b.clock;
      const auto out = b.tick(clock == 0);
      if (out.codes.valid) {
        all.push_back({out.codes, waiting.front(), now});
        waiting.pop_front();
      }
    }
  }
  return all;
}

// One place of the codes: 2^-11 of rounding, and noise of 2^-14.5 rms.
TEST(SigmaDelta, LevelsBecomeCodes) {
  Bench b;
  for (const double level : {-0.8, -0.25, 0.0, 0.5, 0.8}) {
    b.u = [=](double) { return level; };
    b.v = [=](double) { return -level / 2; };
    b.dc = [=](double) { return level; };
    for (const Sampled& s : sampled(b, 1000, 4)) {
      if (s.strobe < b.clock - 3500) continue;  // of the level before
      EXPECT_NEAR(double(s.codes.u.raw()), level * 2048, 1.01);
      EXPECT_NEAR(double(s.codes.v.raw()), -level * 1024, 1.01);
      EXPECT_NEAR(double(s.codes.dc.raw()), std::max(0.0, level * 4096), 2.01);
    }
  }
  EXPECT_EQ(b.missed, 0);
}

// To the nearest code: over levels anywhere between two codes the mean error is none, but for that of so many roundings (uniform, a
// deviation of 1/sqrt 12) and of the modulator's noise, which is less.  Half a code would be cut.
TEST(SigmaDelta, CodesAreRoundedToTheNearest) {
  constexpr int kWindows = 600;
  Bench b;
  std::mt19937 any(5);
  double off_u = 0, off_dc = 0;
  for (int k = 0; k < kWindows; ++k) {
    const double level = std::uniform_real_distribution<>(0.1, 0.8)(any);
    b.u = b.dc = [=](double) { return level; };
    const auto codes = sampled(b, 1000, 2).back().codes;  // the first window has bits of the level before
    off_u += double(codes.u.raw()) - level * 2048;
    off_dc += double(codes.dc.raw()) - level * 4096;
  }
  const double most = 6 / std::sqrt(12.0 * kWindows);
  EXPECT_NEAR(off_u / kWindows, 0, most);
  EXPECT_NEAR(off_dc / kWindows, 0, 2 * most) << "whose noise is that of twice as many codes";
}

TEST(SigmaDelta, AStandingLineIsTheEndOfTheRange) {
  for (const bool level : {false, true}) {
    SigmaDelta<> dut;
    SigmaDelta<>::In in{.sample = true, .data = {level, level, level}, .config = {.half = 1}};
    SigmaDelta<>::Out out;
    for (int clock = 0; clock < 1000 && !out.codes.valid; ++clock, in.sample = false) out = dut.tick(in);
    EXPECT_EQ(out.codes.u, level ? 2047 : -2048);
    EXPECT_EQ(out.codes.dc, level ? 4095 : 0);
  }
}

// On a ramp the code tells its instant.  A bit is of the edge that made it; the ideal modulator of this test
// answers with the input of that edge.
void expect_instant(int delay_bits, int period, double stated_bits) {
  Bench b;
  const double slope = 1.6 / (12.0 * period);
  b.u = [=](double clock) { return -0.8 + slope * clock; };
  b.in.config.delay = delay_bits;
  int seen = 0;
  for (const Sampled& s : sampled(b, period, 12)) {
    const double instant = (double(s.codes.u.raw()) / 2048 + 0.8) / slope;
    // A bit for the strobe's place between edges, one before it for the line; half a code of rounding.
    const double rounding = 1.0 / 2048 / slope;
    EXPECT_NEAR(instant, double(s.strobe) + kBit * stated_bits, 1.5 * kBit + rounding);
    EXPECT_LE(s.valid - s.strobe, kBit * (delay_bits + 3 * kM + 1) + 5);
    EXPECT_GE(s.valid - s.strobe, kBit * (delay_bits + 3 * kM - 1));
    ++seen;
  }
  EXPECT_GE(seen, 10);
  EXPECT_EQ(b.missed, 0);
}
TEST(SigmaDelta, TheCodesAreOfTheMiddleOfTheWindow) {
  constexpr double kMiddle = (3 * kM - 3) / 2.0;
  expect_instant(0, 1000, kMiddle);
  expect_instant(100, 2000, 100 + kMiddle);
}
TEST(SigmaDelta, WithTheRightDelayTheyAreOfTheNextStrobe) {
  constexpr int period = 2501;
  expect_instant(period / kBit - (3 * kM - 3) / 2, period, double(period) / kBit);
}

// 13 places of noise become 12 by rounding: 2^-22 / 12 of it, beside the modulator's.
TEST(SigmaDelta, ASineIsSeenAsWellAsTwelveBitsCan) {
  Bench b;
  constexpr int period = 1000;
  constexpr double turns = 0.0115;  // per strobe; 23 in all
  b.u = [](double clock) { return 0.5 * std::sin(2 * M_PI * turns * clock / period); };
  std::vector<double> samples;
  for (const Sampled& s : sampled(b, period, 2000)) samples.push_back(double(s.codes.u.raw()) / 2048);
  const double noise = std::pow(2, -22) / 12 + 6 * b.noise() / std::pow(kM, 5);
  EXPECT_NEAR(snr_db(samples, turns), 10 * std::log10(0.125 / noise), 1.5);
}

TEST(SigmaDelta, ALineAsLateAsAPeriodIsReadAndALaterOneIsOfTheNextBit) {
  for (int delay = 0; delay < kBit; ++delay) {
    Bench b;
    b.delay = delay;
    b.u = [](double) { return 0.5; };
    EXPECT_NEAR(double(sampled(b, 1000, 3).back().codes.u.raw()), 1024, 1.01);
  }
}

TEST(SigmaDelta, APeriodShorterThanTheWindowGivesNoCodesAndSaysSo) {
  Bench b;
  EXPECT_TRUE(sampled(b, kBit * 3 * kM - kBit, 5).empty());
  EXPECT_GE(b.missed, 3);
  Bench late;
  late.in.config.delay = 300;
  EXPECT_TRUE(sampled(late, kBit * 200, 5).empty());
  EXPECT_GE(late.missed, 3);
}

TEST(SigmaDelta, OffMovesNoPin) {
  Bench b;
  b.in.config.half = 0;
  EXPECT_TRUE(sampled(b, 1000, 3).empty());
  EXPECT_FALSE(b.tick().mclk);
}

}  // namespace
}  // namespace steplock
