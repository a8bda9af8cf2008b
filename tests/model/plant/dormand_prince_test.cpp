#include "model/plant/dormand_prince.hpp"

#include <gtest/gtest.h>

namespace steplock::plant {
namespace {

using Step = DormandPrinceStep<2, 1>;

// y0' = y1, y1' = -y0: (sin t, cos t).  The integrand is y0, its integral 1 - cos t.
const auto kOscillator = [](const Step::Values& y, Step::Values& slope, Step::Integrands& p) {
  slope = {y[1], -y[0]};
  p = {y[0]};
};

struct Errors {
  double end, inside, integral, estimate;
};

Errors errors_of_one_step(double h) {
  Step step;
  const double estimate = step.attempt({0, 1}, h, {1, 1}, kOscillator);
  step.prepare_dense();
  const double inside = 0.4 * h;
  return {std::abs(step.end()[0] - std::sin(h)), std::abs(step.at(inside)[0] - std::sin(inside)),
          std::abs(step.integrals(h)[0] - (1 - std::cos(h))), estimate};
}

double order(double coarse, double fine) { return std::log2(coarse / fine); }

TEST(DormandPrince, LocalErrorsHaveTheOrdersOfTheMethod) {
  const Errors coarse = errors_of_one_step(0.4), fine = errors_of_one_step(0.2);
  EXPECT_GT(order(coarse.end, fine.end), 5.7);  // fifth-order step: h^6
  EXPECT_GT(order(coarse.integral, fine.integral), 5.7);
  EXPECT_GT(order(coarse.inside, fine.inside), 4.7);  // fourth-order dense output: h^5
  EXPECT_NEAR(order(coarse.estimate, fine.estimate), 5, 0.5);
}

TEST(DormandPrince, TheEstimateBoundsTheErrorOfTheEndAndOfTheDenseOutput) {
  for (double h : {0.05, 0.1, 0.3, 0.6}) {
    const Errors e = errors_of_one_step(h);
    EXPECT_LT(e.end, e.estimate) << h;
    EXPECT_LT(e.inside, e.estimate) << h;
  }
}

TEST(DormandPrince, DenseOutputMeetsBothEnds) {
  Step step;
  step.attempt({0.3, 1}, 0.5, {1, 1}, kOscillator);
  step.prepare_dense();
  for (int n = 0; n < 2; ++n) {
    EXPECT_DOUBLE_EQ(step.at(0)[n], step.begin()[n]);
    EXPECT_NEAR(step.at(0.5)[n], step.end()[n], 1e-15);
  }
  EXPECT_EQ(step.integrals(0)[0], 0);
}

}  // namespace
}  // namespace steplock::plant
