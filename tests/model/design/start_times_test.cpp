// Amano's Eqs. (18)-(23).
#include <gtest/gtest.h>

#include "model/design/start.hpp"

namespace steplock::design {
namespace {

constexpr double kInertia = 2.7e-3, kKappa = 0.7, kGamma = 4.28;

TEST(StartTimes, Equation22GivesLessThanThePrintedResetTime) {
  EXPECT_NEAR(align_time(kKappa, kInertia, kGamma), 0.266, 0.0005);  // printed: 0.622 s
}

TEST(StartTimes, ResetTimeIsTheInverseOfTheResonance) {
  EXPECT_NEAR(align_time(kKappa, kInertia, kGamma) * align_resonance(kKappa, kInertia, kGamma), 1,
              1e-12);
}

TEST(StartTimes, Equation23WithThePrintedTimeNeedsKv00184) {
  EXPECT_NEAR(acceleration_time(83.3, kInertia, 0.0184, 0.0383), 0.108, 0.0005);
}

// The torque of the reset pattern: current I into W, half of it out of U and V each, against the
// sinusoidal back-EMF shapes; its slope at the resting place is kappa.
TEST(StartTimes, StiffnessIsTheSlopeOfTheResetTorque) {
  const double flux = 0.00957, current = 10;
  const int pole_pairs = 2;
  const auto torque = [&](double mechanical) {
    const double theta = 240 * std::numbers::pi / 180 + pole_pairs * mechanical;
    const double third = 2 * std::numbers::pi / 3;
    return flux * pole_pairs *
           (current / 2 * std::sin(theta) + current / 2 * std::sin(theta - third) -
            current * std::sin(theta - 2 * third));
  };
  const double step = 1e-5;
  EXPECT_NEAR(torque(0), 0, 1e-12);
  EXPECT_NEAR((torque(-step) - torque(step)) / (2 * step),
              align_stiffness(flux, pole_pairs, current), 1e-6);
}

}  // namespace
}  // namespace steplock::design
