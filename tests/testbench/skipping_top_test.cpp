#include "testbench/drive/six_step/skipping_top.hpp"

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
  chaos.in.config.pwm.period = 4000;
  chaos.in.config.start.hand_over = 1 << 19;
  chaos.in.config.start.pull_in = 100;
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

// Pins change between its calls, as those of the plant do; it is told of another command or word by a tick.  Terminals that
// flicker, and some that hardly move, at which a follower's drives are long beside the PWM's period: pulses begin and end in them.
TEST(SkippingTop, AdvancesTheSameWithPinsThatChangeAtAnyTime) {
  struct Case {
    unsigned period, probe, still_for;
  };
  for (const Case& c : {Case{4000, 20, 30}, {400, 2000, 3000}}) {
    Chaos chaos;
    chaos.in.config.pwm.period = UInt<14>::of(c.period);
    chaos.in.config.start.probe = UInt<16>::of(c.probe);
    chaos.in.config.start.hand_over = 1 << 19;
    chaos.in.config.start.pull_in = 100;
    chaos.in.config.start.method = Method::kFollow;
    chaos.in.config.protection.over_current = 3;
    chaos.in.command.run = true;
    SkippingTop advancing;
    SixStepTop ticking;
    SixStepTop::Out advanced, ticked;
    std::uint64_t calls = 0, clocks = 0, drives = 0, faults = 0;
    for (int i = 0; i < 20000; ++i) {
      if (i % 100 == 0) {  // a fault latches, and its cause may
        advancing = {};
        ticking = {};
        chaos.in.command.run = true;
      }
      chaos.flip(chaos.in.command.run, 1000);
      chaos.flip(chaos.in.command.clear_fault, 20);
      chaos.in.config.pwm.complementary = chaos.once_in(2);
      ticked = ticking.tick(chaos.in);
      advanced = advancing.tick(chaos.in);
      for (std::uint64_t left = chaos.random() % 1000; left > 0; ++calls) {
        for (bool* pin : {&chaos.in.pins.comparator_u, &chaos.in.pins.comparator_v, &chaos.in.pins.comparator_w}) {
          chaos.flip(*pin, c.still_for);
        }
        chaos.flip(chaos.in.pins.limit, 2 * c.still_for);
        chaos.in.pins.fault = chaos.once_in(50 * c.still_for);
        const std::uint64_t now = advancing.advance(chaos.in, advanced, 1 + chaos.random() % left);
        for (std::uint64_t k = 0; k < now; ++k) ticked = ticking.tick(chaos.in);
        left -= now;
        clocks += now;
        drives += ticked.state == State::kAccelerate && ticked.chop;
        faults += ticked.state == State::kFault;
        ASSERT_EQ(advanced, ticked) << "after " << clocks << " clocks, drives of " << c.probe;
      }
    }
    EXPECT_LT(calls, 3 * clocks / 4);
    EXPECT_GT(drives, 1000U);
    EXPECT_GT(faults, 1000U);
  }
}

}  // namespace
}  // namespace steplock
