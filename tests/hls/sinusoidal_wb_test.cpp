// The whole drive through Wishbone: random traffic against a model of the map made of the table, and what
// a host does to a bridge.
#include "hls/bus/sinusoidal_wb.hpp"

#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

#include "tests/hls/bus_hosts.hpp"

namespace steplock {
namespace {

using Host = WishboneHost<SinusoidalWb, Sinusoidal>;

TEST(SinusoidalWb, RandomTrafficGetsTheAnswersOfTheTable) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) random_bus_traffic<Host>(10'000, seed);
}

TEST(SinusoidalWb, AWrongAnswerIsNoticed) {
  testing::TestPartResultArray results;
  {
    testing::ScopedFakeTestPartResultReporter reporter(
        testing::ScopedFakeTestPartResultReporter::INTERCEPT_ONLY_CURRENT_THREAD, &results);
    random_bus_traffic<Host>(1000, 1, 500);
  }
  EXPECT_GT(results.size(), 0);
}

TEST(SinusoidalWb, TheHostTurnsTheBridgeOnAndOffAndClearsAFault) { start_fault_and_stop<Host>(); }

}  // namespace
}  // namespace steplock
