// Both estimators on a motor whose mean voltages and sampled currents are known in closed form.
#include <gtest/gtest.h>

#include <complex>

#include "model/reference/sinusoidal/current_model.hpp"

namespace steplock::reference::sinusoidal {
namespace {

using Complex = std::complex<double>;
constexpr Complex kJ{0, 1};
constexpr double kPeriod = 200e-6;

const design::sinusoidal::Motor kMotor{.resistance = 1.91, .inductance_d = 14.3e-3,
                                       .inductance_q = 14.3e-3, .k_e = 0.332, .pole_pairs = 3};

// Constant current i_d + j i_q in rotor coordinates at a constant speed.
struct Motor {
  double w;
  Complex current;
  double angle(int n) const { return w * n * kPeriod; }
  Complex at(int n) const { return current * std::exp(kJ * angle(n)); }

  // i and the EMF turn with the rotor, so the mean of v over an interval is an integral of e^{jwt}.
  Interval interval(int n) const {
    const Complex turning = (std::exp(kJ * angle(n)) - std::exp(kJ * angle(n - 1))) / (kJ * w * kPeriod);
    const Complex v = kMotor.resistance * current * turning + kJ * w * kMotor.k_e * turning +
                      kMotor.inductance_q * (at(n) - at(n - 1)) / kPeriod;
    return {{v.real(), v.imag()}, {at(n - 1).real(), at(n - 1).imag()}, {at(n).real(), at(n).imag()}};
  }
};

template <class E>
struct Run {
  double error = 0, speed = 0;
};
template <class E>
Run<E> follow(E estimator, const Motor& motor, double first_error, double first_speed, int samples) {
  estimator.start(-first_error, first_speed);
  Estimate e;
  for (int n = 1; n <= samples; ++n) e = estimator.update(motor.interval(n));
  return {wrapped(motor.angle(samples) - e.angle), e.speed};
}

VoltageModelEstimator voltage_model(int average = 8) {
  return {kMotor, {.k_sp = 2 / kMotor.k_e, .k_si = 20 / kMotor.k_e, .samples = average}, kPeriod};
}
CurrentModelEstimator current_model(double k_em = 1, double gain = 2) {
  design::sinusoidal::Motor believed = kMotor;
  believed.k_e *= k_em;
  return {believed, {.k_e = 8, .k_theta = gain * kMotor.inductance_q / believed.k_e}, kPeriod};
}

TEST(SinusoidalEstimators, FindTheAngleFrom40DegreesInBothDirectionsMotoringAndRegenerating) {
  for (const double w : {30.0, 377.0, -30.0, -377.0}) {
    for (const double i_q : {-9.65, 0.0, 9.65}) {
      const Motor motor{w, {0, i_q}};
      for (const double error : {0.7, -0.7}) {
        // Twenty radians at a gain of 2 each: e^-40 is nothing; discretisation is of (w T)^2 / 12, 5e-4.
        const int samples = static_cast<int>(20 / std::abs(w) / kPeriod) + 1500;
        const auto a = follow(current_model(), motor, error, 0.8 * w, samples);
        EXPECT_NEAR(a.error, 0, 1e-3) << w << ' ' << i_q;
        EXPECT_NEAR(a.speed, w, 1e-3 * std::abs(w));
        const auto b = follow(voltage_model(), motor, error, 0.8 * w, 4 * samples);
        EXPECT_NEAR(b.error, 0, 1e-3) << w << ' ' << i_q;
        EXPECT_NEAR(b.speed, w, 1e-3 * std::abs(w));
      }
    }
  }
}

// Eq. (16): one step from the right e_c, with the frame astray by d theta.
TEST(SinusoidalEstimators, TheCurrentErrorIsEquation16) {
  const Motor motor{100, {0, 5}};
  for (const double error : {-0.3, 0.1, 0.3}) {
    CurrentModelEstimator estimator = current_model();
    estimator.start(motor.angle(1) - error, 100);  // at the first sample
    const Estimate e = estimator.update(motor.interval(1));
    const double emf = kMotor.k_e * 100;
    EXPECT_NEAR(e.error, emf * std::sin(error), 1e-3 * emf);
    // Delta i_delta = -(T/L)(e cos - e_c), so e_c moves by K_e of that.
    const double delta_i = -kPeriod / kMotor.inductance_q * emf * (std::cos(error) - 1);
    EXPECT_NEAR(e.emf, emf - 8 * delta_i, 1e-3 * emf);
  }
}

// Eqs. (7) and (9) in the same place.
TEST(SinusoidalEstimators, TheVoltageModelSeesTheProjectionsOfTheEmf) {
  const Motor motor{100, {0, 5}};
  for (const double error : {-0.3, 0.1, 0.3}) {
    VoltageModelEstimator estimator = voltage_model(1);
    estimator.start(motor.angle(1) - error, 100);  // at the first sample
    const Estimate e = estimator.update(motor.interval(1));
    const double emf = kMotor.k_e * 100;
    EXPECT_NEAR(e.error, -emf * std::sin(error), 1e-3 * emf);
    EXPECT_NEAR(e.emf, emf * std::cos(error), 1e-3 * emf);
  }
}

// With K_EM = 1.25 K_E, e_c / K_EM is a fifth short, and the gamma error makes up for it: the angle is
// off until cos d theta + gain sin d theta = 1.25, the speed by nothing.
TEST(SinusoidalEstimators, AWrongEmfConstantCostsAKnownAngleAndNoSpeed) {
  for (const double w : {30.0, 300.0}) {
    const Motor motor{w, {0, 5}};
    const auto r = follow(current_model(1.25, 2), motor, 0, w, 20000);
    EXPECT_NEAR(std::cos(r.error) + 2 * std::sin(r.error), 1.25, 2e-3);
    EXPECT_LT(std::abs(r.error), 0.2);
    EXPECT_NEAR(r.speed, w, 1e-4 * w);
  }
}

TEST(SinusoidalEstimators, TheyConvergeFromAllRoundInBothDirections) {
  for (const double w : {100.0, -100.0}) {
    const Motor motor{w, {0, 3}};
    for (double error = -3; error < 3.1; error += 0.5) {
      EXPECT_NEAR(follow(current_model(), motor, error, 0, 20000).error, 0, 1e-3) << w << ' ' << error;
      EXPECT_NEAR(follow(voltage_model(), motor, error, 0, 40000).error, 0, 1e-3) << w << ' ' << error;
    }
  }
}

TEST(SinusoidalEstimators, TheMovingAverageTakesNoiseAway) {
  const Motor motor{100, {0, 3}};
  double scatter[2];
  for (const int average : {1, 8}) {
    VoltageModelEstimator estimator = voltage_model(average);
    estimator.start(0, 100);
    double squares = 0;
    for (int n = 1; n <= 2000; ++n) {
      Interval i = motor.interval(n);
      i.current.y += 0.01 * (n % 2 == 0 ? 1 : -1);  // ripple
      if (n > 500) squares += std::pow(estimator.update(i).emf - kMotor.k_e * 100, 2);
      else estimator.update(i);
    }
    scatter[average == 8] = std::sqrt(squares / 1500);
  }
  EXPECT_LT(scatter[1], scatter[0] / 6);
}

}  // namespace
}  // namespace steplock::reference::sinusoidal
