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

// The four blocks in their order: the duty is of the speed and the current that the sample before asked for, and goes back at the
// angle of a sample and a half later; a sample of pilot pulses makes up for no dead time, and a pattern goes by the measured currents.
TEST(SinusoidalControl, TheDutyIsWhatItsBlocksMakeOfIt) {
  SinusoidalControl control;
  Estimator estimator;
  SpeedRegulator regulator;
  CurrentControl currents;
  SpaceVector modulator;
  Source source;
  std::mt19937 random(9);
  const auto one_in = [&](int n) { return random() % unsigned(n) == 0; };
  Int<16> speed = 0, wanted = 0;
  int turned = 0;
  for (int sample = 0; sample < 2'000; ++sample) {
    auto in = source.next();
    in.bridge.compensate = !one_in(3), in.pilot = one_in(3), in.search = one_in(4), in.hold = one_in(4);
    in.hold_u = one_in(2), in.hold_v = one_in(2), in.hold_w = one_in(2), in.hold_voltage = 900;
    in.a = int(random() % 2000) - 1000, in.b = int(random() % 2000) - 1000;
    const auto out = control.tick(in);
    const auto model = estimator.tick(estimator_in(in));
    const int angle = int(model.angle.raw()) >> 8;
    const int ahead = angle + ((int(speed.raw()) + (int(speed.raw()) >> 1)) >> 3);
    const auto c = currents.tick({.enable = in.regulate, .i_u = in.search ? in.a : in.i_u, .i_v = in.search ? in.b : in.i_v,
                                  .angle = UInt<16>(angle), .ahead = UInt<16>(ahead & 0xffff), .speed = speed,
                                  .set_gamma = in.control.set_gamma, .set_delta = wanted, .k_p = in.control.k_p, .k_i = in.control.k_i,
                                  .inductance = in.control.inductance, .emf = in.control.emf, .v_dc = in.v_dc, .limit = in.control.limit});
    const bool makes_up = in.bridge.compensate && !in.pilot;
    const auto legs = modulator.tick({.v_alpha = c.v_alpha, .v_beta = c.v_beta, .i_u = in.hold ? in.i_u : c.wanted_u,
                                      .i_v = in.hold ? in.i_v : c.wanted_v, .v_dc = in.v_dc, .period = in.bridge.period,
                                      .minimum = in.bridge.minimum, .dead = makes_up ? in.bridge.dead_time_loss : DeadClocks(0),
                                      .sine = in.bridge.sine_pwm, .hold = in.hold, .hold_u = in.hold_u, .hold_v = in.hold_v,
                                      .hold_w = in.hold_w, .hold_voltage = in.hold_voltage});
    ASSERT_TRUE(out.early.on_u == legs.on_u && out.early.on_v == legs.on_v && out.early.on_w == legs.on_w) << sample;
    ASSERT_EQ(out.i_gamma, c.i_gamma);
    ASSERT_EQ(out.i_delta, c.i_delta);
    ASSERT_EQ(out.limited, c.limited);
    turned += (ahead - angle) / 16 != 0;
    const auto next = regulator.tick({.enable = in.regulate, .reverse = in.reverse, .slow_down = in.slow_down, .locked = in.locked,
                                      .step = model.step, .emf_step = model.emf_step, .config = in.speed});
    speed = next.speed, wanted = next.current;
  }
  EXPECT_GT(turned, 1'000) << "the angle ahead is another one";
}

}  // namespace
}  // namespace steplock
