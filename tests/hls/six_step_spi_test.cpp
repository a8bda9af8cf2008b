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
TEST(SixStepSpi, TheCDriverRefusesHallWordsWithoutADecoder) {
  for (const bool decoder : {false, true}) {
    SpiBench<SixStepSpi, SixStep> b;
    b.in.with.hall_decoder = decoder;
    const steplock_bus bus = b.bus();
    const steplock_word config[] = {{STEPLOCK_LOOP, STEPLOCK_LOOP_SOURCE_MASK}};
    EXPECT_EQ(steplock_init(&bus, config, 1), decoder ? STEPLOCK_NO_PERIOD : STEPLOCK_NO_HALL);
    EXPECT_EQ(b.init(), STEPLOCK_OK) << "words of a drive without sensors";
  }
}
TEST(SixStepSpi, TheCDriverRefusesWordsOfAStartThatIsLeftOut) {
  for (const bool follow : {false, true}) {
    for (const bool there : {false, true}) {
      SpiBench<SixStepSpi, SixStep> b;
      (follow ? b.in.with.follower : b.in.with.ramp) = there;
      const steplock_bus bus = b.bus();
      const steplock_word config[] = {{STEPLOCK_START_LOCK, follow ? STEPLOCK_START_LOCK_METHOD_MASK : 0u}};
      EXPECT_EQ(steplock_init(&bus, config, 1), there ? STEPLOCK_NO_PERIOD : STEPLOCK_NO_METHOD);
    }
  }
}
TEST(SixStepSpi, ACDriverThatFallsSilentTurnsTheBridgeOff) {
  a_c_driver_that_falls_silent_turns_the_bridge_off<SixStepSpi, SixStep>();
}

}  // namespace
}  // namespace steplock
