// The speed regulator against its reference in doubles.  Full scales are 1 and a sample takes 1.

#include "hls/sinusoidal/speed_regulator.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "model/reference/sinusoidal/regulators.hpp"
#include "tests/hls/plain_integers.hpp"

namespace steplock {
namespace {

constexpr double kPlace = 1.0 / 32768;  // the last of s0.15

double value(Int<16> x) { return double(x.raw()) * kPlace; }
Int<20> step(double x) { return static_cast<int>(std::lround(std::ldexp(x, 19))); }

RegulatorConfig config() {
  return {.target = 1 << 22, .slew = 4000, .filter = 983, .k_p = 700, .k_i = 530, .limit = 12288,
          .start_current = 1000, .lock = 1000, .slow = 500, .stop = 1000, .emf_low = 3277, .emf_high = 20480};
}
// What the words mean; the filter's gain over one sample is 1 - exp(-filter).
design::sinusoidal::SpeedRegulator meant() {
  return {.slew = 4000 / std::ldexp(1, 25),
          .filter = -std::log1p(-983 * kPlace),
          .kp = 700 / 256.0,
          .ki = 530 / 131072.0,
          .limit = 12288 * kPlace,
          .start_current = 1000 * kPlace};
}

// The error's last place, 2^-19, times k_p is 0.2 places; cut thrice; the speed's state cuts 2^-27
// a sample, which its filter of 0.03 lets grow to 33 of them; over 3000 samples the integral's cut
// error (half of 2^-19 on the mean) adds up to 3000 ki / 2^20 = 0.4 places: less than 3 places in
// all.
TEST(SpeedRegulator, IsTheReferenceWithinItsRounding) {
  for (const bool reverse : {false, true}) {
    const double way = reverse ? -1 : 1;
    SpeedRegulator dut;
    reference::sinusoidal::SpeedRegulator exact(meant(), 1);
    dut.tick({.config = config()});
    exact.start(0);
    double speed = 0;
    std::mt19937 any(1);
    int saturated = 0;
    for (int n = 0; n < 3000; ++n) {
      // A rotor that follows the torque, with noise; it is braked from sample 2000 on.
      const double noise = std::uniform_real_distribution<>(-0.002, 0.002)(any);
      const auto seen = step(way * (speed + noise));
      const auto out =
          dut.tick({.enable = true, .reverse = reverse, .locked = n >= 400, .step = seen, .config = config()});
      const double wanted = exact.update(0.125, way * double(seen.raw()) / (1 << 19), n >= 400);
      ASSERT_NEAR(way * value(out.current), wanted, 3 * kPlace) << n;
      ASSERT_NEAR(way * value(out.speed), exact.speed(), 2 * kPlace) << n;
      ASSERT_NEAR(value(out.reference), exact.reference(), 2 * kPlace) << n;
      saturated += out.saturated;
      speed += 0.001 * (wanted - (n < 2000 ? 0.05 : 0.5));
    }
    EXPECT_GT(saturated, 100);
  }
}

// A step that goes from 20 places (2^-19) below the wanted one to 20 above, again and again, has its
// mean; smoothed, some places of it are left.  Cut instead of rounded, the error would be half a place less
// on the mean, and the integral would go by
// 82'000 k_i / 512 / 2 / 4096 = 10 places of s0.15.  The filter cuts as well: half of 2^-27 / 0.03, 0.07
// places of the error, 1.4 of the integral's.
TEST(SpeedRegulator, AnErrorOfZeroInTheMeanMovesNothing) {
  SpeedRegulator dut;
  SpeedRegulator::Out out;
  const int target = int(config().target.raw()) >> 6;  // in s0.19
  const auto turn = [&](int samples, bool settled) {
    for (int n = 0; n < samples; ++n) {
      const Int<20> seen = (settled ? target : std::min(n * 63, target)) + (n % 41 - 20);
      out = dut.tick({.enable = true, .locked = true, .step = seen, .config = config()});
    }
    return value(out.current);
  };
  const double before = turn(41 * 73, false);  // up the reference's ramp, and settled
  ASSERT_FALSE(out.saturated);
  EXPECT_NEAR(turn(41 * 2000, true), before, 2.5 * kPlace);
}

// Nothing is behind, and the first current is the start's; in reverse the other way.  From there on it is an integral as any:
// an error takes it away.
TEST(SpeedRegulator, TheIntegralBeginsAtTheStartsCurrent) {
  for (const bool reverse : {false, true}) {
    const int way = reverse ? -1 : 1;
    SpeedRegulator dut;
    SpeedRegulator::In in{.reverse = reverse, .locked = true, .config = config()};
    in.config.target = 0;
    EXPECT_EQ(dut.tick(in).current, 0) << "not before the loop is closed";
    in.enable = true;
    for (int n = 0; n < 3; ++n) EXPECT_EQ(dut.tick(in).current, way * 1000);
    in.step = step(way * 0.1);
    int falls = 0;
    while (dut.tick(in).current != way * -12288 && falls < 20'000) ++falls;
    EXPECT_LT(falls, 20'000);
    in.enable = false;
    dut.tick(in);
    in.enable = true, in.step = 0;
    EXPECT_EQ(dut.tick(in).current, way * 1000) << "each start anew";
  }
}

// An estimate that is ahead of the reference brakes only when it is to be believed; until then there is no current, the integral
// is not below 0, and nothing counts as limited.
TEST(SpeedRegulator, NothingBrakesBeforeTheLock) {
  for (const bool reverse : {false, true}) {
    const int way = reverse ? -1 : 1;
    SpeedRegulator dut;
    SpeedRegulator::In in{.reverse = reverse, .config = config()};
    in.config.target = 1 << 21;  // 0.0625
    dut.tick(in);
    in.enable = true, in.step = step(way * 0.2);
    SpeedRegulator::Out out;
    for (int n = 0; n < 900; ++n) {
      out = dut.tick(in);
      ASSERT_GE(way * int(out.current.raw()), 0) << n;
      ASSERT_FALSE(out.saturated) << n;
    }
    EXPECT_EQ(out.current, 0);
    in.step = step(way * 0.0625);
    for (int n = 0; n < 400; ++n) out = dut.tick(in);  // 0.97^400 of the error is left: nothing
    EXPECT_GE(way * int(out.current.raw()), 0) << "the integral is not below 0";
    EXPECT_LT(way * int(out.current.raw()), 1000) << "nor what it was at first";
    in.step = step(way * 0.2), in.locked = true;
    for (int n = 0; n < 400; ++n) out = dut.tick(in);
    EXPECT_LT(way * value(out.current), -0.1);
  }
}

TEST(SpeedRegulator, ALimitedIntegralComesBackAtOnce) {
  SpeedRegulator dut;
  SpeedRegulator::In in{.enable = true, .locked = true, .config = config()};
  SpeedRegulator::Out out;
  for (int n = 0; n < 20'000; ++n) out = dut.tick(in);
  EXPECT_EQ(out.current, 12288);
  EXPECT_TRUE(out.saturated);
  in.step = step(0.2);
  for (int n = 0; n < 100; ++n) out = dut.tick(in);
  // The filter has let 95 % of the step through: k_p pulls by 0.07 x 2.7, far more than the
  // integral could have wound up had it been held at the limit.
  EXPECT_LT(value(out.current), 12288 * kPlace - 0.1);
}

// The proportional part alone reaches the limit: the integral stands, and with the error gone nothing is left of it.
TEST(SpeedRegulator, WhatTheProportionalPartLimitsWindsNothingUp) {
  SpeedRegulator dut;
  SpeedRegulator::In in{.enable = true, .locked = true, .config = config()};
  in.config.slew = (1 << 19) - 1;
  in.config.k_p = 2800;
  in.config.filter = 0x7fff;
  SpeedRegulator::Out out;
  int limited = 0;
  for (int n = 0; n < 2000; ++n) limited += (out = dut.tick(in)).saturated;
  ASSERT_GT(limited, 1900);
  const int held = int(dut.tick(in).current.raw());
  in.step = step(value(out.reference));
  for (int n = 0; n < 3; ++n) out = dut.tick(in);
  EXPECT_LT(std::abs(int(out.current.raw())), held / 4);
}

TEST(SpeedRegulator, ItSaysWhereTheSpeedStands) {
  SpeedRegulator dut;
  const auto settle = [&](int places, double emf) {
    SpeedRegulator::Out out;
    for (int n = 0; n < 2000; ++n) {
      out = dut.tick({.enable = true, .step = Int<20>(places * 16),
                      .emf_step = step(emf * places * kPlace), .config = config()});
    }
    return out;
  };
  EXPECT_FALSE(settle(490, 1).fast);
  EXPECT_TRUE(settle(490, 1).slow);
  EXPECT_TRUE(settle(990, 1).stopping);
  EXPECT_FALSE(settle(990, 1).slow);
  EXPECT_TRUE(settle(1010, 1).fast);
  EXPECT_FALSE(settle(1010, 1).stopping);
  EXPECT_TRUE(settle(2000, 0.5).plausible);
  EXPECT_FALSE(settle(2000, 0.35).plausible);
  EXPECT_FALSE(settle(2000, 2.6).plausible);
  EXPECT_FALSE(settle(-2000, 1).plausible) << "against the wanted direction";
}

TEST(SpeedRegulator, SlowingDownAimsBelowTheStopSpeed) {
  SpeedRegulator dut;
  SpeedRegulator::Out out;
  for (int n = 0; n < 5000; ++n) {
    out = dut.tick({.enable = true, .slow_down = true, .config = config()});
  }
  EXPECT_EQ(out.reference, 750);
  out = dut.tick({.config = config()});
  EXPECT_EQ(out.current, 0);
  out = dut.tick({.enable = true, .config = config()});
  EXPECT_EQ(out.reference, 3) << "4000 / 1024, from 0 again";
}

// The header's equations with its roundings.
class PlainRegulator {
 public:
  using Shown = std::array<plain::Integer, 8>;
  Shown tick(const SpeedRegulator::In& in) {
    using namespace plain;
    const RegulatorConfig& c = in.config;
    const auto forward = [&](Integer x, int bits) { return held(in.reverse ? -x : x, bits); };
    const Integer target = in.slow_down ? 768 * of(c.stop) : of(c.target);
    const Integer reference = std::clamp(target, reference_ - of(c.slew), reference_ + of(c.slew));
    const Integer behind = 256 * forward(of(in.step), 20) - speed_;
    const Integer speed = held(speed_ + down(behind * of(c.filter), 15), 28);
    const Integer error = held(nearest(4 * reference - speed, 8), 20);
    const Integer wanted = down(error * of(c.k_p), 12) + down(integral_, 12);
    const Integer most = of(c.limit), least = in.locked ? -most : 0;
    const Integer integral = std::clamp(integral_ + nearest(error * of(c.k_i), 9), least << 12, most << 12);
    const Integer shown = down(speed, 12), emf = down(forward(of(in.emf_step), 20), 4);
    if (!in.enable) {
      reference_ = speed_ = 0;
      integral_ = of(c.start_current) << 12;
      return {};
    }
    reference_ = reference, speed_ = speed;
    const bool above = wanted > most, below = wanted < least;
    if (!(above && error >= 0) && !(below && error < 0)) integral_ = integral;
    const bool plausible = shown > 0 && emf > down(shown * of(c.emf_low), 13) && emf < down(shown * of(c.emf_high), 13);
    return {forward(std::clamp(wanted, least, most), 16), forward(shown, 16), down(reference, 10), above || (below && in.locked),
            shown > of(c.lock), shown < of(c.slow), shown < of(c.stop), plausible};
  }

 private:
  plain::Integer reference_ = 0, speed_ = 0, integral_ = 0;
};

// Bounds are drawn beside what was shown last, too, and rotor and EMF beside what they are compared with: ties are met.
TEST(SpeedRegulator, EqualsItsEquationsInPlainIntegers) {
  plain::Drawn any(7);
  for (int run = 0; run < 2'000; ++run) {
    SpeedRegulator dut;
    PlainRegulator expected;
    SpeedRegulator::In in;
    RegulatorConfig& c = in.config;
    any.into(c.target), any.into(c.slew), any.into(c.filter), any.into(c.k_p), any.into(c.k_i), any.into(c.limit);
    any.into(c.start_current), any.into(c.stop), any.into(c.emf_low), any.into(c.emf_high);
    if (any.one_in(2)) c.slew = any.between(0, 9000), c.filter = any.between(0, 9000);
    if (any.one_in(2)) c.k_p = any.between(0, 900), c.k_i = any.between(0, 900);
    if (any.one_in(4)) c.start_current = c.limit, c.target = 0;
    int shown = 0;
    for (int sample = 0; sample < 100; ++sample) {
      const auto near_shown = [&](UInt<15>& bound) {
        if (any.one_in(2)) bound = std::clamp(shown + any.between(-1, 1), 0, 32767);
        else any.into(bound);
      };
      near_shown(c.lock), near_shown(c.slow), near_shown(c.stop);
      in.enable = !any.one_in(60), in.reverse = any.one_in(3), in.slow_down = any.one_in(10), in.locked = any.one_in(2);
      any.into(in.step), any.into(in.emf_step);
      if (any.one_in(2)) in.step = any.between(-40, 40), in.emf_step = any.between(-300, 300);
      if (any.one_in(3)) in.emf_step = std::clamp(16 * ((shown * int(c.emf_low.raw()) >> 13) + any.between(-1, 1)), -500'000, 500'000);
      if (any.one_in(3)) in.emf_step = std::clamp(16 * ((shown * int(c.emf_high.raw()) >> 13) + any.between(-1, 1)), -500'000, 500'000);
      const auto out = dut.tick(in);
      shown = std::abs(int(out.speed.raw()));
      const PlainRegulator::Shown got = {plain::of(out.current), plain::of(out.speed), plain::of(out.reference), out.saturated,
                                         out.fast, out.slow, out.stopping, out.plausible};
      ASSERT_EQ(got, expected.tick(in)) << run << " " << sample;
    }
  }
}

}  // namespace
}  // namespace steplock
