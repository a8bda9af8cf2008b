// What the whole drive promises for every input; that it turns a motor is closed_loop_test.cpp's
// claim.
#include "tests/hls/six_step_chaos.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace steplock {
namespace {

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

TEST(SixStepTop, TheCurrentLimitPinTakesTheHighSideOffInFiveClocks) {
  SixStepTop top;
  SixStepTop::In in;
  in.config = quick_config();
  in.config.start.detect_spin = 0;
  in.config.pwm.complementary = false;
  in.command = {.configured = true, .run = true};
  // In the reset pattern U and V are chopped: find a pulse past its blanking.
  int on = 0;
  for (int i = 0; i < 5000 && on < 40; ++i) on = top.tick(in).gates.uh ? on + 1 : 0;
  ASSERT_EQ(on, 40);
  in.pins.limit = true;
  for (int i = 0; i < 5; ++i) top.tick(in);
  EXPECT_FALSE(top.tick(in).gates.uh);
}

// A cut of a rotor that runs turns all gates off for a quarter of the off-time, or its back-EMF would drive the current on through
// zero; a cut at rest closes the low side for all of it, and so does the PWM's own pause.
TEST(SixStepTop, ACutOfARotorThatRunsTurnsAllGatesOffForAQuarterOfTheOffTime) {
  constexpr int kOffTime = 50, kGuard = 3;  // clocks: quick_config's; from a request to its gate
  Chaos chaos;
  int since_hit = 1000, since_run = 0, same_step = 0, on_in_a_cut = 0, cuts = 0, paused_low = 0, low_in_a_cut_at_rest = 0;
  int soonest = 1000;  // clocks from a hit to the next high side
  SixStepTop::Out last;
  for (int i = 0; i < 2000000; ++i) {
    const auto out = chaos.clock_of();
    const bool hit = out.counts.limit_hits != last.counts.limit_hits && out.counts.limit_hits != 0;
    since_hit = hit ? 0 : since_hit + 1;
    since_run = out.locked ? since_run + 1 : 0;
    same_step = out.step == last.step ? same_step + 1 : 0;
    const Gates legs = Commutation::legs(out.step);
    const bool low = (legs.uh && out.gates.ul) || (legs.vh && out.gates.vl) || (legs.wh && out.gates.wl);
    const bool runs = since_run > kOffTime;
    if (runs && since_hit > kGuard && since_hit < kOffTime / 4) ++cuts, on_in_a_cut += any(out.gates);
    if (runs && since_hit > kOffTime && same_step > kGuard && low) ++paused_low;
    if (runs && since_hit > kGuard && (out.gates.uh || out.gates.vh || out.gates.wh)) soonest = std::min(soonest, since_hit);
    // The pattern of a rotor at rest chops U and V, whatever the step.
    if (out.state == State::kAlign && since_hit > kOffTime / 2 && since_hit < kOffTime - kGuard && out.gates.ul) ++low_in_a_cut_at_rest;
    last = out;
  }
  EXPECT_EQ(on_in_a_cut, 0);
  EXPECT_GT(cuts, 100);
  EXPECT_LT(soonest, kOffTime / 2);
  EXPECT_GT(paused_low, 100) << "the control";
  EXPECT_GT(low_in_a_cut_at_rest, 100) << "the control";
}

// Without a decoder no start looks for a rotor that turns; all else stays, clock by clock.
TEST(SixStepTop, WithoutTheHallDecoderItIsTheDriveThatDoesNotObserve) {
  Chaos chaos;
  chaos.in.config.start.detect_spin = 0;
  SixStepTop without;
  unsigned states = 0;
  for (int i = 0; i < 1000000; ++i) {
    const auto with = chaos.clock_of(Source::kBemf);
    auto in = chaos.in;
    in.with.hall_decoder = false;
    in.config.start.detect_spin = 4;
    const auto out = without.tick(in);
    ASSERT_EQ(out, with) << i;
    states |= 1u << unsigned(out.state);
  }
  EXPECT_EQ(states & 0x3FF, 0x3FDu) << "every state but kDetectSpin";
}

TEST(SixStepTop, WithoutTheHallDecoderWordsOfHallSensorsLeaveItIdle) {
  for (const bool decoder : {false, true}) {
    SixStepTop dut;
    SixStepTop::In in{.with = {.hall_decoder = decoder}, .command = {.configured = true, .run = true}, .config = quick_config()};
    in.config.source = Source::kHall;
    in.pins.hall_u = true;
    int on = 0, idle = 0;
    for (int i = 0; i < 20000; ++i) {
      const auto out = dut.tick(in);
      on += any(out.gates);
      idle += out.state == State::kIdle;
    }
    EXPECT_EQ(on > 0, decoder);
    EXPECT_EQ(idle == 20000, !decoder);
  }
}

TEST(SixStepTop, WithoutTelemetryOnlyTheCountsAreGone) {
  Chaos chaos;
  SixStepTop without;
  Telemetry::Out most;
  for (int i = 0; i < 300000; ++i) {
    auto with = chaos.clock_of();
    auto in = chaos.in;
    in.with.telemetry = false;
    most.crossings = std::max(most.crossings, with.counts.crossings);
    with.counts = {};
    ASSERT_EQ(without.tick(in), with) << i;
  }
  EXPECT_GT(most.crossings, Telemetry::Count(0));
}

}  // namespace
}  // namespace steplock
