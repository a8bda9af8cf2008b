// The three forms of the drive against each other, each time with a negative control.
#include "testbench/compare/compare.hpp"

#include <gtest/gtest.h>

#include "model/design/design.hpp"
#include "tests/testbench/short_drive.hpp"

namespace steplock {
namespace {

// To lock and a little beyond: comparing takes every clock of both forms.
design::Settings until_steady() {
  design::Settings s = short_drive();
  s.scenario.load_step_s.reset();
  s.scenario.load_off_s.reset();
  s.scenario.reverse_s.reset();
  s.scenario.stop_s.reset();
  s.scenario.duration_s = 0.55;
  return s;
}

TEST(Compare, RtlEqualsFixedOnEveryClockAndFloatStaysWithinTheBudget) {
  const Comparison c = compare_engines(until_steady(), {});
  EXPECT_EQ(c.lockstep.clocks, 6600000u);
  EXPECT_TRUE(c.lockstep.equal()) << c.lockstep.first_port << " at " << c.lockstep.first_clock;
  EXPECT_GT(c.shadow.count, 100u);
  EXPECT_EQ(c.shadow.signals.size(), 6u);
  EXPECT_TRUE(c.shadow.within()) << to_text(c.shadow);
  EXPECT_TRUE(c.passed());
}

// A level is looked at a few times in a step; so it is wrong for a whole one, in lock.
TEST(Compare, AComparatorThatTheRtlSeesInvertedForOneStepIsFound) {
  constexpr std::uint64_t kFrom = 3000000, kStep = 10000;  // 1200 steps per second at 12 MHz
  const Comparison c = compare_engines(
      until_steady(), {.wrong_from_clock = kFrom, .wrong_to_clock = kFrom + kStep});
  EXPECT_FALSE(c.lockstep.equal());
  EXPECT_GE(c.lockstep.first_clock, kFrom);
  EXPECT_LT(c.lockstep.first_clock, kFrom + kStep + 10);
  EXPECT_FALSE(c.lockstep.first_port.empty());
  EXPECT_FALSE(c.passed());
  EXPECT_FALSE(to_json(c)["rtl_equals_fixed"]["equal"].get<bool>());
}

// At a steady speed a loop has nothing to do, whatever its gain.  A rotor out of balance swings by some degrees in each turn.
design::Settings out_of_balance() {
  design::Settings s = until_steady();
  s.motor.cogging_nm = 0.01, s.motor.cogging_periods = 1;
  return s;
}

TEST(Compare, AReferenceOfTheDesignStaysWithinTheBudgetWhereTheRotorSwingsToo) {
  const Comparison c = compare_engines(out_of_balance(), {.lockstep = false});
  EXPECT_TRUE(c.passed()) << to_text(c.shadow);
}

struct Spoilt {
  const char* name;
  void (*spoil)(design::Parameters&);
};

class AReference : public testing::TestWithParam<Spoilt> {};

// What a wrong word would do is beyond the budget, in one signal at least.
TEST_P(AReference, ThatDiffersFromTheDesignIsFound) {
  design::Parameters p = design::design_drive(out_of_balance()).parameters;
  GetParam().spoil(p);
  const Comparison c = compare_engines(out_of_balance(), {.lockstep = false, .reference = p});
  EXPECT_FALSE(c.shadow.within()) << to_text(c.shadow);
  EXPECT_FALSE(c.passed());
}

INSTANTIATE_TEST_SUITE_P(
    Compare, AReference,
    testing::Values(
        Spoilt{"expects_crossings_2_percent_of_a_step_late", [](auto& p) { p.loop.expected += 0.02; }},
        Spoilt{"compensates_5_us_too_much", [](auto& p) { p.loop.delay += 5e-6; }},
        Spoilt{"sets_its_speed_2_percent_higher", [](auto& p) { p.speed.target *= 1.02; }},
        Spoilt{"has_a_tenth_of_the_loop_gain", [](auto& p) {
                 p.loop.proportional /= 10, p.loop.integral /= 10;
               }},
        Spoilt{"has_half_the_loop_gain", [](auto& p) {
                 p.loop.proportional /= 2, p.loop.integral /= 2;
               }},
        Spoilt{"has_no_loop_integral", [](auto& p) { p.loop.integral = 0; }}),
    [](const auto& info) { return info.param.name; });

TEST(Compare, TheTextNamesEverySignalAndItsBound) {
  const std::string text = to_text(compare_engines(until_steady(), {.lockstep = false}));
  for (const char* name : {"phase error", "commutation", "commutation instant", "momentary speed",
                           "mean speed", "duty", "mean", "rms", "worst", "budget"}) {
    EXPECT_NE(text.find(name), text.npos) << name;
  }
  EXPECT_EQ(text.find("BEYOND"), text.npos);
}

}  // namespace
}  // namespace steplock
