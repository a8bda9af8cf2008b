// What the whole drive promises for every input; that it turns a motor is closed_loop_test.cpp's
// claim.
#include "hls/six_step/six_step_top.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace steplock {
namespace {

// Words of a drive with short times, so that a few thousand clocks see all states.
Words quick_words() {
  Words w;
  w.pwm = {.period = 200, .minimum = 4, .complementary = true, .dead_time = 14, .tick_periods = 1};
  w.limit = {.blanking = 10, .off_time = 50};
  w.bemf = {.blanking = 5, .sample_every = 3, .samples = 2};
  w.loop = {.ki = 655, .kp = 6554, .minimum = 1 << 16, .maximum = 1 << 25};
  w.start = {.settle = 2, .reset = 3, .reset_duty = 0x4000, .start_duty = 0x4000, .ramp = 0xFFFFF,
             .hand_over = 1 << 22, .window = 0x4000, .good_crossings = 2, .pull_in = 20,
             .observe = 4, .slow_down = 4, .brake = 3, .brake_duty = 0x4000, .rest = 2,
             .retries = 15};
  w.speed = {.target = 1 << 23, .slew = 0xFFFFF, .shift = 9, .kp = 4096, .ki = 1000, .bemf = 0x2000,
             .minimum = 0x1000, .maximum = 0x8000, .duty_slew = 0x400};
  return w;
}

// Pins that flicker at all rates, and a host that changes its mind now and then.
struct Chaos {
  std::mt19937 random{1};
  SixStepTop top;
  SixStepTop::In in;

  Chaos() {
    in.words = quick_words();
    in.command.configured = true;
  }

  bool once_in(unsigned n) { return random() % n == 0; }
  void flip(bool& pin, unsigned n) { pin ^= once_in(n); }

  Gates clock() {
    flip(in.pins.comparator_u, 150);
    flip(in.pins.comparator_v, 150);
    flip(in.pins.comparator_w, 150);
    flip(in.pins.limit, 300);
    flip(in.pins.hall_u, 400);
    flip(in.pins.hall_v, 400);
    flip(in.pins.hall_w, 400);
    flip(in.command.run, 50000);
    flip(in.command.reverse, 20000);
    flip(in.command.brake_to_stop, 20000);
    if (once_in(30000)) in.words.source = Source(random() % 2);
    if (once_in(3000)) in.words.pwm.complementary = random() % 2;
    if (once_in(3000)) in.words.pwm.centred = random() % 2;
    if (once_in(3000)) in.words.pwm.dead_time = random() % 40;
    return top.tick(in).gates;
  }
};

bool any(const Gates& g) { return g.uh || g.ul || g.vh || g.vl || g.wh || g.wl; }

TEST(SixStepTop, GatesAreOffUntilConfiguredWhateverElseComes) {
  Chaos chaos;
  chaos.in.command.configured = false;
  for (int i = 0; i < 200000; ++i) ASSERT_FALSE(any(chaos.clock())) << i;
}

// The control of all tests with chaos: gates do switch in it, in every leg, on both sides.
TEST(SixStepTop, ChaosTurnsEveryGateOn) {
  Chaos chaos;
  int uh = 0, ul = 0, vh = 0, vl = 0, wh = 0, wl = 0;
  unsigned states = 0;
  for (int i = 0; i < 1000000; ++i) {
    const auto g = chaos.clock();
    uh += g.uh, ul += g.ul, vh += g.vh, vl += g.vl, wh += g.wh, wl += g.wl;
    states |= 1u << unsigned(chaos.top.tick(chaos.in).state);
  }
  for (const int on : {uh, ul, vh, vl, wh, wl}) EXPECT_GT(on, 100);
  // All eleven states but the fault, which the next test asks for.
  EXPECT_EQ(states & 0x3FF, 0x3FFu);
}

TEST(SixStepTop, NeverBothGatesOfALegAndAlwaysTheFloorBetweenThem) {
  Chaos chaos;
  const bool Gates::* const high[] = {&Gates::uh, &Gates::vh, &Gates::wh};
  const bool Gates::* const low[] = {&Gates::ul, &Gates::vl, &Gates::wl};
  int since_high[3] = {100, 100, 100}, since_low[3] = {100, 100, 100};
  for (int i = 0; i < 1000000; ++i) {
    const auto g = chaos.clock();
    for (int leg = 0; leg < 3; ++leg) {
      ++since_high[leg], ++since_low[leg];
      if (g.*high[leg]) {
        ASSERT_GT(since_low[leg], 12) << "clock " << i;
        since_high[leg] = 0;
      }
      if (g.*low[leg]) {
        ASSERT_GT(since_high[leg], 12) << "clock " << i;
        since_low[leg] = 0;
      }
    }
  }
}

// The k-th output after the cause is the gates behind k clock edges.
void expect_off_after(int edges, void (*cause)(SixStepTop::In&)) {
  for (int start = 20000; start < 400000; start += 17919) {
    Chaos chaos;
    chaos.in.command.run = true;
    for (int i = 0; i < start; ++i) chaos.clock();
    for (int i = 0; i < 500; ++i) {
      cause(chaos.in);
      const auto gates = chaos.clock();
      cause(chaos.in);
      if (i >= edges) {
        ASSERT_FALSE(any(gates)) << start << " + " << i;
      }
    }
  }
}

TEST(SixStepTop, GatesAreOffThreeClocksAfterTheFaultPin) {
  expect_off_after(3, [](SixStepTop::In& in) { in.pins.fault = true; });
}

TEST(SixStepTop, GatesAreOffOneClockAfterTheWordsBecomeInvalid) {
  expect_off_after(1, [](SixStepTop::In& in) { in.command.configured = false; });
}

TEST(SixStepTop, GatesAreOffTwoClocksAfterACoastingStop) {
  expect_off_after(2, [](SixStepTop::In& in) {
    in.command.run = in.command.brake_to_stop = false;
  });
}

TEST(SixStepTop, AFaultStaysLatchedWhenThePinIsReleased) {
  Chaos chaos;
  chaos.in.command.run = true;
  for (int i = 0; i < 30000; ++i) chaos.clock();
  chaos.in.pins.fault = true;
  for (int i = 0; i < 5; ++i) chaos.clock();
  chaos.in.pins.fault = false;
  for (int i = 0; i < 100000; ++i) ASSERT_FALSE(any(chaos.clock()));
  const auto out = chaos.top.tick(chaos.in);
  EXPECT_EQ(out.state, State::kFault);
  EXPECT_EQ(out.reason, Reason::kFaultPin);
}

// While nothing outside changes, skipping the quiet clocks leads to the same state as ticking
// through them, bit for bit; and there is something to skip.
TEST(SixStepTop, SkippingQuietClocksEqualsTickingThem) {
  Chaos chaos;
  chaos.in.words.pwm.period = 4000;
  chaos.in.words.start.hand_over = 1 << 19;
  chaos.in.words.start.pull_in = 100;
  chaos.in.command.run = true;
  SixStepTop ticking, skipping, advancing;
  SixStepTop::Out out, ticked, advanced;
  std::uint64_t skipped = 0, clocks = 0, calls = 0;
  for (int i = 0; i < 20000; ++i) {
    chaos.clock();
    const int hold = int(chaos.random() % 300);
    for (int k = 0; k < hold; ++k) ticked = ticking.tick(chaos.in);
    for (int k = 0; k < hold;) {
      const auto quiet = k == 0 ? 0 : skipping.quiet(chaos.in, out);
      const auto n = std::min(quiet, std::uint64_t(hold - k));
      if (n > 0) {
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

TEST(SixStepTop, TheCurrentLimitPinTakesTheHighSideOffInFiveClocks) {
  SixStepTop top;
  SixStepTop::In in;
  in.words = quick_words();
  in.words.start.observe = 0;
  in.words.pwm.complementary = false;
  in.command = {.configured = true, .run = true};
  // In the reset pattern U and V are chopped: find a pulse past its blanking.
  int on = 0;
  for (int i = 0; i < 5000 && on < 40; ++i) on = top.tick(in).gates.uh ? on + 1 : 0;
  ASSERT_EQ(on, 40);
  in.pins.limit = true;
  for (int i = 0; i < 5; ++i) top.tick(in);
  EXPECT_FALSE(top.tick(in).gates.uh);
}

}  // namespace
}  // namespace steplock
