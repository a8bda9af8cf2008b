// The whole drive through its bus: what is asked of the six-step drive, of this one.
#include "hls/bus/sinusoidal_axi.hpp"

#include <gtest/gtest.h>

#include "tests/hls/axi_traffic.hpp"

namespace steplock {
namespace {

TEST(SinusoidalAxi, RandomTrafficGetsTheAnswersOfTheTable) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) random_axi_traffic<SinusoidalAxi, Sinusoidal>(50'000, seed);
}
TEST(SinusoidalAxi, ADroppedAnswerIsNoticed) { a_dropped_answer_is_noticed<SinusoidalAxi, Sinusoidal>(); }
TEST(SinusoidalAxi, TheHostTurnsTheBridgeOnAndOff) { the_host_turns_the_bridge_on_and_off<SinusoidalAxi, Sinusoidal>(); }
TEST(SinusoidalAxi, TheBridgesWordsAreRefusedWhileItRuns) {
  the_bridges_config_is_refused_while_it_runs<SinusoidalAxi, Sinusoidal>();
}
TEST(SinusoidalAxi, AFaultPinIsAnInterruptAndAFaultUntilCleared) {
  a_fault_pin_is_an_interrupt_and_a_fault_until_cleared<SinusoidalAxi, Sinusoidal>();
}
TEST(SinusoidalAxi, AHostThatFallsSilentTurnsTheBridgeOff) {
  a_host_that_falls_silent_turns_the_bridge_off<SinusoidalAxi, Sinusoidal>();
}

}  // namespace
}  // namespace steplock
