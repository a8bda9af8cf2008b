// The whole drive through Wishbone: random traffic against a model of the map made of the table, and what
// a host does to a bridge.
#include "hls/bus/six_step_wb.hpp"

#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/hls/bus_traffic.hpp"

namespace steplock {
namespace {

struct WishboneHost {
  using Top = SixStepWb;
  static constexpr int kPhases = 1;
  static constexpr int kClocks = 3;  // of a transfer at most
  static void idle(Top::In& in) { in.wb = {}; }
  static void show(Top::In& in, const Transfer& t, int phase) {
    (void)phase;
    in.wb = {.cyc = true, .stb = true, .we = t.write, .adr = t.address, .dat = t.data, .sel = t.strobes};
  }
  static Answer answer(const Top::Out& out) {
    return {.done = out.wb.ack || out.wb.err, .error = out.wb.err, .data = std::uint32_t(out.wb.dat.raw())};
  }
};

TEST(SixStepWb, RandomTrafficGetsTheAnswersOfTheTable) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) random_bus_traffic<WishboneHost>(10'000, seed);
}

TEST(SixStepWb, AWrongAnswerIsNoticed) {
  testing::TestPartResultArray results;
  {
    testing::ScopedFakeTestPartResultReporter reporter(
        testing::ScopedFakeTestPartResultReporter::INTERCEPT_ONLY_CURRENT_THREAD, &results);
    random_bus_traffic<WishboneHost>(1000, 1, 500);
  }
  EXPECT_GT(results.size(), 0);
}

TEST(SixStepWb, TheHostTurnsTheBridgeOnAndOffAndClearsAFault) { start_fault_and_stop<WishboneHost>(); }

}  // namespace
}  // namespace steplock
