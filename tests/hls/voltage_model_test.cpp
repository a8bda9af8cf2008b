// The voltage-model estimator against its reference in doubles, on the same currents and patterns
// of a motor that turns.

#include "hls/sinusoidal/voltage_model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "model/reference/sinusoidal/voltage_model.hpp"
#include "tests/hls/plain_estimator.hpp"
#include "tests/hls/turning_motor.hpp"

namespace steplock {
namespace {

using namespace turning;

// L / K_E of this motor in u0.15, 2 L / K_E in u1.14, and ten times that in a second in u-8.23.
constexpr int kEmf = 3275, kTheta = 3277, kSi = 839;

VoltageModel::In in_of(const Turning& motor, bool average) {
  auto in = motor.in<VoltageModel::In>();
  in.config = {.average = average, .decay = kDecay, .gain = kGain, .k_emf = kEmf,
              .k_theta = kTheta, .k_si = kSi};
  return in;
}

// What the words mean, per volt of an EMF, which moves the current by T/L.
exact::VoltageModelEstimator estimator(bool average) {
  const double gain = kGain / 8192.0;
  return {motor(), {.k_sp = 2 * kPi * kTheta / 16384.0 * gain,
                    .k_si = 2 * kPi * kSi / 8388608.0 * gain, .samples = average ? 8 : 1}, 1};
}

// Per sample, Delta i is off by at most 12 places of 2^-16: the voltage's 6 places of 2^-15 times
// the gain, two roundings of the free current, sine and cosine by 2 places of up to 0.2, two more
// roundings.  The loop takes 2 (2 pi f) of an angle's error away per sample, so that a lasting
// error of the current ends at 12 places (k_theta + k_emf) / (4 pi f).
double tolerance(double turns) {
  return 2 * kPi * 12 / 65536.0 * (0.2 + 0.1) / (4 * kPi * std::abs(turns));
}

TEST(VoltageModel, InStepItIsTheReferenceWithinItsRounding) {
  for (const bool average : {false, true}) {
    for (const double turns : {0.0024, 0.01, -0.01, 0.025}) {
      for (const double i_delta : {0.0, 0.25, -0.2}) {
        // Without current, dead time would be noise: whose sign, nobody knows.
        Turning motor(1, turns, i_delta, i_delta == 0 ? 0 : 192);
        VoltageModel dut;
        auto reference = estimator(average);
        auto reset = in_of(motor, average);
        reset.enable = false;
        reset.initial = Angle::of(std::llround(1 / (2 * kPi) * (1 << 24)));
        dut.tick(reset);
        reference.start(1, 0);
        double sum = 0;
        for (int n = 0; n < 8000; ++n) {
          motor.step();
          const auto out = dut.tick(in_of(motor, average));
          const auto& e = reference.update(motor.interval());
          if (n < 6000) continue;
          ASSERT_NEAR(exact::wrapped(angle_of(out.angle) - e.angle), 0, tolerance(turns))
              << average << ' ' << turns << ' ' << i_delta << ' ' << n;
          ASSERT_NEAR(exact::wrapped(angle_of(out.angle) - motor.angle()), 0,
                      tolerance(turns) + 0.03) << "the motor's own angle";
          sum += turns_of(out.step);
        }
        // A lock cannot drift: the mean step is the motor's, but for an angle's error at both ends.
        EXPECT_NEAR(sum / 2000, turns, 2 * tolerance(turns) / 2000 + 1e-7);
      }
    }
  }
}

// Without the mean an EMF's noise is the speed's: with it the step varies less.
TEST(VoltageModel, TheMeanOf8SamplesSteadiesTheStep) {
  double varies[2] = {};
  for (const bool average : {false, true}) {
    Turning motor(0, 0.01, 0.2, 192);
    VoltageModel dut;
    for (int n = 0; n < 8000; ++n) {
      motor.step();
      const auto out = dut.tick(in_of(motor, average));
      if (n < 6000) continue;
      const double off = turns_of(out.emf_step) - 0.01;
      varies[average] += off * off / 2000;
    }
  }
  // Independent errors would vary by an eighth; those of rounded on-times repeat as the rotor
  // turns, and do not all go: a quarter.
  EXPECT_LT(varies[1], varies[0] / 4);
}

TEST(VoltageModel, ItConvergesFromAllRoundInBothDirections) {
  for (const double turns : {0.01, -0.01}) {
    for (int sixteenth = 0; sixteenth < 16; ++sixteenth) {
      Turning motor(2 * kPi * sixteenth / 16, turns, 0.1, 192);
      VoltageModel dut;
      auto reset = in_of(motor, true);
      reset.enable = false;
      dut.tick(reset);
      VoltageModel::Out out;
      for (int n = 0; n < 12'000; ++n) {  // six time constants K_SP / K_SI
        motor.step();
        out = dut.tick(in_of(motor, true));
      }
      EXPECT_NEAR(exact::wrapped(angle_of(out.angle) - motor.angle()), 0,
                  tolerance(turns) + 0.03) << sixteenth;
      EXPECT_EQ(out.step.negative(), turns < 0);
    }
  }
}

TEST(VoltageModel, WithoutEnableItStandsAtItsStart) {
  Turning motor(0, 0.01, 0.2, 192);
  VoltageModel dut;
  for (int n = 0; n < 100; ++n) {
    motor.step();
    dut.tick(in_of(motor, true));
  }
  auto off = in_of(motor, true);
  off.enable = false;
  off.initial = 0x123456;
  const auto out = dut.tick(off);
  EXPECT_EQ(out.angle, 0x123456);
  EXPECT_EQ(out.step, 0);
  motor.step();
  EXPECT_EQ(dut.tick(in_of(motor, true)).angle, 0x123456) << "begins at rest";
}

struct PlainCorrectedSpeed {
  std::array<plain::Integer, 8> recent = {};  // Delta i_delta, the last one first
  plain::Integer integral = 0;                // s-4.31

  struct Turned {
    plain::Integer emf_step, pull;
  };
  Turned follow(plain::Integer gamma, plain::Integer delta, const VoltageModelConfig& c) {
    using namespace plain;
    std::rotate(recent.begin(), recent.end() - 1, recent.end());
    recent[0] = delta;
    const Integer emf = c.average ? std::accumulate(recent.begin(), recent.end(), Integer{0}) : 8 * delta;
    integral = held(integral + nearest(gamma * of(c.k_si), 8), 28);
    return {held(nearest(-emf * of(c.k_emf), 11), 20), nearest(gamma * of(c.k_theta), 7) + down(integral, 8)};
  }
  void rest() { *this = {}; }
};

TEST(VoltageModel, EqualsItsEquationsInPlainIntegers) {
  const auto any_gains = [](plain::Drawn& any, VoltageModelConfig& c) {
    c.average = any.one_in(2);
    any.into(c.k_emf), any.into(c.k_theta), any.into(c.k_si);
    if (any.one_in(2)) c.k_emf = any.between(0, 9000), c.k_theta = any.between(0, 4000), c.k_si = any.between(0, 900);
  };
  for (std::uint32_t seed = 1; seed <= 10; ++seed)
    EXPECT_EQ((plain::differences<VoltageModel, PlainCorrectedSpeed>(seed, 20'000, any_gains)), 0) << seed;
}

}  // namespace
}  // namespace steplock
