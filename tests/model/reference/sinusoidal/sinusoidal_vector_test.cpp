#include "model/reference/sinusoidal/vector.hpp"

#include <gtest/gtest.h>

namespace steplock::reference::sinusoidal {
namespace {

constexpr double kThird = 2 * kPi / 3;

// Eq. (3), written out.
TEST(SinusoidalVector, ClarkeThenParkIsEquation3) {
  for (double c = -4; c < 4; c += 0.37) {
    const Phases p = {1.3, -2.1, 0.8};
    const Vector v = seen_from(c, clarke(p));
    double gamma = 0, delta = 0;
    for (int k = 0; k < 3; ++k) {
      gamma += std::sqrt(2.0 / 3) * std::cos(c - k * kThird) * p[k];
      delta -= std::sqrt(2.0 / 3) * std::sin(c - k * kThird) * p[k];
    }
    EXPECT_NEAR(v.x, gamma, 1e-12);
    EXPECT_NEAR(v.y, delta, 1e-12);
  }
}

TEST(SinusoidalVector, PowerIsTheSameInPhasesAndVectors) {
  const Phases v = {100, -30, -70}, i = {3, 1, -4};
  const Vector a = seen_from(0.7, clarke(v)), b = seen_from(0.7, clarke(i));
  EXPECT_NEAR(a.x * b.x + a.y * b.y, v[0] * i[0] + v[1] * i[1] + v[2] * i[2], 1e-9);
}

TEST(SinusoidalVector, BackAndForthChangesNothing) {
  const Phases p = {1, 2, -3};
  const Phases back = phases(from_frame(1.1, seen_from(1.1, clarke(p))));
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(back[k], p[k], 1e-12);
}

}  // namespace
}  // namespace steplock::reference::sinusoidal
