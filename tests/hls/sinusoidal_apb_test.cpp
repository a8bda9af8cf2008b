// The whole drive through APB: random traffic against a model of the map made of the table, and what
// a host does to a bridge.
#include "hls/bus/sinusoidal_apb.hpp"

#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

#include "tests/hls/bus_hosts.hpp"

namespace steplock {
namespace {

using Host = ApbHost<SinusoidalApb, Sinusoidal>;

TEST(SinusoidalApb, RandomTrafficGetsTheAnswersOfTheTable) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) random_bus_traffic<Host>(10'000, seed);
}

TEST(SinusoidalApb, AWrongAnswerIsNoticed) {
  testing::TestPartResultArray results;
  {
    testing::ScopedFakeTestPartResultReporter reporter(
        testing::ScopedFakeTestPartResultReporter::INTERCEPT_ONLY_CURRENT_THREAD, &results);
    random_bus_traffic<Host>(1000, 1, 500);
  }
  EXPECT_GT(results.size(), 0);
}

TEST(SinusoidalApb, TheHostTurnsTheBridgeOnAndOffAndClearsAFault) { start_fault_and_stop<Host>(); }

}  // namespace
}  // namespace steplock
