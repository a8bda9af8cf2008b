// The whole drive through SPI: random frames against a model of the map, and the C driver over it.
#include "hls/bus/six_step_spi.hpp"

#include <gtest/gtest.h>

#include "tests/hls/spi_traffic.hpp"

namespace steplock {
namespace {

TEST(SixStepSpi, RandomFramesGetTheAnswersOfTheTableAndCutOnesWriteNothing) {
  for (std::uint64_t seed = 1; seed <= 2; ++seed) random_frames<SixStepSpi, SixStep>(1500, seed);
}
TEST(SixStepSpi, AWrongAnswerIsNoticed) { a_wrong_status_is_noticed<SixStepSpi, SixStep>(); }
TEST(SixStepSpi, TheCDriverTurnsTheBridgeOnAndOffAndClearsAFaultOverIt) {
  the_c_driver_turns_the_bridge_on_and_off_and_clears_a_fault<SixStepSpi, SixStep>();
}
TEST(SixStepSpi, ACDriverThatFallsSilentTurnsTheBridgeOff) {
  a_c_driver_that_falls_silent_turns_the_bridge_off<SixStepSpi, SixStep>();
}

}  // namespace
}  // namespace steplock
