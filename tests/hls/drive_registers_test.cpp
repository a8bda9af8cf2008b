#include "hls/bus/drive_registers.hpp"

#include <gtest/gtest.h>

namespace steplock {
namespace {

struct Bench {
  DriveRegisters dut;
  DriveRegisters::In in;

  DriveRegisters::Out tick() {
    const auto out = dut.tick(in);
    in.request = {};
    return out;
  }
  DriveRegisters::Out write(int index, std::uint32_t data, int strobes = 15) {
    in.request = {.write = true, .index = index, .data = data, .strobes = strobes};
    tick();
    return tick();
  }
  std::uint32_t read(int index) {
    in.request = {.read = true, .index = index};
    tick();
    return std::uint32_t(tick().data.raw());
  }
  void enter(State state, bool locked = false, Reason reason = Reason::kNone) {
    in.drive.state = state;
    in.drive.locked = locked;
    in.drive.reason = reason;
    tick();
  }
};

constexpr std::uint32_t bit(const Field& f) { return 1u << f.lsb; }
constexpr int kControl = index_of("CONTROL"), kFault = index_of("FAULT");
constexpr int kInterrupt = index_of("INTERRUPT"), kEnable = index_of("INTERRUPT_ENABLE");
constexpr std::uint32_t kConfigured = bit(field("CONTROL", "configured"));
constexpr std::uint32_t kRun = bit(field("CONTROL", "run"));

TEST(DriveRegisters, ResetIsThatOfTheTable) {
  Bench bench;
  bench.in.no_period = true;
  for (const Field& f : kSystemFields) {
    if (f.address <= 4 * index_of("CAPABILITY")) continue;  // constants: WordRegisters
    EXPECT_EQ(bench.read(f.address / 4) >> f.lsb & (mask_of(f) >> f.lsb), f.reset)
        << f.group << '.' << f.name;
  }
}

TEST(DriveRegisters, ControlIsTheCommand) {
  Bench bench;
  for (std::uint32_t bits = 0; bits < 16; ++bits) {
    const Command c = bench.write(kControl, bits).command;
    EXPECT_EQ(c.configured + 2 * c.run + 4 * c.reverse + 8 * c.brake_to_stop, bits);
    EXPECT_EQ(bench.read(kControl), bits);
  }
  EXPECT_TRUE(bench.write(kControl, 0, 14).command.run) << "no strobe, no change";
}

TEST(DriveRegisters, ARefusedWriteIsAnErrorAndChangesNothing) {
  Bench bench;
  bench.in.refused = true;
  const auto out = bench.write(kControl, 3);
  EXPECT_TRUE(out.write_error);
  EXPECT_FALSE(out.command.run || out.command.configured);
  bench.in.refused = false;
  EXPECT_FALSE(bench.write(kControl, 3).write_error);
}

TEST(DriveRegisters, AHoleReadsZeroWithAnError) {
  Bench bench;
  bench.in.word = 77;
  EXPECT_EQ(bench.read(0x20), 77u) << "a word register";
  bench.in.word = 0;
  bench.read(kInterrupt);
  bench.in.hole = true;
  bench.in.request = {.read = true, .index = 0x3f};
  bench.tick();
  const auto out = bench.tick();
  EXPECT_TRUE(out.read_error);
  EXPECT_EQ(out.data, UInt<32>(0));
}

TEST(DriveRegisters, AFaultIsStickyWithItsReasonUntilAOneIsWritten) {
  Bench bench;
  bench.enter(State::kFault, false, Reason::kOverCurrent);
  EXPECT_EQ(bench.read(kFault), 0x21u);
  bench.enter(State::kIdle);
  EXPECT_EQ(bench.read(kFault), 0x21u) << "even when the drive has left it";
  bench.write(kFault, 0);
  EXPECT_EQ(bench.read(kFault), 0x21u) << "a zero leaves it";
  EXPECT_TRUE(bench.write(kFault, 1).command.clear_fault);
  EXPECT_FALSE(bench.tick().command.clear_fault) << "one clock";
  EXPECT_EQ(bench.read(kFault), 0x20u) << "the reason stays";
}

TEST(DriveRegisters, AFaultWhoseCauseLastsStays) {
  Bench bench;
  bench.enter(State::kFault, false, Reason::kFaultPin);
  bench.write(kFault, 1);
  for (int clock = 0; clock < 5; ++clock) bench.tick();
  EXPECT_EQ(bench.read(kFault) & 1, 1u);
}

TEST(DriveRegisters, InterruptsFollowTheirEvents) {
  Bench bench;
  bench.write(kControl, kConfigured | kRun);
  bench.enter(State::kRun, true);
  EXPECT_EQ(bench.read(kInterrupt), 0x14u) << "lock, started";
  bench.write(kInterrupt, 0x14);
  bench.enter(State::kRest, false, Reason::kStepOut);
  EXPECT_EQ(bench.read(kInterrupt), 0x08u) << "lost";
  bench.enter(State::kRun, true);
  EXPECT_EQ(bench.read(kInterrupt), 0x0cu) << "lock again, but not another start";
  bench.enter(State::kFault, false, Reason::kFaultPin);
  EXPECT_EQ(bench.read(kInterrupt), 0x0du);
  EXPECT_FALSE(bench.tick().interrupt) << "none enabled";
  bench.write(kEnable, 0x01);
  EXPECT_TRUE(bench.tick().interrupt);
  bench.write(kInterrupt, 0x01);
  EXPECT_FALSE(bench.tick().interrupt);
  EXPECT_EQ(bench.read(kInterrupt), 0x0cu) << "a zero leaves the others";
}

TEST(DriveRegisters, AnEventWinsOverItsAcknowledgement) {
  Bench bench;
  bench.in.request = {.write = true, .index = kInterrupt, .data = 0x1f, .strobes = 15};
  bench.enter(State::kFault);
  EXPECT_EQ(bench.read(kInterrupt), 0x01u);
}

TEST(DriveRegisters, AStopIsNoLostLock) {
  Bench bench;
  bench.enter(State::kRun, true);
  bench.enter(State::kIdle);
  EXPECT_EQ(bench.read(kInterrupt) & bit(field("INTERRUPT", "lost")), 0u);
}

TEST(DriveRegisters, WithoutAHeartbeatTheBridgeGoesOffAndStaysOff) {
  Bench bench;
  bench.write(index_of("WATCHDOG"), 3);
  bench.write(kControl, kConfigured | kRun);
  bench.in.tick = true;
  for (int i = 0; i < 20; ++i) {  // a beat every second tick
    EXPECT_TRUE(bench.write(index_of("HEARTBEAT"), 1).command.configured);
  }
  for (int tick = 0; tick < 3; ++tick) EXPECT_TRUE(bench.tick().command.configured);
  bench.tick();
  const auto out = bench.tick();
  EXPECT_FALSE(out.command.configured || out.command.run);
  EXPECT_EQ(bench.read(kFault), 2u);
  EXPECT_EQ(bench.read(kInterrupt), 2u);
  bench.write(index_of("HEARTBEAT"), 1);
  EXPECT_FALSE(bench.tick().command.configured) << "a late beat is none";
  const Command again = bench.write(kFault, 2).command;
  EXPECT_TRUE(again.configured);
  EXPECT_FALSE(again.run) << "nothing starts by itself";
}

TEST(DriveRegisters, AWatchdogSetWhileConfiguredWaitsItsWholeTime) {
  Bench bench;
  bench.write(kControl, kConfigured);
  bench.in.tick = true;
  bench.write(index_of("WATCHDOG"), 5);
  for (int tick = 0; tick < 4; ++tick) EXPECT_TRUE(bench.tick().command.configured) << tick;
  for (int tick = 0; tick < 4; ++tick) bench.tick();
  EXPECT_FALSE(bench.tick().command.configured);
}

TEST(DriveRegisters, ASnapshotIsOfOneInstant) {
  Bench bench;
  bench.in.drive.frequency = 1000;
  bench.in.drive.duty = 2000;
  bench.in.drive.phase_error = -2;
  bench.in.drive.counts = {.crossings = 1, .missed = 2, .freewheel_long = 3, .limit_hits = 4,
                           .retries = 5};
  bench.write(index_of("SNAPSHOT"), 1);
  bench.in.drive = {};
  EXPECT_EQ(bench.read(index_of("TELEMETRY_SPEED")), 1000u);
  EXPECT_EQ(bench.read(index_of("TELEMETRY_LOOP")), 0xfffe07d0u);
  EXPECT_EQ(bench.read(index_of("TELEMETRY_CROSSINGS")), 0x00020001u);
  EXPECT_EQ(bench.read(index_of("TELEMETRY_LIMITS")), 0x00040003u);
  EXPECT_EQ(bench.read(index_of("TELEMETRY_RETRIES")), 5u);
}

TEST(DriveRegisters, OnlyTheNextSnapshotChangesWhatWasTaken) {
  Bench bench;
  const int speed = index_of("TELEMETRY_SPEED");
  bench.in.drive.frequency = 7;
  EXPECT_EQ(bench.read(speed), 0u) << "none was taken";
  bench.write(index_of("SNAPSHOT"), 0, 0);
  bench.in.drive.frequency = 8;
  EXPECT_EQ(bench.read(speed), 7u) << "any write is one";
  EXPECT_EQ(bench.read(kInterrupt), 0u) << "nothing of the copies in other registers";
  bench.in.refused = true;
  bench.write(index_of("SNAPSHOT"), 1);
  bench.in.refused = false;
  EXPECT_EQ(bench.read(speed), 7u);
  bench.write(index_of("SNAPSHOT"), 1);
  EXPECT_EQ(bench.read(speed), 8u);
}

TEST(DriveRegisters, WithoutAPeriodTheDriveIsNotConfigured) {
  Bench bench;
  bench.in.no_period = true;
  EXPECT_FALSE(bench.write(kControl, kConfigured).command.configured);
  EXPECT_EQ(bench.read(kControl), kConfigured) << "what was written stays";
  EXPECT_TRUE(bench.read(index_of("STATUS")) & bit(field("STATUS", "no_period")));
  bench.in.no_period = false;
  EXPECT_TRUE(bench.tick().command.configured);
  EXPECT_FALSE(bench.read(index_of("STATUS")) & bit(field("STATUS", "no_period")));
}

TEST(DriveRegisters, StoppedMeansIdleAndNotToldToRun) {
  Bench bench;
  EXPECT_TRUE(bench.tick().stopped);
  EXPECT_FALSE(bench.write(kControl, kRun).stopped);
  EXPECT_TRUE(bench.write(kControl, 0).stopped);
  bench.in.drive.state = State::kBrake;
  EXPECT_FALSE(bench.tick().stopped);
}

}  // namespace
}  // namespace steplock
