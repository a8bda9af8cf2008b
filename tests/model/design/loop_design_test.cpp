// Amano's Eqs. (1)-(17): the printed components come out, and the equations hold as identities.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "model/design/loop_filter.hpp"

namespace steplock::design {
namespace {

constexpr double kPi = std::numbers::pi;

// The paper's values, with K_L and f_m as its printed components imply them (NOTES.md).
constexpr LoopSpecification kPaper{
    .rho = 3, .zeta = 0.7, .lambda = 10, .n_c = 20, .f_m = 194.2, .k_l = 0.0189};
constexpr Components kPrinted{.c1 = 1.291e-6, .c2 = 11.621e-6, .r = 3.997e3};

TEST(LoopDesign, YieldsThePrintedComponentsWithKL00189) {
  const auto c = components(kPaper);
  // Three digits of K_L leave half a percent.
  EXPECT_NEAR(c.c1, kPrinted.c1, 0.005 * kPrinted.c1);
  EXPECT_NEAR(c.c2, kPrinted.c2, 0.005 * kPrinted.c2);
  EXPECT_NEAR(c.r, kPrinted.r, 0.005 * kPrinted.r);
}

TEST(LoopDesign, YieldsAnotherC1WithTheRoundedKLAndFmInPrint) {
  auto as_printed = kPaper;
  as_printed.k_l = 0.02;
  as_printed.f_m = 195;
  EXPECT_NEAR(components(as_printed).c1, 1.353e-6, 0.001e-6);
}

TEST(LoopDesign, HasThePrintedComponentsZeroAndCrossover) {
  EXPECT_NEAR(kPrinted.omega_z(), 21.53, 0.005);  // printed digits
  EXPECT_NEAR(kPrinted.omega_g(), 68.08, 0.05);
  EXPECT_NEAR(omega_g(kPaper), 68.08, 0.05);
  EXPECT_NEAR(loop_gain_for(kPrinted), 0.0189, 0.00005);
}

TEST(LoopDesign, LeadsBy54Point9DegreesAtTheCrossover) {
  const auto m = margins(open_loop(per_second(kPrinted, loop_gain_for(kPrinted))), 0.1, 1e5);
  EXPECT_NEAR(m.phase_deg, (std::atan(std::sqrt(10)) - std::atan(1 / std::sqrt(10))) * 180 / kPi,
              0.05);
  EXPECT_NEAR(m.phase_deg, 54.9, 0.05);
  EXPECT_NEAR(m.crossover, 68.08, 0.1);
}

TEST(LoopDesign, SettlesInNcCyclesToRhoPercent) {
  const double rest = std::exp(-kPaper.zeta * omega_n(kPaper) * settling_time(kPaper));
  EXPECT_NEAR(100 * rest, kPaper.rho, 1e-9);                              // Eq. (9), backwards
  EXPECT_NEAR(omega_g(kPaper), 2 * kPaper.zeta * omega_n(kPaper), 1e-9);  // Eq. (11)
}

// Eqs. (5)-(8) and (14) for any specification, not only the paper's.
TEST(LoopDesign, MeetsItsSpecificationWhateverItIs) {
  for (const double lambda : {2.0, 5.0, 10.0, 40.0}) {
    for (const double f_m : {10.0, 200.0, 5000.0}) {
      const LoopSpecification s{
          .rho = 5, .zeta = 0.7, .lambda = lambda, .n_c = 15, .f_m = f_m, .k_l = 0.3};
      const auto c = components(s);
      EXPECT_NEAR(c.omega_p() / c.omega_z(), lambda, 1e-9 * lambda);
      EXPECT_NEAR(c.omega_g(), omega_g(s), 1e-9 * omega_g(s));
      const auto h = open_loop(per_second(c, s.k_l))(omega_g(s));
      EXPECT_NEAR(std::abs(h), 1, 1e-9);
    }
  }
}

TEST(LoopDesign, IsTheImpedanceOfItsCircuit) {
  // C1 parallel to R and C2 in series, by Kirchhoff instead of Eq. (1).
  for (const double omega : {1.0, 21.5, 68.0, 300.0, 1e4}) {
    const std::complex<double> s(0, omega);
    const auto c1 = 1.0 / (s * kPrinted.c1), branch = kPrinted.r + 1.0 / (s * kPrinted.c2);
    const auto parallel = c1 * branch / (c1 + branch);
    EXPECT_NEAR(std::abs(kPrinted.impedance(s) / parallel - 1.0), 0, 1e-12);
    const auto f = per_second(kPrinted, 0.0189);
    EXPECT_NEAR(std::abs(open_loop(f)(omega) / (0.0189 * parallel / s) - 1.0), 0, 1e-12);
  }
}

TEST(LoopDesign, LosesPhaseBySamplingInProportionToTheDelay) {
  const auto f = per_second(kPrinted, 0.0189);
  const auto continuous = margins(open_loop(f), 0.1, 1e5);
  const double tick = 1e-4, interval = 2e-3;
  const auto sampled = margins(open_loop_sampled(f, tick, interval), 0.1, kPi / tick * 0.99);
  // Half an interval of held error, half a tick of held frequency, and half a tick each for the
  // rectangle of the integrators, of which one leads and one lags: about interval / 2 + tick.
  const double expected = continuous.phase_deg - 68.08 * (interval / 2 + tick / 2) * 180 / kPi;
  EXPECT_NEAR(sampled.phase_deg, expected, 0.5);
}

TEST(LoopDesign, PerStepKeepsItsDampingAtAnyBandwidth) {
  for (const double b : {0.1, 0.2, 0.4}) {
    const auto f = per_step(b, 1.0, 0);
    EXPECT_DOUBLE_EQ(f.proportional, 2 * b);
    EXPECT_DOUBLE_EQ(f.integral, b * b);
    const auto m = margins(open_loop(f), 1e-3, kPi * 0.999);
    EXPECT_GT(m.phase_deg, 45);  // a rule of thumb's lower end
    EXPECT_GT(m.gain_db, 6);
  }
}

TEST(LoopDesign, BodeCurveFallsAt40DecibelsPerDecadeBelowTheZero) {
  const auto curve = bode(open_loop(per_second(kPrinted, 0.0189)), 0.01, 0.1, 2);
  EXPECT_NEAR(curve[0].gain_db - curve[1].gain_db, 40, 0.01);
  EXPECT_NEAR(curve[0].phase_deg, -180, 0.1);
}

}  // namespace
}  // namespace steplock::design
