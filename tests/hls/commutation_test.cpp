#include "hls/six_step/commutation.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>

namespace steplock {
namespace {

// A leg as one letter: H or L on, - off, X both.
std::string legs(const Gates& gates) {
  const auto leg = [](bool high, bool low) { return high ? (low ? 'X' : 'H') : (low ? 'L' : '-'); };
  return {leg(gates.uh, gates.ul), leg(gates.vh, gates.vl), leg(gates.wh, gates.wl)};
}

std::string request(Pattern pattern, int step, bool chop, bool complementary = false) {
  Commutation dut;
  return legs(dut.tick(
      {.pattern = pattern, .legs = Commutation::legs(step), .chop = chop, .complementary = complementary}));
}

TEST(Commutation, EachStepDrivesItsTwoPhasesAndFloatsTheThird) {
  const std::array<std::string, 6> steps = {"HL-", "H-L", "-HL", "LH-", "L-H", "-LH"};
  for (int k = 0; k < 6; ++k) EXPECT_EQ(request(Pattern::kDrive, k, true), steps[k]) << k;
}

TEST(Commutation, HighSideChoppingOpensTheUpperGateAlone) {
  const std::array<std::string, 6> steps = {"-L-", "--L", "--L", "L--", "L--", "-L-"};
  for (int k = 0; k < 6; ++k) EXPECT_EQ(request(Pattern::kDrive, k, false), steps[k]) << k;
}

TEST(Commutation, ComplementaryChoppingClosesTheLowerGateOfTheSameLeg) {
  const std::array<std::string, 6> steps = {"LL-", "L-L", "-LL", "LL-", "L-L", "-LL"};
  for (int k = 0; k < 6; ++k) EXPECT_EQ(request(Pattern::kDrive, k, false, true), steps[k]) << k;
}

TEST(Commutation, SettleIsStepOneWhateverTheStep) {
  for (int k = 0; k < 8; ++k) {
    for (const bool chop : {false, true}) {
      for (const bool complementary : {false, true}) {
        EXPECT_EQ(request(Pattern::kPreAlign, k, chop, complementary),
                  request(Pattern::kDrive, 1, chop, complementary));
      }
    }
  }
}

TEST(Commutation, ResetHoldsWithTwoHighAndOneLow) {
  for (int k = 0; k < 8; ++k) {
    EXPECT_EQ(request(Pattern::kAlign, k, true), "HHL");
    EXPECT_EQ(request(Pattern::kAlign, k, false), "--L");
    EXPECT_EQ(request(Pattern::kAlign, k, false, true), "LLL");
  }
}

TEST(Commutation, BrakeShortsTheWindingsWhileThePwmIsOn) {
  for (int k = 0; k < 8; ++k) {
    for (const bool complementary : {false, true}) {
      EXPECT_EQ(request(Pattern::kBrake, k, true, complementary), "LLL");
      EXPECT_EQ(request(Pattern::kBrake, k, false, complementary), "---");
    }
  }
}

TEST(Commutation, OffRequestsNothing) {
  for (int k = 0; k < 8; ++k) {
    for (const bool chop : {false, true}) {
      EXPECT_EQ(request(Pattern::kOff, k, chop, true), "---");
    }
  }
}

TEST(Commutation, StepsThatDoNotExistRequestNothing) {
  for (const int k : {6, 7}) EXPECT_EQ(request(Pattern::kDrive, k, true, true), "---");
}

TEST(Commutation, NeverRequestsBothGatesOfALeg) {
  for (const Pattern pattern :
       {Pattern::kOff, Pattern::kDrive, Pattern::kPreAlign, Pattern::kAlign, Pattern::kBrake}) {
    for (int bits = 0; bits < 32; ++bits) {
      const auto seen = request(pattern, bits >> 2, (bits & 1) != 0, (bits & 2) != 0);
      EXPECT_EQ(seen.find('X'), std::string::npos) << seen;
    }
  }
}

}  // namespace
}  // namespace steplock
