// Requests without a bus; the map itself is tested through each bus (six_step_axi_test and its like).
#include "hls/bus/six_step_csr.hpp"

#include <gtest/gtest.h>

#include "tests/hls/map_model.hpp"

namespace steplock {
namespace {

BusRequest reading(int address) { return {.read = true, .index = WordIndex::of(address / 4)}; }
BusRequest writing(int address, std::uint32_t data) {
  return {.write = true, .index = WordIndex::of(address / 4), .data = data, .strobes = 15};
}

TEST(SixStepCsr, AnAnswerComesInTheNextClockAndStaysUntilTheNextRequestOfItsKind) {
  SixStepCsr dut;
  dut.tick({.pins = {}, .request = reading(0)});
  for (int clock = 0; clock < 5; ++clock) {
    const auto out = dut.tick({.pins = {}, .request = writing(0, 1)});
    EXPECT_EQ(out.data, UInt<32>(kMapId)) << "a write changes nothing of a read's answer";
    EXPECT_FALSE(out.read_error);
    EXPECT_EQ(out.write_error, clock > 0) << "the ID is read-only";
  }
  dut.tick({.pins = {}, .request = reading(0xffc)});
  const auto out = dut.tick({});
  EXPECT_TRUE(out.read_error) << "a hole";
  EXPECT_EQ(out.data, UInt<32>(0));
  EXPECT_TRUE(out.write_error) << "of the write before";
}

TEST(SixStepCsr, WhatWasWrittenIsReadBackInTheClockAfter) {
  SixStepCsr dut;
  dut.tick({.pins = {}, .request = writing(kPwm, 0x01000190)});
  dut.tick({.pins = {}, .request = reading(kPwm)});
  EXPECT_EQ(dut.tick({}).data, UInt<32>(0x01000190));
}

TEST(SixStepCsr, CapabilityTellsWhatIsLeftOut) {
  constexpr int capability = address_of(index_of("CAPABILITY"));
  constexpr std::uint32_t parts[] = {mask_of(field("CAPABILITY", "hall")), mask_of(field("CAPABILITY", "ramp")),
                                     mask_of(field("CAPABILITY", "follower")), mask_of(field("CAPABILITY", "counters"))};
  for (unsigned there = 0; there < 16; ++there) {
    SixStepCsr dut;
    const auto has = [&](int part) { return (there >> part & 1) != 0; };
    const Parts with{.hall_decoder = has(0), .ramp = has(1), .follower = has(2), .telemetry = has(3)};
    const auto read = [&](int address) {
      dut.tick({.with = with, .pins = {}, .request = reading(address)});
      return dut.tick({.with = with}).data;
    };
    std::uint32_t expected = reset_of("CAPABILITY");
    for (int part = 0; part < 4; ++part) {
      if (!has(part)) expected &= ~parts[part];
    }
    EXPECT_EQ(read(capability), UInt<32>::of(expected)) << there;
    EXPECT_EQ(read(0), UInt<32>(kMapId)) << "and nothing else is changed";
  }
}

// Clocks in which each gate was on, in a run of half duty with a reset pattern that lasts, and what a leg shows.
struct Life {
  int high = 0, low = 0, both = 0, shortest_gap = 1 << 30;
};
struct Value {
  int address;
  std::uint32_t data;
};
template <class... Values>
Life life_with(Values... bad) {
  constexpr int lock = address_of(index_of("LOCK"));
  SixStepCsr dut;
  const auto write = [&](Value v) { dut.tick({.pins = {}, .request = writing(v.address, v.data)}); };
  write({lock, kLockKey});
  write({kPwm, 1u << 24 | 200});
  write({address_of(index_of("START_ALIGN")), 4095u << 16});
  write({address_of(index_of("START_DUTY")), 0x4000});
  write({address_of(index_of("SPEED_TARGET")), 0x1000});
  write({address_of(index_of("SPEED_DUTY")), 0x8000u << 16});
  write({address_of(index_of("SPEED_DUTY_SLEW")), 0xfff});
  (write(bad), ...);
  write({kControl, 3});
  Life life;
  int off_for[3] = {1 << 20, 1 << 20, 1 << 20};
  Gates was;
  for (int clock = 0; clock < 50'000; ++clock) {
    const Gates g = dut.tick({}).gates;
    const bool highs[] = {g.uh, g.vh, g.wh}, lows[] = {g.ul, g.vl, g.wl};
    const bool were_high[] = {was.uh, was.vh, was.wh}, were_low[] = {was.ul, was.vl, was.wl};
    for (int leg = 0; leg < 3; ++leg) {
      life.high += highs[leg];
      life.low += lows[leg];
      life.both += highs[leg] && lows[leg];
      const bool turns_on = (highs[leg] && !were_high[leg]) || (lows[leg] && !were_low[leg]);
      if (turns_on && off_for[leg] < life.shortest_gap) life.shortest_gap = off_for[leg];
      off_for[leg] = highs[leg] || lows[leg] ? 0 : off_for[leg] + 1;
    }
    was = g;
  }
  return life;
}

// As docs/programmers_guide.md has it, "Values that make no sense".
TEST(SixStepCsr, ValuesThatMakeNoSenseLeaveTheBridgeSafe) {
  constexpr int limits = address_of(index_of("PWM_LIMITS"));
  constexpr int duty = address_of(index_of("START_DUTY"));
  const std::uint32_t complementary = 1u << 17;
  const Life good = life_with();
  EXPECT_GT(good.high, 5000);
  EXPECT_GT(good.low, 5000);

  const Life no_period = life_with(Value{kPwm, 1u << 24});
  EXPECT_EQ(no_period.high + no_period.low, 0) << "all six gates are off";

  const Life no_dead_time = life_with(Value{kPwm, 1u << 24 | complementary | 200}, Value{limits, 0});
  EXPECT_GE(no_dead_time.shortest_gap, int(kDeadTimeFloor));
  const Life long_dead_time =
      life_with(Value{kPwm, 1u << 24 | complementary | 200}, Value{limits, 255u << 16});
  EXPECT_EQ(long_dead_time.high, 0) << "a pulse of the dead time or less never comes";
  EXPECT_GT(long_dead_time.low, 0);

  const Life large_duty = life_with(Value{duty, 0xffff});
  const Life full_duty = life_with(Value{duty, 0x8000});
  EXPECT_EQ(large_duty.high, full_duty.high) << "above the period is all of it";
  EXPECT_GT(full_duty.high, 3 * good.high / 2);

  const Life large_minimum = life_with(Value{limits, 0xffff});
  EXPECT_EQ(large_minimum.high, 0) << "every pulse is shorter";

  const Life nothing = life_with(Value{address_of(index_of("START_ALIGN")), 0}, Value{duty, 0});
  for (const Life& life : {good, no_period, no_dead_time, long_dead_time, large_duty, full_duty,
                           large_minimum, nothing}) {
    EXPECT_EQ(life.both, 0);
    EXPECT_GE(life.shortest_gap, int(kDeadTimeFloor));
  }
}

// Without the registers a period of 0 holds a low side on: what the test above would see.
TEST(SixStepCsr, TheDriveItselfTakesAPeriodOfZeroForNoPulse) {
  SixStepTop drive;
  SixStepTop::In in;
  in.command = {.configured = true, .run = true};
  in.config.speed.target = 0x1000;
  in.config.start.align = 4095;
  in.config.start.align_duty = 0x4000;
  int on = 0;
  for (int clock = 0; clock < 50'000; ++clock) {
    const Gates g = drive.tick(in).gates;
    on += g.ul || g.vl || g.wl;
  }
  EXPECT_GT(on, 40'000);
}

TEST(SixStepCsr, APeriodOfZeroIsToldAndMended) {
  constexpr std::uint32_t bit = 1u << field("STATUS", "no_period").lsb;
  SixStepCsr dut;
  const auto status = [&] {
    dut.tick({});
    dut.tick({.pins = {}, .request = reading(kStatus)});
    return std::uint32_t(dut.tick({}).data.raw());
  };
  EXPECT_TRUE(status() & bit) << "after a reset";
  dut.tick({.pins = {}, .request = writing(kPwm, 1u << 24 | 200)});
  EXPECT_FALSE(status() & bit);
  dut.tick({.pins = {}, .request = writing(kPwm, 1u << 24)});
  EXPECT_TRUE(status() & bit);
}

}  // namespace
}  // namespace steplock
