// The whole drive through SPI: what is asked of the six-step drive, of this one; and what its C driver has beside.
#include "hls/bus/sinusoidal_spi.hpp"

#include <gtest/gtest.h>

#include "rtl/host/steplock_sinusoidal.h"
#include "tests/hls/spi_traffic.hpp"

namespace steplock {
namespace {

TEST(SinusoidalSpi, RandomFramesGetTheAnswersOfTheTableAndCutOnesWriteNothing) {
  for (std::uint64_t seed = 1; seed <= 2; ++seed) random_frames<SinusoidalSpi, Sinusoidal>(1500, seed);
}
TEST(SinusoidalSpi, AWrongAnswerIsNoticed) { a_wrong_status_is_noticed<SinusoidalSpi, Sinusoidal>(); }
TEST(SinusoidalSpi, TheCDriverTurnsTheBridgeOnAndOffAndClearsAFaultOverIt) {
  the_c_driver_turns_the_bridge_on_and_off_and_clears_a_fault<SinusoidalSpi, Sinusoidal>();
}
TEST(SinusoidalSpi, ACDriverThatFallsSilentTurnsTheBridgeOff) {
  a_c_driver_that_falls_silent_turns_the_bridge_off<SinusoidalSpi, Sinusoidal>();
}

TEST(SinusoidalSpi, TheCDriverReadsTheTelemetryOfOneInstantOverIt) {
  SpiBench<SinusoidalSpi, Sinusoidal> b;
  const steplock_bus bus = b.bus();
  unsigned kind = 0;
  EXPECT_EQ(steplock_get_kind(&bus, &kind), STEPLOCK_OK);
  EXPECT_EQ(kind, 2u);
  ASSERT_EQ(b.init(), STEPLOCK_OK);
  ASSERT_EQ(steplock_start(&bus, 0), STEPLOCK_OK);
  b.gates_move();
  steplock_sinusoidal_telemetry telemetry;
  ASSERT_EQ(steplock_sinusoidal_get_telemetry(&bus, &telemetry), STEPLOCK_OK);
  EXPECT_EQ(telemetry.v_dc, 2700) << "as the ADC says";
  EXPECT_TRUE(telemetry.on_u == 0 && telemetry.on_v == 0 && telemetry.on_w > 0) << "the pattern begins with leg w";
}

}  // namespace
}  // namespace steplock
