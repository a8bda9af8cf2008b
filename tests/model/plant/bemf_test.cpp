#include "model/plant/bemf.hpp"

#include <gtest/gtest.h>

#include "tests/model/plant/six_step.hpp"

namespace steplock::plant {
namespace {

using Kind = BackEmfShape::Kind;

std::vector<BackEmfShape> all_shapes() {
  BackEmfShape table = {.kind = Kind::kTable};
  for (int n = 0; n < 48; ++n) {  // a sine with a fifth harmonic
    table.table.push_back(std::sin(kTurn * n / 48) + 0.05 * std::sin(5 * kTurn * n / 48));
  }
  return {{.kind = Kind::kSinusoidal},
          {},
          {.flat_top_deg = 100, .rounded_flanks = true},
          {.flat_top_deg = 0},
          table};
}

TEST(BackEmf, CrossesZeroRisingAtZeroAndIsOddAndHalfWaveSymmetric) {
  for (const BackEmfShape& shape : all_shapes()) {
    const BackEmf bemf(shape);
    EXPECT_NEAR(bemf.at(0), 0, 1e-12);
    EXPECT_GT(bemf.at(0.01), 0);
    for (double angle = -7; angle < 7; angle += 0.137) {
      EXPECT_NEAR(bemf.at(-angle), -bemf.at(angle), 1e-12) << angle;
      EXPECT_NEAR(bemf.at(angle + kTurn / 2), -bemf.at(angle), 1e-12) << angle;
    }
  }
}

TEST(BackEmf, PhasesVAndWFollow120And240DegreesLater) {
  for (const BackEmfShape& shape : all_shapes()) {
    const BackEmf bemf(shape);
    for (double angle = -7; angle < 7; angle += 0.137) {
      const Phases at = bemf(bemf.piece(angle, 1), angle);
      EXPECT_NEAR(at[1], bemf.at(angle - kThirdTurn), 1e-12) << angle;
      EXPECT_NEAR(at[2], bemf.at(angle - 2 * kThirdTurn), 1e-12) << angle;
    }
  }
}

TEST(BackEmf, TrapezoidIsFlatOverItsTopAndStraightOnItsFlank) {
  const BackEmf bemf(BackEmfShape{.flat_top_deg = 120});
  for (double degree = 30.001; degree < 150; degree += 7) {
    EXPECT_DOUBLE_EQ(bemf.at(degree * kDegree), 1);
  }
  EXPECT_NEAR(bemf.at(15 * kDegree), 0.5, 1e-12);
  EXPECT_NEAR(bemf.at(-6 * kDegree), -0.2, 1e-12);
}

TEST(BackEmf, RoundedFlankMeetsTheTopWithoutACorner) {
  const BackEmf bemf(BackEmfShape{.flat_top_deg = 120, .rounded_flanks = true});
  const double top = 30 * kDegree, d = 1e-5;
  EXPECT_NEAR(bemf.at(top - d), 1, 10 * d * d);  // no linear term
  EXPECT_NEAR(bemf.at(top + d), 1, 1e-15);
}

TEST(BackEmf, PiecesMeetAtTheirEndsAndCoverTheTurnInTwelveOrFewer) {
  for (const BackEmfShape& shape : {BackEmfShape{}, BackEmfShape{.flat_top_deg = 100}}) {
    const BackEmf bemf(shape);
    double angle = 0.1;
    int pieces = 0;
    for (; angle < 0.1 + kTurn; ++pieces) {
      const auto here = bemf.piece(angle, 1);
      const auto next = bemf.piece(here.high, 1);
      ASSERT_GT(here.high, angle);
      for (int k = 0; k < 3; ++k) {
        EXPECT_NEAR(bemf(here, here.high)[k], bemf(next, here.high)[k], 1e-12);
      }
      EXPECT_NEAR(bemf.piece(here.high, -1).high, here.high, 1e-12);  // and back again
      angle = here.high;
    }
    EXPECT_LE(pieces, 13);
  }
}

TEST(BackEmf, SplineFollowsASineToFourthOrder) {
  BackEmfShape coarse = {.kind = Kind::kTable}, fine = coarse;
  for (int n = 0; n < 24; ++n) coarse.table.push_back(std::sin(kTurn * n / 24));
  for (int n = 0; n < 48; ++n) fine.table.push_back(std::sin(kTurn * n / 48));
  const auto worst = [](const BackEmf& bemf) {
    double error = 0;
    for (double angle = 0; angle < kTurn; angle += 0.001) {
      error = std::max(error, std::abs(bemf.at(angle) - std::sin(angle)));
    }
    return error;
  };
  const double ratio = worst(BackEmf(coarse)) / worst(BackEmf(fine));
  EXPECT_NEAR(ratio, 16, 1.5);
}

// Within the bound of a cubic spline, 5/384 h^4 of a fourth derivative of 1.
TEST(BackEmf, TheLastIntervalOfATableEndsAtItsFirstValue) {
  BackEmfShape cosine = {.kind = Kind::kTable};
  for (int n = 0; n < 24; ++n) cosine.table.push_back(std::cos(kTurn * n / 24));
  const double angle = kTurn * 23.5 / 24, step = kTurn / 24;
  EXPECT_NEAR(BackEmf(cosine).at(angle), std::cos(angle), 5.0 / 384 * std::pow(step, 4));
}

}  // namespace
}  // namespace steplock::plant
