// The current-model estimator against its reference in doubles, on the same currents and patterns
// of a motor that turns.

#include "hls/sinusoidal/current_model.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "model/reference/sinusoidal/current_model.hpp"
#include "tests/hls/plain_estimator.hpp"
#include "tests/hls/turning_motor.hpp"

namespace steplock {
namespace {

using namespace turning;

CurrentModel::In in_of(const Turning& motor) {
  auto in = motor.in<CurrentModel::In>();
  in.config = {.decay = kDecay, .gain = kGain, .k_e = 541, .k_theta = 3277, .k_speed = 5894};
  return in;
}

exact::CurrentModelEstimator estimator() {
  return {motor(), {.k_e = 541 / 8192.0, .k_theta = 2 * kPi * 3277 / 16384.0}, 1};
}

// `inverse` and the rounded word per clock are off by 3e-5 and 4e-5 of up to 0.4: one place.  Four
// cuts of 1/16 clock, 0.4 places each; within an ADC's step of zero the mean current is cut by
// half a place of 16: another 6/16 clocks, in each leg at worst; rounding, and v_dc's own half
// place.
TEST(AppliedVoltage, IsTheReferenceWithinItsRounding) {
  std::mt19937 any(1);
  const auto draw = [&](int a, int b) { return std::uniform_int_distribution<>(a, b)(any); };
  const exact::AppliedVoltage voltage(
      {.period = kPeriod, .dead_time = 12, .small_current = 16 * kPlace});
  for (int n = 0; n < 20'000; ++n) {
    int on[3], u = draw(-9000, 9000), v = draw(-9000, 9000);
    for (int& clocks : on) clocks = draw(0, 9) == 0 ? draw(0, 1) * kPeriod : draw(20, kPeriod - 20);
    if (n % 3 == 0) u = draw(-40, 40);
    const auto got = applied_voltage({.on_u = on[0], .on_v = on[1], .on_w = on[2],
                                      .period = kPeriod, .dead = 192, .inverse = 9321},
                                     Int<17>(2 * u), Int<17>(2 * v), UInt<13>(5400));
    const Vector wanted = clarke(voltage({double(on[0]) / kPeriod, double(on[1]) / kPeriod,
                                        double(on[2]) / kPeriod},
                                       {u * kPlace, v * kPlace, -(u + v) * kPlace}, kDc));
    ASSERT_NEAR(value(got.alpha), wanted.x, 6 * kPlace) << n;
    ASSERT_NEAR(value(got.beta), wanted.y, 6 * kPlace) << n;
  }
}

// Per sample, Delta i is off by at most 12 places of 2^-16: the voltage's 6 places of 2^-15 times
// the gain, two roundings of the free current, sine and cosine by 2 places of up to 0.2, two more
// roundings.  The loop takes 2 (2 pi f) of an angle's error away per sample, so that a lasting
// error of the current ends at 12 places (k_theta + k_speed / gain) / (4 pi f).
double tolerance(double turns) {
  return 2 * kPi * 12 / 65536.0 * (0.2 + 0.1) / (4 * kPi * std::abs(turns));
}

TEST(CurrentModel, InStepItIsTheReferenceWithinItsRounding) {
  for (const double turns : {0.0012, 0.01, -0.01, 0.025}) {
    for (const double i_delta : {0.0, 0.25, -0.2}) {
      // Without current, dead time would be noise: whose sign, nobody knows.
      Turning motor(1, turns, i_delta, i_delta == 0 ? 0 : 192);
      CurrentModel dut;
      auto reference = estimator();
      const auto begin = in_of(motor);
      CurrentModel::In reset = begin;
      reset.enable = false;
      reset.initial = Angle::of(std::llround(1 / (2 * kPi) * (1 << 24)));
      dut.tick(reset);
      reference.start(1, 0);
      double sum = 0;
      for (int n = 0; n < 6000; ++n) {
        motor.step();
        const auto out = dut.tick(in_of(motor));
        const auto& e = reference.update(motor.interval());
        if (n < 4000) continue;
        ASSERT_NEAR(exact::wrapped(angle_of(out.angle) - e.angle), 0, tolerance(turns))
            << turns << ' ' << i_delta << ' ' << n;
        ASSERT_NEAR(exact::wrapped(angle_of(out.angle) - motor.angle()), 0,
                    tolerance(turns) + 0.03) << "the motor's own angle";
        sum += turns_of(out.step);
      }
      // A lock cannot drift: the mean step is the motor's, but for an angle's error at both ends.
      EXPECT_NEAR(sum / 2000, turns, 2 * tolerance(turns) / 2000 + 1e-7);
    }
  }
}

TEST(CurrentModel, ItConvergesFromAllRoundInBothDirections) {
  for (const double turns : {0.01, -0.01}) {
    for (int sixteenth = 0; sixteenth < 16; ++sixteenth) {
      Turning motor(2 * kPi * sixteenth / 16, turns, 0.1, 192);
      CurrentModel dut;
      CurrentModel::In reset = in_of(motor);
      reset.enable = false;
      dut.tick(reset);
      CurrentModel::Out out;
      for (int n = 0; n < 3000; ++n) {
        motor.step();
        out = dut.tick(in_of(motor));
      }
      EXPECT_NEAR(exact::wrapped(angle_of(out.angle) - motor.angle()), 0,
                  tolerance(turns) + 0.03) << sixteenth;
      EXPECT_EQ(out.step.negative(), turns < 0);
    }
  }
}

// s0.15 of 1/16 turn.
Int<16> edge(double turns) { return word(16 * turns); }

// What is believed a quarter too much takes 0.2 R from the EMF: at rest, a speed backward.
TEST(CurrentModel, BelowItsEdgeARotorAtRestDoesNotSeemToTurnBackward) {
  for (const double way : {1.0, -1.0}) {
    for (const double slow : {0.0, 0.02}) {
      Turning motor(0, 0, way * 0.3, 0);
      CurrentModel dut;
      CurrentModel::In in = in_of(motor);
      in.enable = false;
      dut.tick(in);
      double turned = 0;
      for (int n = 0; n < 1000; ++n) {
        motor.step();
        in = in_of(motor);
        in.config.decay = kDecay * 5 / 4;
        in.edge = edge(-way * slow);
        turned += way * turns_of(dut.tick(in).step);
      }
      if (slow == 0) {
        EXPECT_LT(turned, -15.0 / 360) << "the mistake shows, by far more than rounding";
      } else {
        EXPECT_NEAR(turned, 0, tolerance(1)) << "rounding alone";
      }
    }
  }
}

TEST(CurrentModel, BeyondItsEdgeItFollowsBackwardAndDoSlowerStepsUntilZero) {
  for (const double way : {1.0, -1.0}) {
    Turning motor(0, -way * 0.01, 0.1, 192);
    CurrentModel dut, slower;
    CurrentModel::In in = in_of(motor);
    in.enable = false;
    dut.tick(in);
    slower.tick(in);
    double far = 0, farther = 0;
    for (int n = 0; n < 6000; ++n) {
      motor.step();
      in = in_of(motor);
      in.edge = edge(-way * (n < 3000 ? 0.005 : 0.02));
      const auto out = dut.tick(in);
      in.edge = edge(-way * 0.02);
      const auto other = slower.tick(in);
      if (n < 5000) continue;
      far = std::max(far, std::abs(exact::wrapped(angle_of(out.angle) - motor.angle())));
      farther = std::max(farther, std::abs(exact::wrapped(angle_of(other.angle) - motor.angle())));
    }
    EXPECT_LT(far, tolerance(0.01) + 0.03);
    EXPECT_GT(farther, kPi / 2) << "that never was beyond it is taken as mistaken";
  }
}

TEST(CurrentModel, WithoutEnableItStandsAtItsStart) {
  Turning motor(0, 0.01, 0.2, 192);
  CurrentModel dut;
  for (int n = 0; n < 100; ++n) {
    motor.step();
    dut.tick(in_of(motor));
  }
  CurrentModel::In off = in_of(motor);
  off.enable = false;
  off.initial = 0x123456;
  const auto out = dut.tick(off);
  EXPECT_EQ(out.angle, 0x123456);
  EXPECT_EQ(out.step, 0);
  motor.step();
  EXPECT_EQ(dut.tick(in_of(motor)).angle, 0x123456) << "begins at rest";
}

// Clocks of a leg within and beyond an ADC's step of zero current, switched and whole; any dc voltage.
TEST(AppliedVoltage, EqualsItsEquationsInPlainIntegers) {
  plain::Drawn any(2);
  for (int n = 0; n < 100'000; ++n) {
    AppliedPattern p;
    p.period = any.between(400, 3000);
    const int period = int(p.period.raw());
    p.on_u = any.between(0, period), p.on_v = any.between(0, period), p.on_w = any.between(0, period);
    any.into(p.dead);
    p.inverse = (1 << 25) / std::max(1024, int(p.period.raw()));
    const int most = any.one_in(2) ? 70 : 60'000;
    const int u = any.between(-most, most), v = any.between(-most, most), dc = any.between(0, 8190);
    const auto got = applied_voltage(p, Int<17>(u), Int<17>(v), UInt<13>(dc));
    const auto expected = plain::applied(p, u, v, dc);
    ASSERT_EQ(plain::of(got.alpha), expected.alpha) << n;
    ASSERT_EQ(plain::of(got.beta), expected.beta) << n;
  }
}

struct PlainFollowedEmf {
  plain::Integer emf = 0;  // s0.27

  struct Turned {
    plain::Integer emf_step, pull;
  };
  Turned follow(plain::Integer gamma, plain::Integer delta, const CurrentModelConfig& c) {
    using namespace plain;
    const Integer seen = held(delta + nearest(down(emf, 12) * of(c.gain), 12), 16);
    emf = held(emf - down(seen * of(c.k_e), 2), 28);
    return {held(nearest(down(emf, 6) * of(c.k_speed), 15), 20), nearest(gamma * of(c.k_theta), 7)};
  }
  void rest() { emf = 0; }
};

TEST(CurrentModel, EqualsItsEquationsInPlainIntegers) {
  const auto any_gains = [](plain::Drawn& any, CurrentModelConfig& c) {
    any.into(c.k_e), any.into(c.k_theta), any.into(c.k_speed);
    if (any.one_in(2)) c.k_e = any.between(0, 1500), c.k_theta = any.between(0, 4000), c.k_speed = any.between(0, 9000);
  };
  for (std::uint32_t seed = 1; seed <= 10; ++seed)
    EXPECT_EQ((plain::differences<CurrentModel, PlainFollowedEmf>(seed, 20'000, any_gains)), 0) << seed;
}

// The control: a gain that is one place more.
TEST(CurrentModel, OnePlaceOfItsGainIsSeenInPlainIntegers) {
  struct Off : PlainFollowedEmf {
    Turned follow(plain::Integer gamma, plain::Integer delta, CurrentModelConfig c) {
      c.k_e = wrap<UInt<15>>(c.k_e + 1);
      return PlainFollowedEmf::follow(gamma, delta, c);
    }
  };
  EXPECT_GT((plain::differences<CurrentModel, Off>(1, 2'000, [](plain::Drawn& any, CurrentModelConfig& c) {
              c.k_e = any.between(100, 1500), c.k_theta = 3000, c.k_speed = 6000;
            })), 100);
}

}  // namespace
}  // namespace steplock
