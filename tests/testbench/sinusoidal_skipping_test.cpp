#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <set>

#include "testbench/drive/sinusoidal/skipping_top.hpp"

namespace steplock {
namespace {

SinusoidalConfig config() {
  SinusoidalConfig w;
  w.bridge = {.period = 2400, .minimum = 12, .dead_time = 12, .dead_time_loss = 192, .compensate = true,
              .reciprocal = 4660};
  w.estimator = {.decay = 3113, .gain = 3686, .k_theta = 3277, .k_e = 541, .k_speed = 5894};
  w.speed = {.target = 1 << 22, .slew = 4000, .filter = 983, .k_p = 700, .k_i = 530,
             .limit = 12288, .lock = 1000, .slow = 100, .stop = 1000, .emf_low = 3277,
             .emf_high = 20480};
  w.control = {.k_p = 1092, .k_i = 831, .inductance = 892, .emf = 1425, .limit = 18919};
  w.sequence = {.hold_voltage = 2000, .pattern = 5, .lock = 20, .give_up = 30, .brake = 10,
                .retry_delay = 10, .retries = 1};
  w.pilot = {.short_periods = 2, .rounds = 2, .decayed = 30000, .saliency = 100};
  w.fault = {.over_current = 30000, .saturated = 0, .lost_samples = 3};
  return w;
}

// Advancing over quiet clocks shows in every clock what ticking through them shows, whatever the
// ADCs give, whenever they give it, and whatever is commanded meanwhile; and it is mostly
// advancing.
TEST(SkippingSinusoidalTop, AdvancingEqualsTickingInEveryClock) {
  std::mt19937_64 random(1);
  const auto one_in = [&](int n) { return random() % std::uint64_t(n) == 0; };
  SinusoidalTop::In in;
  in.config = config();
  in.command.configured = in.command.run = true;
  SkippingSinusoidalTop advancing;
  SinusoidalTop ticking;
  SinusoidalTop::Out advanced, ticked;
  std::set<SinusoidalState> states;
  std::uint64_t clocks = 0, calls = 0;
  int late = 0;  // clocks until the ADCs give their codes, beside the one after the strobe
  while (clocks < 10'000'000) {
    std::uint64_t hold = 1 + random() % 3000;
    while (hold > 0) {
      if (advanced.sample) late = one_in(20) ? 1 + int(random() % 700) : 1;
      in.codes.valid = late == 1 && !one_in(200);
      const std::uint64_t most = late > 1 ? std::min(hold, std::uint64_t(late - 1)) : hold;
      const std::uint64_t taken = advancing.advance(in, advanced, late == 1 ? 1 : most);
      for (std::uint64_t k = 0; k < taken; ++k) {
        ticked = ticking.tick(in);
        ASSERT_TRUE(ticked == advanced) << "clock " << clocks + k;
      }
      late = std::max(0, late - int(std::min(taken, std::uint64_t(1000))));
      hold -= taken;
      clocks += taken;
      ++calls;
      states.insert(advanced.state);
    }
    in.codes.u = int(random() % 400) - 200, in.codes.v = int(random() % 400) - 200;
    in.codes.dc = 2600 + int(random() % 200);
    in.fault = one_in(500);
    in.command.clear_fault = advanced.state == SinusoidalState::kFault;
    in.command.run = !in.command.clear_fault && !one_in(100);
    if (one_in(200)) in.command.reverse = !in.command.reverse;
    if (advanced.state == SinusoidalState::kIdle) in.config.sequence.pilot = one_in(2);
  }
  EXPECT_GE(states.size(), 7u);
  EXPECT_LT(calls, clocks / 5);
}

}  // namespace
}  // namespace steplock
