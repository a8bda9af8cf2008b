#include "hls/bus/drive_registers.hpp"

#include <gtest/gtest.h>

#include "hls/bus/sinusoidal_registers.hpp"
#include "hls/bus/six_step_registers.hpp"

namespace steplock {
namespace {

template <class Map = SixStep>
struct Bench {
  using State = typename Map::State;
  using Reason = typename Map::Reason;
  using Out = typename DriveRegisters<Map>::Out;
  DriveRegisters<Map> dut;
  typename DriveRegisters<Map>::In in;

  Out tick() {
    const auto out = dut.tick(in);
    in.request = {};
    return out;
  }
  Out write(int index, std::uint32_t data, int strobes = 15) {
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

// What holds for every map.
template <class Map>
struct DriveRegistersOf : testing::Test {};
using Maps = testing::Types<SixStep, Sinusoidal>;
TYPED_TEST_SUITE(DriveRegistersOf, Maps);

TYPED_TEST(DriveRegistersOf, ClockIsWhatItsPinsSay) {
  Bench<TypeParam> bench;
  for (const int khz : {0, 24'000, (1 << 20) - 1}) {
    bench.in.clock_khz = khz;
    EXPECT_EQ(bench.read(index_of<TypeParam>("CLOCK")), std::uint32_t(khz));
    EXPECT_EQ(bench.read(index_of<TypeParam>("CLOCK") + 1), 0u) << "nothing beside it";
  }
}

TYPED_TEST(DriveRegistersOf, ResetIsThatOfTheTable) {
  Bench<TypeParam> bench;
  bench.in.no_period = true;
  for (const Field& f : TypeParam::kSystemFields) {
    if (f.address <= 4 * index_of("CAPABILITY")) continue;  // constants: ConfigRegisters
    EXPECT_EQ(bench.read(f.address / 4) >> f.lsb & (mask_of(f) >> f.lsb), f.reset)
        << f.group << '.' << f.name;
  }
}

TYPED_TEST(DriveRegistersOf, ControlIsTheCommand) {
  Bench<TypeParam> bench;
  for (std::uint32_t bits = 0; bits < 16; ++bits) {
    const Command c = bench.write(kControl, bits).command;
    EXPECT_EQ(c.configured + 2 * c.run + 4 * c.reverse + 8 * c.brake_to_stop, bits);
    EXPECT_EQ(bench.read(kControl), bits);
  }
  EXPECT_TRUE(bench.write(kControl, 0, 14).command.run) << "no strobe, no change";
}

// A stop that an interrupt writes between a main program's read of CONTROL and its write is not undone.
TYPED_TEST(DriveRegistersOf, SetAndClearChangeTheBitsThatAreOneAndNoOther) {
  constexpr int kSet = index_of<TypeParam>("CONTROL_SET"), kClear = index_of<TypeParam>("CONTROL_CLEAR");
  Bench<TypeParam> bench;
  for (std::uint32_t was = 0; was < 16; ++was) {
    for (std::uint32_t ones = 0; ones < 16; ++ones) {
      bench.write(kControl, was);
      bench.write(kSet, ones | ~15u);
      EXPECT_EQ(bench.read(kControl), was | ones);
      bench.write(kControl, was);
      bench.write(kClear, ones | ~15u);
      EXPECT_EQ(bench.read(kControl), was & ~ones);
    }
  }
  bench.write(kControl, 5);
  EXPECT_FALSE(bench.write(kSet, 2, 14).command.run) << "no strobe, no change";
  EXPECT_TRUE(bench.write(kClear, 1, 14).command.configured);
  EXPECT_EQ(bench.read(kSet), 0u);
  EXPECT_EQ(bench.read(kClear), 0u);
}

TYPED_TEST(DriveRegistersOf, ARefusedWriteIsAnErrorAndChangesNothing) {
  Bench<TypeParam> bench;
  bench.in.refused = true;
  const auto out = bench.write(kControl, 3);
  EXPECT_TRUE(out.write_error);
  EXPECT_FALSE(out.command.run || out.command.configured);
  bench.in.refused = false;
  EXPECT_FALSE(bench.write(kControl, 3).write_error);
}

TYPED_TEST(DriveRegistersOf, AHoleReadsZeroWithAnError) {
  Bench<TypeParam> bench;
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

TYPED_TEST(DriveRegistersOf, AFaultIsStickyWithItsReasonUntilAOneIsWritten) {
  Bench<TypeParam> bench;
  bench.enter(TypeParam::State::kFault, false, TypeParam::Reason::kOverCurrent);
  EXPECT_EQ(bench.read(kFault), 0x21u);
  bench.enter(TypeParam::State::kIdle);
  EXPECT_EQ(bench.read(kFault), 0x21u) << "even when the drive has left it";
  bench.write(kFault, 0);
  EXPECT_EQ(bench.read(kFault), 0x21u) << "a zero leaves it";
  EXPECT_TRUE(bench.write(kFault, 1).command.clear_fault);
  EXPECT_FALSE(bench.tick().command.clear_fault) << "one clock";
  EXPECT_EQ(bench.read(kFault), 0x20u) << "the reason stays";
}

TYPED_TEST(DriveRegistersOf, AFaultWhoseCauseLastsStays) {
  Bench<TypeParam> bench;
  bench.enter(TypeParam::State::kFault, false, TypeParam::Reason::kFaultPin);
  bench.write(kFault, 1);
  for (int clock = 0; clock < 5; ++clock) bench.tick();
  EXPECT_EQ(bench.read(kFault) & 1, 1u);
}

TYPED_TEST(DriveRegistersOf, InterruptsFollowTheirEvents) {
  Bench<TypeParam> bench;
  bench.write(kControl, kConfigured | kRun);
  bench.enter(TypeParam::State::kRun, true);
  EXPECT_EQ(bench.read(kInterrupt), 0x14u) << "lock, started";
  bench.write(kInterrupt, 0x14);
  bench.enter(TypeParam::State::kRetryDelay, false, TypeParam::Reason::kOverCurrent);
  EXPECT_EQ(bench.read(kInterrupt), 0x08u) << "lost";
  bench.enter(TypeParam::State::kRun, true);
  EXPECT_EQ(bench.read(kInterrupt), 0x0cu) << "lock again, but not another start";
  bench.enter(TypeParam::State::kFault, false, TypeParam::Reason::kFaultPin);
  EXPECT_EQ(bench.read(kInterrupt), 0x0du);
  EXPECT_FALSE(bench.tick().interrupt) << "none enabled";
  bench.write(kEnable, 0x01);
  EXPECT_TRUE(bench.tick().interrupt);
  bench.write(kInterrupt, 0x01);
  EXPECT_FALSE(bench.tick().interrupt);
  EXPECT_EQ(bench.read(kInterrupt), 0x0cu) << "a zero leaves the others";
}

TYPED_TEST(DriveRegistersOf, AnEventWinsOverItsAcknowledgement) {
  Bench<TypeParam> bench;
  bench.in.request = {.write = true, .index = kInterrupt, .data = 0x1f, .strobes = 15};
  bench.enter(TypeParam::State::kFault);
  EXPECT_EQ(bench.read(kInterrupt), 0x01u);
}

TYPED_TEST(DriveRegistersOf, AStopIsNoLostLock) {
  Bench<TypeParam> bench;
  bench.enter(TypeParam::State::kRun, true);
  bench.enter(TypeParam::State::kIdle);
  EXPECT_EQ(bench.read(kInterrupt) & bit(field("INTERRUPT", "lost")), 0u);
}

TYPED_TEST(DriveRegistersOf, WithoutAHeartbeatTheBridgeGoesOffAndStaysOff) {
  Bench<TypeParam> bench;
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

// Neither what goes to another register, nor what was refused.
TYPED_TEST(DriveRegistersOf, OnlyAHeartbeatIsOne) {
  for (const bool refused : {false, true}) {
    Bench<TypeParam> bench;
    bench.write(index_of("WATCHDOG"), 3);
    bench.write(kControl, kConfigured | kRun);
    bench.in.tick = true;
    bench.in.refused = refused;
    for (int i = 0; i < 4; ++i) bench.write(refused ? index_of("HEARTBEAT") : kEnable, 0);
    EXPECT_FALSE(bench.tick().command.configured) << refused;
  }
}

TYPED_TEST(DriveRegistersOf, AWatchdogThatHasExpiredExpiresOnce) {
  Bench<TypeParam> bench;
  bench.write(index_of("WATCHDOG"), 3);
  bench.in.tick = true;
  for (int tick = 0; tick < 20; ++tick) bench.tick();
  EXPECT_EQ(bench.read(kFault), 0u) << "not before the drive is configured";
  bench.write(kControl, kConfigured | kRun);
  for (int tick = 0; tick < 20; ++tick) bench.tick();
  EXPECT_EQ(bench.read(kInterrupt), 2u);
  bench.write(kInterrupt, 2);
  for (int tick = 0; tick < 20; ++tick) bench.tick();
  EXPECT_EQ(bench.read(kInterrupt), 0u);
  EXPECT_EQ(bench.read(kFault), 2u);
}

// Of FAULT itself, one bit each.
TYPED_TEST(DriveRegistersOf, OnlyAOneInAFaultsOwnPlaceClearsIt) {
  Bench<TypeParam> bench;
  bench.write(index_of("WATCHDOG"), 1);
  bench.write(kControl, kConfigured | kRun);
  bench.enter(TypeParam::State::kFault, false, TypeParam::Reason::kOverCurrent);
  bench.in.tick = true;
  for (int tick = 0; tick < 5; ++tick) bench.tick();
  bench.enter(TypeParam::State::kIdle);
  ASSERT_EQ(bench.read(kFault), 0x23u);
  bench.write(kEnable, 3);
  EXPECT_EQ(bench.read(kFault), 0x23u) << "a write to another register";
  bench.in.refused = true;
  bench.write(kFault, 3);
  bench.in.refused = false;
  EXPECT_EQ(bench.read(kFault), 0x23u) << "a refused one";
  bench.write(kFault, 1);
  EXPECT_EQ(bench.read(kFault), 0x22u);
  EXPECT_FALSE(bench.tick().command.configured) << "the watchdog's stays";
  EXPECT_TRUE(bench.write(kFault, 2).command.configured);
}

TYPED_TEST(DriveRegistersOf, AWatchdogSetWhileConfiguredWaitsItsWholeTime) {
  Bench<TypeParam> bench;
  bench.write(kControl, kConfigured);
  bench.in.tick = true;
  bench.write(index_of("WATCHDOG"), 5);
  for (int tick = 0; tick < 4; ++tick) EXPECT_TRUE(bench.tick().command.configured) << tick;
  for (int tick = 0; tick < 4; ++tick) bench.tick();
  EXPECT_FALSE(bench.tick().command.configured);
}

TEST(DriveRegisters, ASnapshotIsOfOneInstant) {
  Bench<> bench;
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

// Negative numbers keep to their own half of a register.
TEST(DriveRegisters, ASnapshotOfTheSinusoidalDriveIsOfOneInstant) {
  Bench<Sinusoidal> bench;
  bench.in.drive = {.speed = -1, .reference = 2, .i_gamma = -3, .i_delta = 0x7fff, .angle = 0xfedc, .v_dc = 0xabc,
                    .on_u = 1, .on_v = 0x3fff, .on_w = 3, .retries = 15};
  bench.write(index_of("SNAPSHOT"), 1);
  bench.in.drive = {};
  EXPECT_EQ(bench.read(index_of<Sinusoidal>("TELEMETRY_SPEED")), 0x0002ffffu);
  EXPECT_EQ(bench.read(index_of<Sinusoidal>("TELEMETRY_CURRENT")), 0x7ffffffdu);
  EXPECT_EQ(bench.read(index_of<Sinusoidal>("TELEMETRY_ANGLE")), 0x0abcfedcu);
  EXPECT_EQ(bench.read(index_of<Sinusoidal>("TELEMETRY_LEGS")), 0x3fff0001u);
  EXPECT_EQ(bench.read(index_of<Sinusoidal>("TELEMETRY_RETRIES")), 0x0003000fu);
}

TEST(DriveRegisters, OnlyTheNextSnapshotChangesWhatWasTaken) {
  Bench<> bench;
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

TYPED_TEST(DriveRegistersOf, WithoutAPeriodTheDriveIsNotConfigured) {
  Bench<TypeParam> bench;
  bench.in.no_period = true;
  EXPECT_FALSE(bench.write(kControl, kConfigured).command.configured);
  EXPECT_EQ(bench.read(kControl), kConfigured) << "what was written stays";
  EXPECT_TRUE(bench.read(index_of("STATUS")) & bit(field("STATUS", "no_period")));
  bench.in.no_period = false;
  EXPECT_TRUE(bench.tick().command.configured);
  EXPECT_FALSE(bench.read(index_of("STATUS")) & bit(field("STATUS", "no_period")));
}

TYPED_TEST(DriveRegistersOf, StoppedMeansIdleAndNotToldToRun) {
  Bench<TypeParam> bench;
  EXPECT_TRUE(bench.tick().stopped);
  EXPECT_FALSE(bench.write(kControl, kRun).stopped);
  EXPECT_TRUE(bench.write(kControl, 0).stopped);
  bench.in.drive.state = TypeParam::State::kBrake;
  EXPECT_FALSE(bench.tick().stopped);
}

}  // namespace
}  // namespace steplock
