// The modulator against the reference's duties in doubles, and what a pattern and short pulses come
// to.

#include "hls/sinusoidal/space_vector.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "model/reference/sinusoidal/applied_voltage.hpp"
#include "model/reference/sinusoidal/modulator.hpp"
#include "tests/hls/plain_integers.hpp"

namespace steplock {
namespace {

namespace reference = reference::sinusoidal;

constexpr double kPlace = 1.0 / 32768;  // the last of s0.15
constexpr int kPeriod = 1200, kMinimum = 12;

double value(Int<16> x) { return double(x.raw()) * kPlace; }

SpaceVector::In at(double alpha, double beta, int dc = 2700) {
  SpaceVector::In in;
  in.v_alpha = static_cast<int>(std::lround(alpha / kPlace));
  in.v_beta = static_cast<int>(std::lround(beta / kPlace));
  in.v_dc = dc;
  in.period = kPeriod;
  in.minimum = kMinimum;
  return in;
}

// 1 / v_dc after the samples of an offset's measurement.
SpaceVector settled(int dc = 2700) {
  SpaceVector dut;
  for (int n = 0; n < 16; ++n) dut.tick(at(0, 0, dc));
  return dut;
}

// Vectors of a phase's peak.
reference::Vector long_as_power(const SpaceVector::In& in) {
  return std::sqrt(1.5) * reference::Vector{value(in.v_alpha), value(in.v_beta)};
}

// 1 / v_dc is right to 2 places of 2^-12, of 1 to 8: 5e-4 of up to 600 clocks at the least; the
// products cut one place of 2^-15 each and a 16th of a clock: all that and half a clock of rounding
// is less than one clock.
TEST(SpaceVector, IsTheReferenceWithinAClock) {
  std::mt19937 any(1);
  const auto draw = [&](double a, double b) { return std::uniform_real_distribution<>(a, b)(any); };
  const reference::AppliedVoltage applied({.period = kPeriod, .dead_time = 12, .compensate = true});
  for (const int dc : {700, 2700, 4000}) {
    SpaceVector dut = settled(dc);
    const double v_dc = dc / 4096.0;
    for (int n = 0; n < 10'000; ++n) {
      auto in = at(draw(-0.4, 0.4) * v_dc, draw(-0.4, 0.4) * v_dc, dc);
      in.i_u = static_cast<int>(draw(-60, 60));
      in.i_v = static_cast<int>(draw(-60, 60));
      in.dead = 192;
      in.sine = n % 3 == 0;
      const auto out = dut.tick(in);
      const auto how = in.sine ? design::Modulation::kSine : design::Modulation::kSpaceVector;
      const double u = value(in.i_u), v = value(in.i_v);
      const auto duty = applied.compensated(
          reference::duties(how, long_as_power(in), v_dc), {u, v, -u - v}, v_dc);
      const int on[3] = {int(out.on_u.raw()), int(out.on_v.raw()), int(out.on_w.raw())};
      for (std::size_t k = 0; k < 3; ++k) {
        const double wanted = duty[k] * kPeriod;
        if (on[k] == 0 || on[k] == kPeriod) {
          ASSERT_LE(std::min(wanted, kPeriod - wanted), kMinimum + 1) << n;
        } else {
          ASSERT_NEAR(on[k], wanted, 1) << n << ' ' << k;
        }
      }
    }
  }
}

TEST(SpaceVector, TheInverseOfTheDcVoltageSettlesInTenSamples) {
  for (const int dc : {520, 1000, 2700, 4095}) {
    SpaceVector dut;
    for (int n = 0; n < 10; ++n) dut.tick(at(0, 0, dc));
    const double v = 0.25 * dc / 4096;
    const auto out = dut.tick(at(v, -v / std::sqrt(3.0), dc));
    // v_u = v, v_v = -v, v_w = 0: a quarter of the period above and below its half, in 1 clock.
    EXPECT_NEAR(int(out.on_u.raw()), 900, 1) << dc;
    EXPECT_NEAR(int(out.on_v.raw()), 300, 1) << dc;
  }
}

TEST(SpaceVector, ItIsBackAfterTheDcVoltageWasLostAndReturned) {
  SpaceVector dut = settled(4000);
  for (const int dc : {0, 4095, 10, 4095}) {
    for (int n = 0; n < 40; ++n) dut.tick(at(0, 0, dc));
  }
  EXPECT_NEAR(int(dut.tick(at(0.25 * 4095 / 4096, 0, 4095)).on_u.raw()), 600 + 225, 1);
}

TEST(SpaceVector, APatternDrivesItsLegsAlone) {
  SpaceVector dut = settled();
  auto in = at(0.3, 0.3);
  in.hold = in.hold_u = true;
  in.hold_voltage = static_cast<int>(0.1 * 2700 / 4096 / kPlace);
  auto out = dut.tick(in);
  EXPECT_NEAR(int(out.on_u.raw()), 120, 1);
  EXPECT_EQ(out.on_v, 0);
  EXPECT_EQ(out.on_w, 0);
  in.hold_v = true;
  out = dut.tick(in);
  EXPECT_NEAR(int(out.on_u.raw()), 120, 1);
  EXPECT_NEAR(int(out.on_v.raw()), 120, 1);
  EXPECT_EQ(out.on_w, 0);
  in.hold_u = false;
  out = dut.tick(in);
  EXPECT_NEAR(int(out.on_v.raw()), 120, 1);
  EXPECT_EQ(out.on_u, 0);
  in.hold_v = false;
  in.hold_w = true;
  out = dut.tick(in);
  EXPECT_NEAR(int(out.on_w.raw()), 120, 1);
  EXPECT_EQ(out.on_u, 0);
  EXPECT_EQ(out.on_v, 0);
}

TEST(SpaceVector, NoPulseAndNoGapIsShorterThanTheMinimum) {
  std::mt19937 any(2);
  SpaceVector dut = settled();
  bool none = false, all = false;
  for (int n = 0; n < 20'000; ++n) {
    const auto draw = [&] { return std::uniform_real_distribution<>(-0.45, 0.45)(any); };
    const auto out = dut.tick(at(draw(), draw()));
    for (const LegClocks on : {out.on_u, out.on_v, out.on_w}) {
      ASSERT_TRUE(on == 0 || on == kPeriod || (on >= kMinimum && on <= kPeriod - kMinimum));
      none |= on == 0, all |= on == kPeriod;
    }
  }
  EXPECT_TRUE(none && all);
}

// The header's equations with its roundings.
class PlainVector {
 public:
  std::array<plain::Integer, 3> tick(const SpaceVector::In& in) {
    using namespace plain;
    const Integer rest = held_unsigned(down((1 << 28) - 8 * of(in.v_dc) * inverse_, 13), 15);
    inverse_ = std::max(Integer{4096}, held_unsigned(nearest(inverse_ * rest, 14), 15));
    const Integer half = down(of(in.v_alpha), 1), side = nearest(of(in.v_beta) * constant(std::sqrt(0.75), 15), 15);
    const std::array phase = {of(in.v_alpha), side - half, -side - half};
    const auto [least, greatest] = std::minmax_element(phase.begin(), phase.end());
    const Integer common = in.sine ? 0 : down(*least + *greatest, 1);
    const std::array current = {of(in.i_u), of(in.i_v), held(-(of(in.i_u) + of(in.i_v)), 16)};
    const std::array holds = {in.hold_u, in.hold_v, in.hold_w};
    std::array<Integer, 3> on = {};
    for (std::size_t k = 0; k < 3; ++k) {
      const Integer voltage = !in.hold ? held(phase[k] - common, 16) : holds[k] ? of(in.hold_voltage) : 0;
      on[k] = leg(in, voltage, current[k]);
    }
    return on;
  }

 private:
  plain::Integer leg(const SpaceVector::In& in, plain::Integer voltage, plain::Integer current) const {
    using namespace plain;
    const Integer period = of(in.period), minimum = of(in.minimum);
    const Integer made_up = (current > 0 ? 1 : current < 0 ? -1 : 0) * of(in.dead);
    const Integer sixteenths = down(held(nearest(voltage * inverse_, 12), 16) * period, 11) + (in.hold ? 0 : 8 * period) + made_up;
    const Integer on = nearest(sixteenths, 4);
    return on < 0 || on < minimum ? 0 : period - on < minimum ? period : on;
  }
  plain::Integer inverse_ = 4096;
};

TEST(SpaceVector, EqualsItsEquationsInPlainIntegers) {
  plain::Drawn any(3);
  for (int run = 0; run < 1'000; ++run) {
    SpaceVector dut;
    PlainVector expected;
    SpaceVector::In in;
    in.period = any.between(400, 3000), in.minimum = any.between(0, 60);
    any.into(in.v_dc), any.into(in.dead);
    in.dead = any.one_in(2) ? 0 : int(in.dead.raw()) / 8;
    for (int sample = 0; sample < 60; ++sample) {
      if (any.one_in(20)) any.into(in.v_dc);
      any.into(in.v_alpha), any.into(in.v_beta), any.into(in.i_u), any.into(in.i_v), any.into(in.hold_voltage);
      if (any.one_in(2)) in.v_alpha = any.between(-9000, 9000), in.v_beta = any.between(-9000, 9000), in.i_u = any.between(-2, 2);
      in.sine = any.one_in(3), in.hold = any.one_in(4), in.hold_u = any.one_in(2), in.hold_v = any.one_in(2), in.hold_w = any.one_in(2);
      const auto out = dut.tick(in);
      ASSERT_EQ((std::array{plain::of(out.on_u), plain::of(out.on_v), plain::of(out.on_w)}), expected.tick(in)) << run << " " << sample;
    }
  }
}

}  // namespace
}  // namespace steplock
