// The whole drive through APB: random traffic against a model of the map made of the table, and what
// a host does to a bridge.
#include "hls/bus/six_step_apb.hpp"

#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/hls/bus_traffic.hpp"

namespace steplock {
namespace {

struct ApbHost {
  using Top = SixStepApb;
  using Map = SixStep;
  static constexpr int kPhases = 2;
  static constexpr int kClocks = 3;  // of a transfer at most
  static void idle(Top::In& in) { in.apb = {}; }
  static void show(Top::In& in, const Transfer& t, int phase) {
    in.apb = {.psel = true, .penable = phase > 0, .pwrite = t.write, .paddr = t.address,
              .pwdata = t.data, .pstrb = t.strobes};
  }
  static Answer answer(const Top::Out& out) {
    return {.done = out.apb.pready, .error = out.apb.pslverr,
            .data = std::uint32_t(out.apb.prdata.raw())};
  }
};

TEST(SixStepApb, RandomTrafficGetsTheAnswersOfTheTable) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) random_bus_traffic<ApbHost>(10'000, seed);
}

TEST(SixStepApb, AWrongAnswerIsNoticed) {
  testing::TestPartResultArray results;
  {
    testing::ScopedFakeTestPartResultReporter reporter(
        testing::ScopedFakeTestPartResultReporter::INTERCEPT_ONLY_CURRENT_THREAD, &results);
    random_bus_traffic<ApbHost>(1000, 1, 500);
  }
  EXPECT_GT(results.size(), 0);
}

TEST(SixStepApb, TheHostTurnsTheBridgeOnAndOffAndClearsAFault) { start_fault_and_stop<ApbHost>(); }

}  // namespace
}  // namespace steplock
