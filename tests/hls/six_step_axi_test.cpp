// The whole drive through its bus.
#include "hls/bus/six_step_axi.hpp"

#include <gtest/gtest.h>

#include "tests/hls/axi_traffic.hpp"

namespace steplock {
namespace {

TEST(SixStepAxi, RandomTrafficGetsTheAnswersOfTheTable) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) random_axi_traffic<SixStepAxi, SixStep>(50'000, seed);
}
TEST(SixStepAxi, ADroppedAnswerIsNoticed) { a_dropped_answer_is_noticed<SixStepAxi, SixStep>(); }
TEST(SixStepAxi, TheHostTurnsTheBridgeOnAndOff) { the_host_turns_the_bridge_on_and_off<SixStepAxi, SixStep>(); }
TEST(SixStepAxi, TheBridgesWordsAreRefusedWhileItRuns) {
  the_bridges_config_is_refused_while_it_runs<SixStepAxi, SixStep>();
}
TEST(SixStepAxi, AFaultPinIsAnInterruptAndAFaultUntilCleared) {
  a_fault_pin_is_an_interrupt_and_a_fault_until_cleared<SixStepAxi, SixStep>();
}
TEST(SixStepAxi, AHostThatFallsSilentTurnsTheBridgeOff) {
  a_host_that_falls_silent_turns_the_bridge_off<SixStepAxi, SixStep>();
}

// Why a second generator may tell the drive's boundaries.
TEST(SixStepAxi, PeriodsDoNotDependOnTheirPulses) {
  std::mt19937_64 random(1);
  PwmGenerator with, without;
  PwmGenerator::In in;
  for (int clock = 0; clock < 200'000; ++clock) {
    if (random() % 64 == 0) {
      in = {.on_clocks = int(random() % 50), .period = int(random() % 40),
            .minimum = int(random() % 10), .centred = random() % 2 == 0,
            .tick_periods = int(random() % 4)};
    }
    const auto a = with.tick(in);
    const auto b = without.tick({.period = in.period, .tick_periods = in.tick_periods});
    ASSERT_EQ(a.start, b.start) << clock;
    ASSERT_EQ(a.tick, b.tick) << clock;
  }
}

}  // namespace
}  // namespace steplock
