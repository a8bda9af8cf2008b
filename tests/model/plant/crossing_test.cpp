#include "model/plant/crossing.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace steplock::plant {
namespace {

TEST(Crossing, ReturnsANegativePointWithinTheToleranceOfTheRoot) {
  const auto f = [](double x) { return std::cos(x); };
  const double x = falls_below_zero(f, 1, f(1), 2, f(2), 1e-12);
  EXPECT_LT(f(x), 0);
  EXPECT_NEAR(x, std::acos(0.0), 1e-12);
}

TEST(Crossing, StartsOnARootAndStillFindsTheFall) {
  const auto f = [](double x) { return x * (0.3 - x); };  // zero, up, and down through 0.3
  EXPECT_NEAR(falls_below_zero(f, 0, f(0), 1, f(1), 1e-12), 0.3, 1e-12);
}

TEST(Crossing, AStepOrAFlatTailTakesAtMostFourTimesBisection) {
  int calls = 0;
  const auto cliff = [&](double x) { return ++calls, x < 0.9 ? 1e-9 : -1e9; };
  EXPECT_NEAR(falls_below_zero(cliff, 0, 1e-9, 1, -1e9, 1e-12), 0.9, 1e-12);
  EXPECT_LE(calls, 160);  // four rounds per halving of a bracket of 1e12 tolerances
  calls = 0;
  const auto tail = [&](double x) { return ++calls, std::pow(1 - x, 9) - 1e-6; };
  const double root = 1 - std::pow(1e-6, 1.0 / 9);
  EXPECT_NEAR(falls_below_zero(tail, 0, tail(0), 1, tail(1), 1e-12), root, 1e-12);
  EXPECT_LE(calls, 160);  // four rounds per halving of a bracket of 1e12 tolerances
}

TEST(Crossing, ASmoothFunctionTakesAThirdOfBisection) {
  int calls = 0;
  const auto f = [&](double x) { return ++calls, std::exp(-x) - 0.7; };
  falls_below_zero(f, 0, f(0), 1, f(1), 1e-12);
  EXPECT_LE(calls, 14);
}

}  // namespace
}  // namespace steplock::plant
