// One sample in the order that the drive has it: duty first, then what the next sample needs.  The four
// blocks have tests of their own.

#include "hls/sinusoidal/sinusoidal_control.hpp"

#include <gtest/gtest.h>

#include <random>

namespace steplock {
namespace {

// The words of a running drive (sinusoidal_top_test.cpp), small currents and on-clocks at random: nothing
// is at its limit.
class Source {
 public:
  SinusoidalControl::In next() {
    SinusoidalControl::In in;
    in.estimate = in.regulate = ++samples_ > 3;
    in.i_u = any(-1000, 1000), in.i_v = any(-1000, 1000);
    in.v_dc = any(2600, 2800);
    in.ended = {any(580, 620), any(580, 620), any(580, 620)};
    in.initial = 123456;
    in.locked = samples_ / 40 % 2 != 0;
    in.reverse = samples_ / 80 % 2 != 0;
    in.bridge = {.period = 1200, .minimum = 12, .dead_time = 12, .dead_time_loss = 192, .compensate = true,
                 .reciprocal = 9321};
    in.estimator = {.decay = 3113, .gain = 3686, .k_theta = 3277, .k_e = 541, .k_speed = 5894};
    in.speed = {.target = 1 << 22, .slew = 4000, .filter = 983, .k_p = 700, .k_i = 530,
                .limit = 12288, .lock = 1000, .slow = 100, .stop = 1000, .emf_low = 3277,
                .emf_high = 20480};
    in.control = {.k_p = 1092, .k_i = 831, .inductance = 892, .emf = 1425, .limit = 18919};
    return in;
  }

 private:
  int any(int least, int most) { return std::uniform_int_distribution<>(least, most)(random_); }
  std::mt19937 random_{1};
  int samples_ = 0;
};

// Until the lock a mean step below the lock's speed is in the wanted direction.
Estimator::In estimator_in(const SinusoidalControl::In& in) {
  const int lock = int(in.speed.lock.raw());
  return {.enable = in.estimate, .edge = in.locked ? 0 : in.reverse ? lock : -lock, .initial = in.initial, .i_u = in.i_u, .i_v = in.i_v,
          .v_dc = in.v_dc,
          .pattern = {.on_u = in.ended.on_u, .on_v = in.ended.on_v, .on_w = in.ended.on_w,
                      .period = in.bridge.period, .dead = in.bridge.dead_time_loss,
                      .inverse = in.bridge.reciprocal},
          .config = in.estimator};
}

TEST(SinusoidalControl, TheAngleIsOfThisSampleAndTheSpeedIsPassedOn) {
  SinusoidalControl control;
  Estimator estimator;
  SpeedRegulator regulator;
  Source source;
  bool moved = false;
  for (int sample = 0; sample < 200; ++sample) {
    const auto in = source.next();
    const auto out = control.tick(in);
    const auto model = estimator.tick(estimator_in(in));
    const auto speed = regulator.tick({.enable = in.regulate, .reverse = in.reverse, .locked = in.locked, .step = model.step,
                                       .emf_step = model.emf_step, .config = in.speed});
    ASSERT_EQ(out.angle, model.angle) << sample;
    ASSERT_EQ(out.speed.speed, speed.speed) << sample;
    ASSERT_EQ(out.speed.current, speed.current) << sample;
    moved |= speed.current != 0 && model.step != 0;
  }
  EXPECT_TRUE(moved);
}

// What the ended pattern says to the estimator must not be in this duty, but in the next one.
TEST(SinusoidalControl, TheDutyDoesNotWaitForTheEstimator) {
  SinusoidalControl one, other;
  Source source;
  for (int sample = 0; sample < 50; ++sample) {
    const auto in = source.next();
    one.tick(in);
    other.tick(in);
  }
  auto in = source.next(), changed = in;
  in.ended = {600, 600, 600};
  changed.ended = {620, 580, 600};
  const auto a = one.tick(in).early, b = other.tick(changed).early;
  EXPECT_TRUE(a.on_u == b.on_u && a.on_v == b.on_v && a.on_w == b.on_w);
  in = source.next();
  const auto c = one.tick(in).early, d = other.tick(in).early;
  EXPECT_FALSE(c.on_u == d.on_u && c.on_v == d.on_v && c.on_w == d.on_w);
}

TEST(SinusoidalControl, OnClocksComeEarlyAndTheSpeedWithDone) {
  SinusoidalLoop loop;
  SinusoidalControl control;
  Source source;
  for (int sample = 0; sample < 20; ++sample) {
    SinusoidalLoop::In in;
    static_cast<SinusoidalControl::In&>(in) = source.next();
    in.start = true;
    const auto before = loop.tick(in);
    const auto expected = control.tick(in);
    in.start = false;
    for (int clock = 1; clock <= SinusoidalLoop::kClocks; ++clock) {
      const auto out = loop.tick(in);
      const auto& early = clock < SinusoidalLoop::kEarly ? before.early : expected.early;
      ASSERT_EQ(out.early.on_u, early.on_u) << clock;
      ASSERT_EQ(out.early.on_w, early.on_w) << clock;
      const bool is_done = clock == SinusoidalLoop::kClocks;
      ASSERT_EQ(out.speed.speed, is_done ? expected.speed.speed : before.speed.speed) << clock;
      ASSERT_EQ(out.done, is_done);
    }
  }
}

}  // namespace
}  // namespace steplock
