#include "testbench/engine/skipping_top.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tests/hls/six_step_chaos.hpp"

namespace steplock {
namespace {

// While nothing outside changes, skipping the quiet clocks leads to the same state as ticking
// through them, bit for bit, and the step phase of each is known; and there is something to skip.
TEST(SkippingTop, SkippingQuietClocksEqualsTickingThem) {
  Chaos chaos;
  chaos.in.words.pwm.period = 4000;
  chaos.in.words.start.hand_over = 1 << 19;
  chaos.in.words.start.pull_in = 100;
  chaos.in.command.run = true;
  SkippingTop ticking, skipping, advancing;
  SixStepTop::Out out, ticked, advanced;
  std::uint64_t skipped = 0, clocks = 0, calls = 0;
  for (int i = 0; i < 20000; ++i) {
    chaos.clock();
    const int hold = int(chaos.random() % 300);
    std::vector<Phase> phases;
    for (int k = 0; k < hold; ++k) phases.push_back((ticked = ticking.tick(chaos.in)).step_phase);
    for (int k = 0; k < hold;) {
      const auto quiet = k == 0 ? 0 : skipping.quiet(chaos.in, out);
      const auto n = std::min(quiet, std::uint64_t(hold - k));
      if (n > 0) {
        for (std::uint64_t m = 1; m <= n; ++m) {
          ASSERT_EQ(skipping.shows(chaos.in, out, m), phases[std::size_t(k) + m - 1]) << m << " of " << n;
        }
        out.step_phase = skipping.skip(chaos.in, out, n);
        skipped += n;
        k += int(n);
      } else {
        out = skipping.tick(chaos.in);
        ++k;
      }
    }
    if (hold > 0) advanced = advancing.tick(chaos.in);
    for (int k = 1; k < hold; ++calls) {
      k += int(advancing.advance(chaos.in, advanced, std::uint64_t(hold - k)));
    }
    clocks += std::uint64_t(hold);
    ASSERT_TRUE(skipping == ticking) << "after " << clocks << " clocks";
    ASSERT_TRUE(advancing == ticking) << "after " << clocks << " clocks";
    ASSERT_EQ(out, ticked) << "after " << clocks << " clocks";
    ASSERT_EQ(advanced, ticked) << "after " << clocks << " clocks";
  }
  EXPECT_GT(skipped, clocks / 4);
  EXPECT_LT(calls, 3 * clocks / 4);
}

}  // namespace
}  // namespace steplock
