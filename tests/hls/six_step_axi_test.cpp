// The whole drive through its bus: random traffic against a model of the map made of the table, and
// what a host does to a motor.
#include "hls/bus/six_step_axi.hpp"

#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

#include <functional>
#include <optional>
#include <random>

#include "testbench/bus/axi_master.hpp"
#include "tests/hls/map_model.hpp"

namespace steplock {
namespace {

struct Bench {
  SixStepAxi dut;
  Synchroniser::Pins pins;
  SixStepAxi::Out out;

  SixStepAxi::Axi clock(const AxiLite::In& axi) {
    out = dut.tick({.pins = pins, .axi = axi});
    return out.axi;
  }
  void wait(int clocks) {
    for (int i = 0; i < clocks; ++i) clock({});
  }
  bool write(int address, std::uint32_t data) { return master_.write(address, data).okay; }
  std::uint32_t read(int address) { return master_.read(address).data; }
  bool any_gate() const {
    const Gates& g = out.gates;
    return g.uh || g.ul || g.vh || g.vl || g.wh || g.wl;
  }
  // A reset pattern that lasts, half of the time on.
  void start() {
    write(kPwm, 1u << 24 | 200);
    write(address_of(index_of("START_RESET")), 4095u << 16);
    write(address_of(index_of("START_DUTY")), 0x4000);
    write(address_of(index_of("SPEED_DUTY")), 0x8000u << 16);
    write(address_of(index_of("SPEED_DUTY_SLEW")), 0xfff);
    write(kControl, 3);
  }
  bool gates_move(int clocks = 2000) {
    bool moved = false;
    for (int i = 0; i < clocks; ++i) {
      clock({});
      moved = moved || any_gate();
    }
    return moved;
  }

 private:
  std::function<SixStepAxi::Axi(const AxiLite::In&)> step_ = [this](const AxiLite::In& axi) {
    return clock(axi);
  };
  AxiMaster<decltype(step_)> master_{step_};
};

// Channels begin and wait at random and independently; every answer is the one that the order of
// acceptance demands, and while it waits for its host it stands still.
void random_traffic(int clocks, std::uint64_t seed, std::optional<int> lie_at = {}) {
  std::mt19937_64 random(seed);
  const auto chance = [&](int percent) { return int(random() % 100) < percent; };
  const auto address = [&] {
    return chance(10) ? int(random() % 4096) : chance(20) ? kLock : int(random() % 64) * 4;
  };
  SixStepAxi dut;
  MapModel model;
  AxiLite::In in;
  SixStepAxi::Axi before;
  AxiLite::In was;
  struct Pending {
    bool waits = false, okay = false;
    std::uint32_t data = 0;
  };
  Pending written, wanted;
  int writes = 0, reads = 0;
  for (int clock = 0; clock < clocks; ++clock) {
    if (!in.awvalid && chance(30)) {
      in.awvalid = true;
      in.awaddr = address();
      if (in.awaddr >> 2 == UInt<12>(index_of("WATCHDOG"))) in.awaddr = kLock;  // it would bite
    }
    if (!in.wvalid && chance(30)) {
      in.wvalid = true;
      in.wdata = chance(30) ? kLockKey : std::uint32_t(random());
      in.wstrb = chance(60) ? 15 : int(random() % 16);
    }
    // Run stays low: this is the traffic of an idle drive.
    if (in.awaddr >> 2 == UInt<12>(index_of("CONTROL"))) in.wdata = in.wdata & ~UInt<32>(2);
    if (!in.arvalid && chance(30)) {
      in.arvalid = true;
      in.araddr = address();
    }
    in.bready = chance(40);
    in.rready = chance(40);
    auto out = dut.tick({.pins = {}, .axi = in}).axi;
    if (lie_at == clock) out.bvalid = !out.bvalid;

    ASSERT_EQ(out.bvalid, written.waits) << "clock " << clock;
    ASSERT_EQ(out.rvalid, wanted.waits) << "clock " << clock;
    if (before.bvalid && !was.bready) {
      ASSERT_EQ(out.bresp, before.bresp);
    }
    if (before.rvalid && !was.rready) {
      ASSERT_EQ(out.rdata, before.rdata);
      ASSERT_EQ(out.rresp, before.rresp);
    }
    if (out.bvalid && in.bready) {
      ASSERT_EQ(out.bresp, UInt<2>(written.okay ? 0 : 2)) << "clock " << clock;
      written.waits = false;
      ++writes;
    }
    if (out.rvalid && in.rready) {
      ASSERT_EQ(out.rresp, UInt<2>(wanted.okay ? 0 : 2)) << "clock " << clock;
      ASSERT_EQ(out.rdata, UInt<32>(wanted.data)) << "clock " << clock;
      wanted.waits = false;
      ++reads;
    }
    before = out;
    was = in;
    if (out.awready && in.awvalid && in.wvalid) {
      ASSERT_TRUE(out.wready);
      const bool okay = model.write(int(in.awaddr.raw()) & ~3, std::uint32_t(in.wdata.raw()),
                                    std::uint32_t(byte_mask(in.wstrb).raw()));
      written = {.waits = true, .okay = okay};
      in.awvalid = in.wvalid = false;
    }
    if (out.arready && in.arvalid) {
      const auto data = model.read(int(in.araddr.raw()) & ~3);
      wanted = {.waits = true, .okay = data.has_value(), .data = data.value_or(0)};
      in.arvalid = false;
    }
  }
  EXPECT_GT(writes, clocks / 20);
  EXPECT_GT(reads, clocks / 20);
}

TEST(SixStepAxi, RandomTrafficGetsTheAnswersOfTheTable) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) random_traffic(50'000, seed);
}

TEST(SixStepAxi, ADroppedAnswerIsNoticed) {
  testing::TestPartResultArray results;
  {
    testing::ScopedFakeTestPartResultReporter reporter(
        testing::ScopedFakeTestPartResultReporter::INTERCEPT_ONLY_CURRENT_THREAD, &results);
    random_traffic(2000, 1, 1000);
  }
  EXPECT_GT(results.size(), 0);
}

TEST(SixStepAxi, TheHostTurnsTheBridgeOnAndOff) {
  Bench bench;
  EXPECT_FALSE(bench.gates_move());
  bench.start();
  EXPECT_TRUE(bench.gates_move());
  EXPECT_FALSE(bench.read(kStatus) & 1u << field("STATUS", "stopped").lsb);
  bench.write(kControl, 1);
  bench.wait(10);
  EXPECT_FALSE(bench.gates_move());
}

TEST(SixStepAxi, TheBridgesWordsAreRefusedWhileItRuns) {
  Bench bench;
  bench.start();
  bench.wait(100);
  EXPECT_FALSE(bench.write(kPwm, 1000));
  EXPECT_EQ(bench.read(kPwm) & 0x3fff, 200u);
  bench.write(kControl, 1);
  bench.wait(10);
  EXPECT_TRUE(bench.write(kPwm, 1u << 24 | 1000));
}

TEST(SixStepAxi, AFaultPinIsAnInterruptAndAFaultUntilCleared) {
  Bench bench;
  bench.write(address_of(index_of("INTERRUPT_ENABLE")), 1);
  bench.start();
  bench.wait(1000);
  bench.pins.fault = true;
  bench.wait(3);
  bench.clock({});
  EXPECT_FALSE(bench.any_gate());
  bench.pins.fault = false;
  bench.wait(5);
  EXPECT_TRUE(bench.out.interrupt && bench.out.fault);
  EXPECT_EQ(bench.read(kFault), 0x11u) << "fault pin";
  bench.write(kFault, 1);
  EXPECT_EQ(bench.read(kFault), 0x11u) << "run is still up";
  bench.write(kControl, 1);
  bench.write(kFault, 1);
  EXPECT_EQ(bench.read(kFault), 0x10u);
  EXPECT_FALSE(bench.out.fault);
}

TEST(SixStepAxi, AHostThatFallsSilentTurnsTheBridgeOff) {
  Bench bench;
  bench.write(kLock, kLockKey);
  EXPECT_TRUE(bench.write(address_of(index_of("WATCHDOG")), 10));
  bench.start();
  for (int beat = 0; beat < 20; ++beat) {
    EXPECT_TRUE(bench.gates_move(1000)) << "5 ticks";
    bench.write(address_of(index_of("HEARTBEAT")), 1);
  }
  bench.wait(2300);  // 11 ticks, and a tick until the first
  EXPECT_FALSE(bench.gates_move());
  EXPECT_EQ(bench.read(kFault) & 2, 2u);
}

// Why a second generator may tell the drive's boundaries.
TEST(SixStepAxi, PeriodsDoNotDependOnTheirPulses) {
  std::mt19937_64 random(1);
  PwmGenerator with, without;
  PwmGenerator::In in;
  for (int clock = 0; clock < 200'000; ++clock) {
    if (random() % 64 == 0) {
      in = {.on_clocks = int(random() % 50), .period = int(random() % 40),
            .minimum = int(random() % 10), .centred = random() % 2 == 0,
            .tick_periods = int(random() % 4)};
    }
    const auto a = with.tick(in);
    const auto b = without.tick({.period = in.period, .tick_periods = in.tick_periods});
    ASSERT_EQ(a.start, b.start) << clock;
    ASSERT_EQ(a.tick, b.tick) << clock;
  }
}

}  // namespace
}  // namespace steplock
