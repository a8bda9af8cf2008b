// Current control against its equations in doubles, within what the words' last places allow.

#include "hls/sinusoidal/current_control.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "tests/hls/plain_integers.hpp"

namespace steplock {
namespace {

constexpr double kTurn = 6.283185307179586;
constexpr double kPlace = 1.0 / 32768;  // the last of s0.15

double value(Int<16> x) { return double(x.raw()) * kPlace; }
Int<16> word(double x) { return static_cast<int>(std::lround(x / kPlace)); }
UInt<15> gain(double x, int fraction) {
  return static_cast<int>(std::lround(std::ldexp(x, fraction)));
}

// Two roundings of half a place each, and the second order that is left out: a sixth of a place.
TEST(SineCosine, IsRightToTwoPlacesAtEveryAngle) {
  for (int angle = 0; angle < 65536; ++angle) {
    const auto [sine, cosine] = sine_cosine(UInt<16>(angle));
    ASSERT_NEAR(value(sine), std::sin(kTurn * angle / 65536), 2 * kPlace) << angle;
    ASSERT_NEAR(value(cosine), std::cos(kTurn * angle / 65536), 2 * kPlace) << angle;
  }
}

struct Numbers {
  double i_u, i_v, angle, speed, set_gamma, set_delta, k_p, k_i, inductance, emf, limit;

  CurrentControl::In in() const {
    CurrentControl::In in;
    in.enable = true;
    in.i_u = word(i_u);
    in.i_v = word(i_v);
    in.angle = static_cast<int>(std::lround(angle * 65536));
    in.ahead = in.angle;
    in.speed = word(speed);
    in.set_gamma = word(set_gamma);
    in.set_delta = word(set_delta);
    in.k_p = gain(k_p, 12);
    in.k_i = gain(k_i, 15);
    in.inductance = gain(inductance, 10);
    in.emf = gain(emf, 10);
    in.v_dc = 4095;
    in.limit = gain(limit, 15);
    return in;
  }
};

// The voltage acts later, in a frame that has turned meanwhile.
TEST(CurrentControl, TheVoltageIsTurnedAheadByWhatTheFrameTurns) {
  std::mt19937 any(3);
  for (int i = 0; i < 2'000; ++i) {
    const auto turn = [&](auto& g) { return std::uniform_int_distribution<>(0, 65535)(g); };
    CurrentControl now, later;
    CurrentControl::In in;
    in.enable = true;
    in.i_u = in.set_delta = 3000;
    in.k_p = 8192, in.v_dc = 4095, in.limit = 32000;
    in.angle = turn(any);
    in.ahead = in.angle;
    const auto a = now.tick(in);
    const int by = turn(any);
    in.ahead = wrap<UInt<16>>(in.angle + by);
    const auto b = later.tick(in);
    const double c = std::cos(kTurn * by / 65536), s = std::sin(kTurn * by / 65536);
    // Sine and cosine by 2 places each of up to 0.4, twice, and two roundings.
    ASSERT_NEAR(value(b.v_alpha), c * value(a.v_alpha) - s * value(a.v_beta), 5 * kPlace);
    ASSERT_NEAR(value(b.v_beta), s * value(a.v_alpha) + c * value(a.v_beta), 5 * kPlace);
  }
}

// What dead time will do hangs on the currents that will flow, not on those that did.
TEST(CurrentControl, TheWantedPhaseCurrentsAreTheSetOnesWhereTheVoltageActs) {
  std::mt19937 any(4);
  const auto draw = [&](int a, int b) { return std::uniform_int_distribution<>(a, b)(any); };
  for (int i = 0; i < 5'000; ++i) {
    CurrentControl dut;
    CurrentControl::In in;
    in.angle = draw(0, 65535), in.ahead = draw(0, 65535);
    in.i_u = draw(-9000, 9000), in.i_v = draw(-9000, 9000);
    in.set_gamma = draw(-9000, 9000), in.set_delta = draw(-9000, 9000);
    const auto out = dut.tick(in);
    const double then = kTurn * double(in.ahead.raw()) / 65536;
    const double gamma = value(in.set_gamma), delta = value(in.set_delta);
    const auto phase = [&](double at) {
      return gamma * std::cos(then - at) - delta * std::sin(then - at);
    };
    // Sine and cosine by 2 places of up to 0.4 in all and a rounding: 1.3 places of alpha and beta;
    // v is half of one and 0.87 of the other, cut and rounded: 2.8.
    ASSERT_NEAR(value(out.wanted_u), phase(0), 1.3 * kPlace) << i;
    ASSERT_NEAR(value(out.wanted_v), phase(kTurn / 3), 2.8 * kPlace) << i;
  }
}

struct Voltages {
  double alpha, beta, i_gamma, i_delta;
};

// The header's equations, one sample after a reset; nothing limits.
Voltages reference(const Numbers& n) {
  const double sine = std::sin(kTurn * n.angle), cosine = std::cos(kTurn * n.angle);
  const double beta = (n.i_u + 2 * n.i_v) / std::sqrt(3.0);
  const double i_gamma = n.i_u * cosine + beta * sine;
  const double i_delta = -n.i_u * sine + beta * cosine;
  const double gain = n.k_p + n.k_i;
  const double coupling = n.speed * n.inductance;
  const double u_gamma = gain * (n.set_gamma - i_gamma) - coupling * i_delta;
  const double u_delta = gain * (n.set_delta - i_delta) + coupling * i_gamma + n.speed * n.emf;
  return {u_gamma * cosine - u_delta * sine, u_gamma * sine + u_delta * cosine, i_gamma, i_delta};
}

Numbers drawn(std::mt19937& any) {
  const auto between = [&](double a, double b) {
    return std::uniform_real_distribution<>(a, b)(any);
  };
  const auto current = [&] { return between(-0.3, 0.3); };
  const auto meant = [&](double most) { return std::round(between(0, most) * 1024) / 1024; };
  return {current(),         current(),         between(0, 0.9999), between(-0.9, 0.9),
          current(),         current(),         between(0, 0.4),    between(0, 0.1),
          meant(0.3),        meant(0.3),        0.999};
}

TEST(CurrentControl, OneSampleIsTheEquations) {
  std::mt19937 any(1);
  for (int i = 0; i < 20'000; ++i) {
    const Numbers n = drawn(any);
    CurrentControl dut;
    const auto out = dut.tick(n.in());
    const auto expected = reference(n);
    ASSERT_FALSE(out.limited);
    // Currents: rounded inputs (half a place each, twice that through 2 i_v / sqrt 3), beta cut,
    // sine and cosine off by up to 2 places times 0.9, rounded: below 6.  Voltages: those through
    // gains up to 0.8, three words of cut products, sine and cosine again: below 14.
    ASSERT_NEAR(value(out.i_gamma), expected.i_gamma, 6 * kPlace);
    ASSERT_NEAR(value(out.i_delta), expected.i_delta, 6 * kPlace);
    ASSERT_NEAR(value(out.v_alpha), expected.alpha, 14 * kPlace);
    ASSERT_NEAR(value(out.v_beta), expected.beta, 14 * kPlace);
  }
}

Numbers still(double set_delta) { return {0, 0, 0, 0, 0, set_delta, 0, 0.01, 0, 0, 0.5}; }

TEST(CurrentControl, TheIntegratorAddsUpSampleBySample) {
  CurrentControl dut;
  for (int sample = 1; sample <= 20; ++sample) {
    const auto out = dut.tick(still(0.2).in());
    ASSERT_NEAR(value(out.v_beta), sample * 0.01 * 0.2, (2 + sample * 0.2) * kPlace) << sample;
  }
}

TEST(CurrentControl, TheVoltageStaysInItsCircle) {
  std::mt19937 any(2);
  CurrentControl dut;
  int limited = 0;
  for (int i = 0; i < 20'000; ++i) {
    Numbers n = drawn(any);
    n.k_p = 5;
    n.limit = std::uniform_real_distribution<>(0.1, 0.9)(any);
    const auto out = dut.tick(n.in());
    limited += out.limited ? 1 : 0;
    ASSERT_LE(std::hypot(value(out.v_alpha), value(out.v_beta)), n.limit + 4 * kPlace);
  }
  EXPECT_GT(limited, 10'000);
}

// Three chords, up to the gamma axis' own limit; the lowest, 5/4 U - 13/16 |u_gamma|, passes the origin at
// 5/4 U / hypot(1, 13/16), which is 3 % inside.
TEST(CurrentControl, TheDeltaVoltageReachesTheCircleWithin3Percent) {
  constexpr double kLimit = 0.5 * 4095 / 4096;  // of this dc voltage
  for (int percent = -90; percent <= 90; ++percent) {
    CurrentControl dut;
    const double gamma = percent / 100.0 * kLimit;
    const auto out = dut.tick(Numbers{0, 0, 0, 0, gamma, 0.9, 1, 0, 0, 0, 0.5}.in());
    const double length = std::hypot(value(out.v_alpha), value(out.v_beta)) / kLimit;
    ASSERT_TRUE(out.limited);
    ASSERT_GT(length, 1.25 / std::hypot(1, 13.0 / 16) - 4 * kPlace / kLimit) << percent;
    ASSERT_LE(length, 1 + 4 * kPlace / kLimit) << percent;
    ASSERT_NEAR(value(out.v_alpha), std::clamp(gamma, -0.75 * kLimit, 0.75 * kLimit), 3 * kPlace);
  }
}

TEST(CurrentControl, ALimitedIntegratorComesBackAtOnce) {
  CurrentControl dut;
  for (int sample = 0; sample < 5'000; ++sample) dut.tick(still(0.5).in());
  const double at_limit = value(dut.tick(still(0.5).in()).v_beta);
  EXPECT_NEAR(at_limit, 0.5, 0.01 * 0.5);  // within one step of the integrator
  const double after = value(dut.tick(still(-0.5).in()).v_beta);
  EXPECT_NEAR(after, at_limit - 0.01 * 0.5, 0.01 * 0.5 + 4 * kPlace);
}

TEST(CurrentControl, WithoutEnableItRests) {
  CurrentControl dut;
  for (int sample = 0; sample < 100; ++sample) dut.tick(still(0.5).in());
  auto off = still(0.5).in();
  off.enable = false;
  const auto out = dut.tick(off);
  EXPECT_EQ(out.v_alpha, 0);
  EXPECT_EQ(out.v_beta, 0);
  EXPECT_NEAR(value(dut.tick(still(0.5).in()).v_beta), 0.01 * 0.5, 3 * kPlace) << "from 0 again";
}

// The header's equations with its roundings.
class PlainControl {
 public:
  struct Out {
    plain::Integer v_alpha, v_beta, i_gamma, i_delta, wanted_u, wanted_v;
    bool limited;
  };
  Out tick(const CurrentControl::In& in) {
    using namespace plain;
    const auto word = [](Integer product) { return held(nearest(product, 15), 16); };
    const auto [s, c] = sine_cosine(in.angle);
    const Integer sine = of(s), cosine = of(c), alpha = of(in.i_u);
    const Integer beta = held(down((of(in.i_u) + 2 * of(in.i_v)) * constant(1 / std::sqrt(3.0), 15), 15), 16);
    const Integer i_gamma = word(alpha * cosine + beta * sine), i_delta = word(beta * cosine - alpha * sine);
    const Integer coupling = held(nearest(of(in.speed) * of(in.inductance), 10), 16);
    const Integer emf = held(nearest(of(in.speed) * of(in.emf), 10), 16);
    const Integer limit = down(of(in.v_dc) * of(in.limit), 12);
    const Axis gamma = axis(x_gamma_, in, held(of(in.set_gamma) - i_gamma, 16), -word(coupling * i_delta), limit - down(limit, 2));
    const Integer length = std::abs(gamma.voltage);
    const Integer left = std::min({limit - down(9 * length, 6), limit + down(limit, 4) - down(13 * length, 5),
                                   limit + down(limit, 2) - down(13 * length, 4)});
    const Axis delta = axis(x_delta_, in, held(of(in.set_delta) - i_delta, 16), word(coupling * i_gamma) + emf, held_unsigned(left, 15));
    const auto [st, ct] = sine_cosine(in.ahead);
    const Integer sine_then = of(st), cosine_then = of(ct), set_gamma = of(in.set_gamma), set_delta = of(in.set_delta);
    const Integer ask_alpha = word(set_gamma * cosine_then - set_delta * sine_then);
    const Integer ask_beta = word(set_gamma * sine_then + set_delta * cosine_then);
    return {word(gamma.voltage * cosine_then - delta.voltage * sine_then), word(gamma.voltage * sine_then + delta.voltage * cosine_then),
            i_gamma, i_delta, ask_alpha, held(nearest(ask_beta * constant(std::sqrt(0.75), 15), 15) - down(ask_alpha, 1), 16),
            gamma.limited || delta.limited};
  }

 private:
  struct Axis {
    plain::Integer voltage;
    bool limited;
  };
  static Axis axis(plain::Integer& x, const CurrentControl::In& in, plain::Integer error, plain::Integer ahead, plain::Integer limit) {
    using namespace plain;
    const Integer moved = held(x + down(error * of(in.k_i), 3), 28);
    const Integer wanted = down(moved, 12) + down(error * of(in.k_p), 12) + ahead;
    if (!in.enable) {
      x = 0;
      return {0, false};
    }
    const bool winds_up = (wanted > limit && error >= 0) || (wanted < -limit && error < 0);
    if (!winds_up) x = moved;
    return {std::clamp(wanted, -limit, limit), std::abs(wanted) > limit};
  }
  plain::Integer x_gamma_ = 0, x_delta_ = 0;  // s0.27
};

TEST(CurrentControl, EqualsItsEquationsInPlainIntegers) {
  plain::Drawn any(5);
  for (int run = 0; run < 2'000; ++run) {
    CurrentControl dut;
    PlainControl expected;
    CurrentControl::In in;
    any.into(in.k_p), any.into(in.k_i), any.into(in.inductance), any.into(in.emf), any.into(in.limit);
    if (any.one_in(2)) in.k_p = any.between(0, 6000), in.k_i = any.between(0, 300);
    if (any.one_in(2)) in.inductance = any.between(0, 400), in.emf = any.between(0, 500);
    for (int sample = 0; sample < 50; ++sample) {
      in.enable = !any.one_in(40);
      any.into(in.i_u), any.into(in.i_v), any.into(in.angle), any.into(in.ahead), any.into(in.speed);
      any.into(in.set_gamma), any.into(in.set_delta), any.into(in.v_dc);
      if (any.one_in(2)) in.i_u = any.between(-4000, 4000), in.i_v = any.between(-4000, 4000);
      if (any.one_in(2)) in.set_gamma = any.between(-4000, 4000), in.set_delta = 900;
      const auto out = dut.tick(in);
      const auto e = expected.tick(in);
      const auto got = std::array{plain::of(out.v_alpha), plain::of(out.v_beta), plain::of(out.i_gamma), plain::of(out.i_delta),
                                  plain::of(out.wanted_u), plain::of(out.wanted_v), plain::Integer{out.limited}};
      const auto wanted = std::array{e.v_alpha, e.v_beta, e.i_gamma, e.i_delta, e.wanted_u, e.wanted_v, plain::Integer{e.limited}};
      ASSERT_EQ(got, wanted) << run << " " << sample;
    }
  }
}

}  // namespace
}  // namespace steplock
