#include "hls/bridge/gate_guard.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <string>

namespace steplock {
namespace {

constexpr int kFloor = 3;
using Guard = GateGuard<kFloor>;
using In = Guard::In;

// What a leg has promised so far, told from its pins alone.
class LegMonitor {
 public:
  // The state of the leg in one clock, with the inputs of the same clock.
  std::string check(bool high, bool low, bool want_high, bool want_low, bool off, int dead,
                    int minimum) {
    std::string broken;
    if (high && low) broken = "both gates on";
    const bool on = high || low;
    if (on && off_before_) broken = "on in the clock after off";
    if (on && !was_on_) {
      if (off_clocks_ < least_dead_) broken = "dead time";
      if (steady_ < least_dead_ + 1) broken = "a request too short";
      if (high ? !last_high_ : !last_low_) broken = "nobody asked";
    }
    if (on && was_on_ && high != was_high_) broken = "one gate for the other without a pause";
    if (!on && was_on_ && !off_before_ && on_clocks_ < last_minimum_) broken = "minimum on-time";

    dead = std::max(dead, kFloor);
    off_clocks_ = on ? 0 : std::min(off_clocks_ + 1, 1000);
    if (on && !was_on_) last_minimum_ = minimum_before_;
    on_clocks_ = on ? (was_on_ ? on_clocks_ + 1 : 1) : 0;
    // The dead time in force: the smallest since the leg was last on, or since the request came.
    const bool same = want_high == last_high_ && want_low == last_low_ && (want_high != want_low);
    steady_ = off || want_high == want_low ? 0 : same && !off_before_ ? steady_ + 1 : 1;
    least_dead_ = on || steady_ <= 1 ? dead : std::min(least_dead_, dead);
    last_high_ = want_high && !want_low;
    last_low_ = want_low && !want_high;
    was_on_ = on;
    was_high_ = high;
    off_before_ = off;
    minimum_before_ = minimum;
    return broken;
  }

 private:
  bool was_on_ = false, was_high_ = false, off_before_ = true;
  bool last_high_ = false, last_low_ = false;
  int off_clocks_ = 0, on_clocks_ = 0, steady_ = 0;
  int least_dead_ = 0, last_minimum_ = 0, minimum_before_ = 0;
};

Gates leg_u(bool high, bool low) { return {.uh = high, .ul = low}; }

// Clocks until the gate of leg U's high side shows `level`, or -1.
int clocks_until(Guard& dut, const In& in, bool level) {
  for (int i = 0; i < 600; ++i) {
    if (dut.tick(in).uh == level) return i;
  }
  return -1;
}

TEST(GateGuard, AGateTurnsOnTheDeadTimeAndOneClockAfterItsRequest) {
  for (const int dead : {0, 1, 3, 4, 100, 255}) {
    Guard dut;
    for (int i = 0; i < 300; ++i) dut.tick({.enable = true, .dead_time = dead});
    const In in = {.request = leg_u(true, false), .enable = true, .dead_time = dead};
    EXPECT_EQ(clocks_until(dut, in, true), std::max(dead, kFloor) + 1);
  }
}

TEST(GateGuard, AGateTurnsOffOneClockAfterItsRequestGoes) {
  Guard dut;
  clocks_until(dut, {.request = leg_u(true, false), .enable = true}, true);
  EXPECT_EQ(clocks_until(dut, {.enable = true}, false), 1);
}

TEST(GateGuard, FromOneGateToTheOtherTheLegIsOffForExactlyTheDeadTime) {
  for (const int dead : {0, 3, 17, 255}) {
    Guard dut;
    const In high = {.request = leg_u(true, false), .enable = true, .dead_time = dead};
    const In low = {.request = leg_u(false, true), .enable = true, .dead_time = dead};
    clocks_until(dut, high, true);
    dut.tick(low);
    int off = 0;
    while (!dut.tick(low).ul) ++off;
    EXPECT_EQ(off, std::max(dead, kFloor));
  }
}

TEST(GateGuard, AllSixAreOffOneClockAfterAFault) {
  for (const bool fault : {true, false}) {
    Guard dut;
    const In on = {.request = {.uh = true, .vh = true, .wl = true}, .enable = true, .minimum = 50};
    Gates gates;
    for (int i = 0; i < 10; ++i) gates = dut.tick(on);
    ASSERT_TRUE(gates.uh && gates.vh && gates.wl);
    In off = on;
    off.fault = fault;
    off.enable = fault;  // the fault pin, or a lost enable
    dut.tick(off);
    for (int i = 0; i < 500; ++i) {
      gates = dut.tick(off);
      ASSERT_FALSE(gates.uh || gates.ul || gates.vh || gates.vl || gates.wh || gates.wl);
    }
  }
}

TEST(GateGuard, AfterAFaultOfOneClockTheDeadTimePassesInFull) {
  Guard dut;
  const In on = {.request = leg_u(true, false), .enable = true, .dead_time = 20};
  clocks_until(dut, on, true);
  In fault = on;
  fault.fault = true;
  dut.tick(fault);
  EXPECT_EQ(clocks_until(dut, on, true), 21);
}

TEST(GateGuard, ARequestOfTheDeadTimeIsSwallowedAndOneClockMoreArrives) {
  for (const int extra : {0, 1}) {
    Guard dut;
    const In on = {.request = leg_u(true, false), .enable = true, .dead_time = 9};
    const In off = {.enable = true, .dead_time = 9};
    dut.tick(off);
    bool seen = false;
    for (int i = 0; i < 9 + extra; ++i) seen |= dut.tick(on).uh;
    for (int i = 0; i < 20; ++i) seen |= dut.tick(off).uh;
    EXPECT_EQ(seen, extra == 1);
  }
}

TEST(GateGuard, AShortPulseIsStretchedToTheMinimum) {
  for (const int minimum : {0, 1, 2, 30, 255}) {
    Guard dut;
    const In on = {.request = leg_u(true, false), .enable = true, .minimum = minimum};
    for (int i = 0; i < kFloor + 1; ++i) dut.tick(on);
    int length = 0;
    for (int i = 0; i < 600; ++i) length += dut.tick({.enable = true, .minimum = minimum}).uh;
    EXPECT_EQ(length, std::max(minimum, 1));
  }
}

TEST(GateGuard, BothRequestedIsNone) {
  Guard dut;
  for (int i = 0; i < 600; ++i) {
    const auto gates = dut.tick({.request = leg_u(true, true), .enable = true});
    ASSERT_FALSE(gates.uh || gates.ul);
  }
}

TEST(GateGuard, LegsDoNotDisturbEachOther) {
  Guard dut;
  const In all = {.request = {.uh = true, .vl = true, .wh = true}, .enable = true};
  for (int i = 0; i < 10; ++i) dut.tick(all);
  In change = all;
  change.request.uh = false;
  for (int i = 0; i < 10; ++i) {
    const auto gates = dut.tick(change);
    ASSERT_TRUE(gates.vl && gates.wh);
  }
}

TEST(GateGuard, KeepsItsPromisesInEverySequenceOfSixClocks) {
  struct Node {
    Guard guard;
    LegMonitor monitor;
  };
  long checked = 0;
  std::set<std::string> broken;
  // Depth first: all 8 inputs in each of six clocks, 8^6 sequences from each beginning.
  const auto walk = [&](const auto& self, const Node& from, int depth, int dead, int minimum) -> void {
    if (depth == 0) return;
    for (int bits = 0; bits < 8; ++bits) {
      Node node = from;
      const bool high = bits & 1;
      const bool low = bits & 2;
      const bool off = bits & 4;
      const auto gates = node.guard.tick({.request = leg_u(high, low),
                                          .enable = !off,
                                          .dead_time = dead,
                                          .minimum = minimum});
      const auto what =
          node.monitor.check(gates.uh, gates.ul, high, low, off, dead, std::max(minimum, 1));
      if (!what.empty()) broken.insert(what);
      ++checked;
      self(self, node, depth - 1, dead, minimum);
    }
  };
  for (const int minimum : {0, 3}) walk(walk, {}, 6, 0, minimum);
  // From a leg that has just turned on, every sequence again.
  for (const int minimum : {0, 2, 4}) {
    Node on;
    for (int i = 0; i < kFloor + 1; ++i) {
      const auto gates = on.guard.tick({.request = leg_u(true, false), .enable = true, .minimum = minimum});
      on.monitor.check(gates.uh, gates.ul, true, false, false, 0, std::max(minimum, 1));
    }
    walk(walk, on, 6, 0, minimum);
  }
  EXPECT_GT(checked, 1'000'000);
  EXPECT_TRUE(broken.empty()) << *broken.begin();
}

// Long sequences with every word changing at will.
RC_GTEST_PROP(GateGuard, KeepsItsPromisesWhateverComes, (std::uint32_t seed)) {
  std::mt19937 random(seed);
  const auto below = [&](unsigned n) { return int(random() % n); };
  Guard dut;
  LegMonitor u, v, w;
  int turned_on = 0;
  In in;
  int left = 0;
  for (int clock = 0; clock < 20000; ++clock) {
    if (left-- == 0) {
      const auto request = below(64);
      in = {.request = {.uh = (request & 1) != 0, .ul = (request & 2) != 0,
                        .vh = (request & 4) != 0, .vl = (request & 8) != 0,
                        .wh = (request & 16) != 0, .wl = (request & 32) != 0},
            .enable = below(8) != 0,
            .fault = below(8) == 0,
            .dead_time = below(12),
            .minimum = below(12)};
      left = below(20);
    }
    const bool off = in.fault || !in.enable;
    const int dead = int(in.dead_time.raw());
    const int minimum = std::max(1, int(in.minimum.raw()));
    const auto gates = dut.tick(in);
    turned_on += gates.uh;
    for (const auto& what :
         {u.check(gates.uh, gates.ul, in.request.uh, in.request.ul, off, dead, minimum),
          v.check(gates.vh, gates.vl, in.request.vh, in.request.vl, off, dead, minimum),
          w.check(gates.wh, gates.wl, in.request.wh, in.request.wl, off, dead, minimum)}) {
      if (!what.empty()) RC_FAIL(what);
    }
  }
  RC_ASSERT(turned_on > 0);
}

}  // namespace
}  // namespace steplock
