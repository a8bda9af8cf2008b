// The current-model estimator against its reference in doubles, on the same currents and patterns
// of a motor that turns.  Full scales are 1 and a sample takes 1, so that words are physics.

#include "hls/sinusoidal/current_model.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "model/reference/sinusoidal/applied_voltage.hpp"
#include "model/reference/sinusoidal/current_model.hpp"

namespace steplock {
namespace {

namespace reference = reference::sinusoidal;
using reference::kPi;
using reference::Vector;

constexpr double kPlace = 1.0 / 32768;  // the last of s0.15
constexpr int kPeriod = 1200;           // clocks
constexpr double kDc = 2700.0 / 4096;   // of the voltage's full scale

Int<16> word(double x) { return static_cast<int>(std::lround(x / kPlace)); }
double value(Int<16> x) { return double(x.raw()) * kPlace; }

// The servo motor m2310p at 24 V of 36 V, 20 A, 20 kHz.
EstimatorWords words() {
  return {.decay = 3113, .gain = 3686, .k_e = 541, .k_theta = 3277, .k_speed = 5894};
}
// The same motor in the reference's terms: what the words mean, not what they were rounded from.
design::sinusoidal::Motor motor() {
  const double gain = 3686 / 8192.0, decay = 3113 / 32768.0;
  return {.resistance = decay / gain,
          .inductance_d = 1 / gain,
          .inductance_q = 1 / gain,
          .k_e = 1 / (2 * kPi * 5894 / 131072.0)};
}

// Vectors of the length of a phase's peak.
Vector clarke(const reference::Phases& p) { return std::sqrt(2.0 / 3) * reference::clarke(p); }

// A motor that turns at a constant speed, with its current held near a set one; currents as the
// converters of both estimators show them.
class Turning {
 public:
  Turning(double angle, double turns, double i_delta, DeadClocks dead)
      : applied_({.period = kPeriod, .dead_time = double(dead.raw()) / 16,
                  .small_current = 16 * kPlace}),
        dead_(dead), angle_(angle), speed_(2 * kPi * turns), i_delta_(i_delta) {}

  // One interval on.
  void step() {
    const auto m = motor();
    const Vector e = reference::from_frame(angle_ + 0.5 * speed_, {0, m.k_e * speed_});
    const Vector next = reference::from_frame(angle_ + speed_, {0, i_delta_});
    const Vector wanted = e + m.resistance * i_ + m.inductance_q * (next - i_);
    reference::Phases share;
    const double half = std::sqrt(0.75) * wanted.y;
    const double v[3] = {wanted.x, -0.5 * wanted.x + half, -0.5 * wanted.x - half};
    for (std::size_t k = 0; k < 3; ++k) {
      const double duty = std::clamp(0.5 + v[k] / kDc, 0.0, 1.0);
      on_[k] = static_cast<int>(std::lround(duty * kPeriod));
      share[k] = double(on_[k]) / kPeriod;
    }
    const reference::Phases before = seen();
    const Vector given = clarke(applied_(share, before, kDc));
    i_ = i_ + (1 / m.inductance_q) * (given - m.resistance * i_ - e);
    reference::Phases mean;
    for (std::size_t k = 0; k < 3; ++k) mean[k] = 0.5 * (before[k] + seen()[k]);
    interval_ = {.voltage = clarke(applied_(share, mean, kDc)),
                 .before = clarke(before), .current = clarke(seen())};
    angle_ = reference::wrapped(angle_ + speed_);
  }

  CurrentModel::In in() const {
    CurrentModel::In in;
    in.enable = true;
    in.i_u = word(seen()[0]);
    in.i_v = word(seen()[1]);
    in.v_dc = 2700;
    in.pattern = {.on_u = on_[0], .on_v = on_[1], .on_w = on_[2], .period = kPeriod,
                  .dead = dead_, .inverse = 18641};
    in.words = words();
    return in;
  }
  const reference::Interval& interval() const { return interval_; }
  double angle() const { return angle_; }

 private:
  // The third phase is minus the two others, after rounding as before.
  reference::Phases seen() const {
    const double u = value(word(i_.x)), v = value(word(-0.5 * i_.x + std::sqrt(0.75) * i_.y));
    return {u, v, -u - v};
  }

  reference::AppliedVoltage applied_;
  DeadClocks dead_;
  double angle_, speed_, i_delta_;
  int on_[3] = {kPeriod / 2, kPeriod / 2, kPeriod / 2};
  Vector i_;
  reference::Interval interval_;
};

reference::CurrentModelEstimator estimator() {
  return {motor(), {.k_e = 541 / 8192.0, .k_theta = 2 * kPi * 3277 / 16384.0}, 1};
}

double angle_of(Angle a) { return 2 * kPi * double(a.raw()) / (1 << 24); }
double turns_of(Turn t) { return double(t.raw()) / (1 << 23); }

// `inverse` and the rounded word per clock are off by 3e-5 and 4e-5 of up to 0.4: one place.  Four
// cuts of 1/16 clock, 0.4 places each; within a converter's step of zero the mean current is cut by
// half a place of 16: another 6/16 clocks, in each leg at worst; rounding, and v_dc's own half
// place.
TEST(AppliedVoltage, IsTheReferenceWithinItsRounding) {
  std::mt19937 any(1);
  const auto draw = [&](int a, int b) { return std::uniform_int_distribution<>(a, b)(any); };
  const reference::AppliedVoltage exact(
      {.period = kPeriod, .dead_time = 12, .small_current = 16 * kPlace});
  for (int n = 0; n < 20'000; ++n) {
    int on[3], u = draw(-9000, 9000), v = draw(-9000, 9000);
    for (int& clocks : on) clocks = draw(0, 9) == 0 ? draw(0, 1) * kPeriod : draw(20, kPeriod - 20);
    if (n % 3 == 0) u = draw(-40, 40);
    const auto got = applied_voltage({.on_u = on[0], .on_v = on[1], .on_w = on[2],
                                      .period = kPeriod, .dead = 192, .inverse = 18641},
                                     Int<17>(2 * u), Int<17>(2 * v), UInt<13>(5400));
    const Vector wanted = clarke(exact({double(on[0]) / kPeriod, double(on[1]) / kPeriod,
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
      auto exact = estimator();
      const auto begin = motor.in();
      CurrentModel::In reset = begin;
      reset.enable = false;
      reset.initial = Angle::of(std::llround(1 / (2 * kPi) * (1 << 24)));
      dut.tick(reset);
      exact.start(1, 0);
      double sum = 0;
      for (int n = 0; n < 6000; ++n) {
        motor.step();
        const auto out = dut.tick(motor.in());
        const auto& e = exact.update(motor.interval());
        if (n < 4000) continue;
        ASSERT_NEAR(reference::wrapped(angle_of(out.angle) - e.angle), 0, tolerance(turns))
            << turns << ' ' << i_delta << ' ' << n;
        ASSERT_NEAR(reference::wrapped(angle_of(out.angle) - motor.angle()), 0,
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
      CurrentModel::In reset = motor.in();
      reset.enable = false;
      dut.tick(reset);
      CurrentModel::Out out;
      for (int n = 0; n < 3000; ++n) {
        motor.step();
        out = dut.tick(motor.in());
      }
      EXPECT_NEAR(reference::wrapped(angle_of(out.angle) - motor.angle()), 0,
                  tolerance(turns) + 0.03) << sixteenth;
      EXPECT_EQ(out.step.negative(), turns < 0);
    }
  }
}

TEST(CurrentModel, WithoutEnableItStandsAtItsStart) {
  Turning motor(0, 0.01, 0.2, 192);
  CurrentModel dut;
  for (int n = 0; n < 100; ++n) {
    motor.step();
    dut.tick(motor.in());
  }
  CurrentModel::In off = motor.in();
  off.enable = false;
  off.initial = 0x123456;
  const auto out = dut.tick(off);
  EXPECT_EQ(out.angle, 0x123456);
  EXPECT_EQ(out.step, 0);
  motor.step();
  EXPECT_EQ(dut.tick(motor.in()).angle, 0x123456) << "begins at rest";
}

}  // namespace
}  // namespace steplock
