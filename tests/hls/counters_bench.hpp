// Start counters with a state machine that does as it is told: for the tests of StartCounters.
#pragma once

#include <gtest/gtest.h>

#include "hls/six_step/start_counters.hpp"

namespace steplock::test {

// A tick in every fifth clock.
struct CountersBench {
  StartCounters dut;
  StartCounters::In in;
  StartCounters::Out out;  // of the last clock

  CountersBench() {
    in.config = {.pre_align = 3,
                .align = 5,
                .good_crossings = 4,
                .pull_in = 20,
                .detect_spin = 10,
                .slow_down = 30,
                .brake = 7,
                .retry_delay = 6,
                .retries = 2};
  }

  void clock() {
    out = dut.tick(in);
    in.tick = in.entered = in.failed = in.braking = in.update = false;
  }
  void clocks(int n) {
    for (int i = 0; i < n; ++i) clock();
  }
  void enter(State state) {
    in.state = state;
    in.entered = true;
    clocks(2);
  }
  // Whether the state is over with it.
  bool tick() {
    in.tick = true;
    clock();
    const bool timed_out = out.timed_out;
    clocks(4);
    return timed_out;
  }
  // Ticks up to the one with which it is, 0 if there is none such in `most`.
  int ticks_of(State state, int most = 100'000) {
    enter(state);
    for (int i = 1; i <= most; ++i) {
      if (tick()) return i;
    }
    return 0;
  }
  void fail() {
    in.failed = true;
    clocks(4);
  }
  // Whether they are enough with this one: in the clock after it, and in no other.
  bool crossing(bool good, bool turns_reverse = false) {
    in.update = true;
    in.good = good;
    in.turns_reverse = turns_reverse;
    clock();
    EXPECT_FALSE(out.count_reached);
    clock();
    const bool count_reached = out.count_reached;
    clock();
    EXPECT_FALSE(out.count_reached);
    return count_reached;
  }
  bool crossings(int n, bool good, bool turns_reverse = false) {
    bool count_reached = false;
    for (int i = 0; i < n; ++i) count_reached = crossing(good, turns_reverse);
    return count_reached;
  }
};

}  // namespace steplock::test
