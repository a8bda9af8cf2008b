// What the pins of a drive without a host do; that it turns a motor is standalone_drive_test's claim.
#include "hls/six_step/six_step_standalone.hpp"

#include <gtest/gtest.h>

namespace steplock {
namespace {

constexpr int kBounce = 1 << 17;  // clocks between two looks at the pins

// A reset pattern that lasts, half of the time on.
SixStepConfig lasting_config() {
  SixStepConfig w;
  w.pwm = {.period = 200, .minimum = 4, .dead_time = 14, .tick_periods = 100};
  w.start = {.pre_align = 4095, .align_duty = 0x4000, .hand_over = 1 << 20};
  w.speed = {.target = 1 << 23, .maximum = 0x8000, .duty_slew = 0xfff};
  return w;
}

struct Bench {
  SixStepStandalone dut;
  SixStepStandalone::In in{.pins = {}, .controls = {}, .config = lasting_config()};
  SixStepStandalone::Out out;

  bool any_gate() const {
    const Gates& g = out.gates;
    return g.uh || g.ul || g.vh || g.vl || g.wh || g.wl;
  }
  // Clocks until the first gate is on, or `most`.
  int until_gate(int most) {
    for (int clock = 1; clock <= most; ++clock) {
      out = dut.tick(in);
      if (any_gate()) return clock;
    }
    return most;
  }
  void wait(int clocks) {
    for (int i = 0; i < clocks; ++i) out = dut.tick(in);
  }
};

TEST(SixStepStandalone, RunStartsAtTheNextLookAtThePins) {
  Bench bench;
  bench.wait(10);
  bench.in.controls.run = true;
  const int clocks = bench.until_gate(2 * kBounce);
  EXPECT_GT(clocks, kBounce - 10);
  EXPECT_LT(clocks, kBounce + 1000);  // and a few PWM periods
}

TEST(SixStepStandalone, NothingStartsWithoutRun) {
  Bench bench;
  bench.in.controls = {.reverse = true, .speed = 3};
  EXPECT_EQ(bench.until_gate(3 * kBounce), 3 * kBounce);
}

TEST(SixStepStandalone, AClosingSwitchThatBouncesStartsOnce) {
  Bench bench;
  // Open between the bounces: whenever it is, the gates are off.
  for (int i = 0; i < 200; ++i) {
    bench.in.controls.run = i % 2 == 0;
    bench.wait(500);
  }
  bench.in.controls.run = true;
  EXPECT_LT(bench.until_gate(2 * kBounce), 2 * kBounce);
}

// Two clocks of the synchroniser, one register, one clock of the gate guard.
TEST(SixStepStandalone, TheEndOfRunCountsAtOnce) {
  Bench bench;
  bench.in.controls.run = true;
  ASSERT_LT(bench.until_gate(2 * kBounce), 2 * kBounce);
  for (int start = 0; start < 40; ++start) {
    Bench copy = bench;
    copy.wait(start * 17);
    copy.in.controls.run = false;
    copy.wait(5);  // three to the drive, two from there
    for (int i = 0; i < 3 * kBounce / 2; ++i) {
      copy.wait(1);
      ASSERT_FALSE(copy.any_gate()) << start << " + " << i;
      if (i == 1000) i = kBounce;  // and after the next look
    }
  }
}

TEST(SixStepStandalone, AFaultStopsInThreeClocksAndStaysWhileRunIsHeld) {
  Bench bench;
  bench.in.controls.run = true;
  ASSERT_LT(bench.until_gate(2 * kBounce), 2 * kBounce);
  bench.in.pins.fault = true;
  bench.wait(4);
  EXPECT_FALSE(bench.any_gate());
  bench.wait(3);
  EXPECT_TRUE(bench.out.fault);
  bench.in.pins.fault = false;
  EXPECT_EQ(bench.until_gate(3 * kBounce), 3 * kBounce);
  EXPECT_TRUE(bench.out.fault);
}

TEST(SixStepStandalone, TakingRunAwayRearmsAsSoonAsTheCauseIsGone) {
  Bench bench;
  bench.in.controls.run = true;
  ASSERT_LT(bench.until_gate(2 * kBounce), 2 * kBounce);
  bench.in.pins.fault = true;
  bench.wait(100);
  bench.in.controls.run = false;
  bench.wait(3 * kBounce);
  EXPECT_TRUE(bench.out.fault) << "the pin is still up";
  bench.in.pins.fault = false;
  bench.wait(kBounce + 10);
  EXPECT_FALSE(bench.out.fault);
  bench.in.controls.run = true;
  EXPECT_LT(bench.until_gate(2 * kBounce), 2 * kBounce);
}

// A drive with Hall sensors, on a rotor turned by hand: what it is told to reach shows in its pulses.
struct Turned {
  SixStepConfig config = lasting_config();
  Turned() {
    config.source = Source::kHall;
    config.loop = {.divide = 0, .ki = 655, .kp = 6554, .minimum = 1 << 16, .maximum = 1 << 25};
    config.start = {.pre_align = 2, .align = 3, .align_duty = 0x4000, .start_duty = 0x4000, .ramp = 0xfffff,
                   .hand_over = 1 << 20, .window = 0x7fff, .good_crossings = 2, .pull_in = 4000,
                   .detect_spin = 200, .retries = 15};
    config.speed = {.target = 0, .slew = 0xfffff, .shift = 9, .kp = 4096, .ki = 100, .bemf = 0x2000,
                   .minimum = 0x100, .maximum = 0x8000, .duty_slew = 0xfff};
  }
  static void turn(Synchroniser::Pins& pins, int clock) {
    static constexpr int kCodes[] = {5, 4, 6, 2, 3, 1};
    const int code = kCodes[clock / 2048 % 6];  // 2^21 turns of the VCO per clock
    pins.hall_u = (code & 4) != 0;
    pins.hall_v = (code & 2) != 0;
    pins.hall_w = (code & 1) != 0;
  }
};

// Clocks in which the bare drive at `speed` and one whose host asks for `target` show the same gates.
bool same_gates(int speed, Frequency whole, std::int64_t target) {
  SixStepStandalone bare;
  SixStepTop drive;
  SixStepStandalone::In in{.pins = {}, .controls = {.run = true, .speed = speed}, .config = Turned().config};
  in.config.speed.target = whole;
  SixStepTop::In host{.pins = {}, .command = {.configured = true}, .config = in.config};
  host.config.speed.target = Frequency::of(target);
  bool same = true, locked = false;
  for (int i = 0; i < kBounce + 120000; ++i) {
    Turned::turn(in.pins, i);
    host.pins = in.pins;
    const auto out = bare.tick(in);
    host.command.run = i > kBounce + 2;  // the look, what it took, and whether that is to run: a clock each
    host.command.clear_fault = i == 1 || i == kBounce + 1;
    const auto wanted = drive.tick(host);
    same = same && wanted.gates == out.gates && wanted.locked == out.locked;
    locked = locked || out.locked;
  }
  EXPECT_TRUE(locked) << "else nothing of the target is seen";
  return same;
}

TEST(SixStepStandalone, IsTheDriveToldAQuarterToTheWholeOfItsSpeed) {
  const std::int64_t whole = (1 << 22) + 3;
  EXPECT_TRUE(same_gates(0, Frequency::of(whole), whole / 4));
  EXPECT_TRUE(same_gates(1, Frequency::of(whole), whole / 2));
  EXPECT_TRUE(same_gates(2, Frequency::of(whole), whole / 2 + whole / 4));
  EXPECT_TRUE(same_gates(3, Frequency::of(whole), whole));
  EXPECT_FALSE(same_gates(3, Frequency::of(whole), whole / 2)) << "the control";
}

TEST(SixStepStandalone, AsksForTheHandOverFrequencyAtLeast) {
  const std::int64_t hand_over = Turned().config.start.hand_over.raw();
  EXPECT_TRUE(same_gates(0, Frequency::of(2 * hand_over), hand_over));
}

}  // namespace
}  // namespace steplock
