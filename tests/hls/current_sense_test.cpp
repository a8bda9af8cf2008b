// Offsets measured to the last place, currents without them, and over-current in any phase.

#include "hls/sinusoidal/current_sense.hpp"

#include <gtest/gtest.h>

#include <random>

namespace steplock {
namespace {

CurrentSense::Out sampled(CurrentSense& dut, int u, int v, bool calibrate = false,
                          int over = 32767) {
  const CurrentSense::Codes codes{.valid = true, .u = u, .v = v, .dc = 1234};
  dut.tick({.codes = codes, .calibrate = calibrate, .over_current = over});
  return dut.tick({.codes = {}, .calibrate = calibrate, .over_current = over});
}

TEST(CurrentSense, TheOffsetIsTheMeanOf16Samples) {
  std::mt19937 any(1);
  CurrentSense dut;
  int sum_u = 0, sum_v = 0;
  for (int n = 0; n < 16; ++n) {
    const int u = 40 + std::uniform_int_distribution<>(-3, 3)(any);
    const int v = -25 + std::uniform_int_distribution<>(-3, 3)(any);
    sum_u += u, sum_v += v;
    EXPECT_EQ(sampled(dut, u, v, true).measured, n == 15);
  }
  sampled(dut, 999, 999, true);  // one too many is not taken in
  const auto out = sampled(dut, 500, -700);
  EXPECT_EQ(out.i_u, 16 * 500 - sum_u);
  EXPECT_EQ(out.i_v, -16 * 700 - sum_v);
  EXPECT_EQ(out.v_dc, 1234);
}

TEST(CurrentSense, ASecondCalibrationForgetsTheFirst) {
  CurrentSense dut;
  for (int n = 0; n < 16; ++n) sampled(dut, 100, 100, true);
  sampled(dut, 0, 0);
  for (int n = 0; n < 16; ++n) sampled(dut, 3, -3, true);
  EXPECT_EQ(sampled(dut, 3, -3).i_u, 0);
  EXPECT_EQ(sampled(dut, 3, -3).i_v, 0);
}

TEST(CurrentSense, OverCurrentIsSeenInEachPhase) {
  CurrentSense dut;
  EXPECT_FALSE(sampled(dut, 99, -99, false, 1600).over);
  EXPECT_TRUE(sampled(dut, 101, -99, false, 1600).over);
  EXPECT_TRUE(sampled(dut, -99, 101, false, 1600).over);
  EXPECT_TRUE(sampled(dut, -60, -60, false, 1600).over) << "the third is minus both";
  EXPECT_FALSE(sampled(dut, -101, 0, true, 1600).over) << "no currents while offsets are measured";
}

// The level itself is not beyond it, and one place more is.
TEST(CurrentSense, OverCurrentBeginsBeyondTheLevel) {
  CurrentSense dut;
  EXPECT_FALSE(sampled(dut, 100, -100, false, 1600).over);
  EXPECT_TRUE(sampled(dut, 100, -100, false, 1599).over);
  EXPECT_FALSE(sampled(dut, -100, 0, false, 1600).over);
  EXPECT_TRUE(sampled(dut, -100, 0, false, 1599).over);
}

TEST(CurrentSense, ItLimitsInsteadOfWrapping) {
  CurrentSense dut;
  for (int n = 0; n < 16; ++n) sampled(dut, -100, 100, true);
  const auto out = sampled(dut, 2047, -2048);
  EXPECT_EQ(out.i_u, 32767);
  EXPECT_EQ(out.i_v, -32768);
}

}  // namespace
}  // namespace steplock
