// A start sequence with short times, a tick in every fifth clock, and the inputs of a healthy drive.
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "hls/six_step/start_sequence.hpp"

namespace steplock::test {

struct StartBench {
  StartSequence dut;
  StartSequence::In in;
  std::vector<State> visited;

  StartBench() {
    in.tick = true;
    in.command.configured = true;
    in.config = {.pre_align = 3,
                .align = 5,
                .align_duty = 1000,
                .start_duty = 2000,
                .ramp = 100,
                .hand_over = 1000,
                .window = 0x4000,
                .good_crossings = 4,
                .pull_in = 20,
                .detect_spin = 10,
                .slow_down = 30,
                .brake = 5,
                .brake_duty = 500,
                .retry_delay = 6,
                .retries = 2};
  }

  // A clock with all strobes of `in`, and four without; returns the outputs after them, strobes in any of them, which
  // last one clock.
  StartSequence::Out clock() {
    StartSequence::Out out;
    auto next = in;
    auto shown = dut;
    StartSequence::Out before = shown.tick(next);
    for (int i = 0; i < 5; ++i) {
      dut.tick(next);
      next.tick = next.update = next.commutate = false;
      auto after = dut;
      const auto last = out;
      out = after.tick(next);
      EXPECT_FALSE((before.load_step && out.load_step) || (before.began && out.began) || (before.failed && out.failed));
      before = out;
      if (last.load_step) out.step = last.step;
      out.load_step |= last.load_step;
      out.began |= last.began;
      out.failed |= last.failed;
      if (visited.empty() || visited.back() != out.state) visited.push_back(out.state);
    }
    in.update = false;
    return out;
  }

  StartSequence::Out clocks(int n) {
    StartSequence::Out out;
    for (int i = 0; i < n; ++i) out = clock();
    return out;
  }

  // Until the state is reached; fails the test when it never is.
  StartSequence::Out until(State state) {
    StartSequence::Out out;
    for (int i = 0; i < 5000; ++i) {
      out = clock();
      if (out.state == state) return out;
    }
    ADD_FAILURE() << "state " << int(state) << " was not reached";
    return out;
  }

  void crossing(bool good) {
    in.update = true;
    in.good = good;
    clock();
  }

  StartSequence::Out move(bool reverse, int sector) {
    in.update = in.good = true;
    in.turns_reverse = reverse;
    in.sector = sector;
    return clock();
  }

  void run() {
    in.command.run = true;
    in.fast = false;
    until(State::kAccelerate);
    in.fast = true;
    until(State::kPullIn);
    for (int i = 0; i < 4; ++i) crossing(true);
    clock();
  }
};

}  // namespace steplock::test
