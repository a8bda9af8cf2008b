#include "testbench/drive_file/quantity.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace steplock {
namespace {

constexpr double kPi = std::numbers::pi;

double si(const char* text) {
  const auto q = parse_quantity(text);
  return q ? q->value : std::numeric_limits<double>::quiet_NaN();
}

bool fits(const char* wanted, const char* given) {
  return parse_unit(wanted)->accepts(*parse_unit(given));
}

TEST(Quantity, PrefixesScaleTheBase) {
  EXPECT_DOUBLE_EQ(si("188 uH"), 188e-6);
  EXPECT_DOUBLE_EQ(si("30kHz"), 30e3 * 2 * kPi);
  EXPECT_DOUBLE_EQ(si("2.7e-3 kg m^2"), 2.7e-3);
  EXPECT_DOUBLE_EQ(si("100 g cm^2"), 1e-5);
  EXPECT_DOUBLE_EQ(si("0.5 mN m"), 0.5e-3);
  EXPECT_DOUBLE_EQ(si("5 m"), 5);
  EXPECT_DOUBLE_EQ(si("2 min"), 120);
}

TEST(Quantity, DivisionTakesTheOneFactorBehindIt) {
  EXPECT_DOUBLE_EQ(si("6 V s/rad"), 6);
  EXPECT_TRUE(fits("N m s/rad", "mN m/rad s"));
  EXPECT_TRUE(fits("V s", "V/s s^2"));
}

// The catalogue's V/Hz is a flux of 1/2pi per radian: the classic mistake of transcription.
TEST(Quantity, VoltsPerHertzBecomeFluxPerRadian) {
  EXPECT_NEAR(si("0.0327 V/Hz"), 0.0327 / (2 * kPi), 1e-15);
  EXPECT_TRUE(fits("V s/rad", "V/Hz"));
}

TEST(Quantity, SpeedsInAnyUnitAgree) {
  EXPECT_NEAR(si("3000 rpm"), si("50 Hz"), 1e-9);
  EXPECT_NEAR(si("3000 rpm"), si("314.159265358979 rad/s"), 1e-9);
  EXPECT_NEAR(si("360 deg"), si("1 turn"), 1e-12);
}

TEST(Quantity, AnAngleIsADimensionUnlessDividedBy) {
  EXPECT_FALSE(fits("rpm", "1/s"));
  EXPECT_FALSE(fits("s", "deg"));
  EXPECT_TRUE(fits("V s/rad", "V s"));
  EXPECT_TRUE(fits("V s/rad", "mWb"));
  EXPECT_FALSE(fits("V s", "V s/rad"));
}

TEST(Quantity, OtherDimensionsAreRefused) {
  EXPECT_FALSE(fits("ohm", "V"));
  EXPECT_FALSE(fits("H", "F"));
  EXPECT_FALSE(fits("N m", "N"));
}

TEST(Quantity, NonsenseIsNoQuantity) {
  for (const char* text : {"", "ohm", "3 parsec", "3 V/", "3 */ V", "3 V^x", "nan", "inf s", "1,5 V"}) {
    EXPECT_FALSE(parse_quantity(text)) << text;
  }
}

}  // namespace
}  // namespace steplock
