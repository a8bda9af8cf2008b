// What a host of AXI4-Lite sees, of any drive: random traffic against a model of the map made of its table, and
// what a host does to a bridge.
//
//     Top, Map    SixStepAxi, SixStep, or SinusoidalAxi, Sinusoidal
#pragma once

#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

#include <functional>
#include <optional>
#include <random>

#include "testbench/bus/axi_master.hpp"
#include "tests/hls/map_model.hpp"

namespace steplock {

template <class Top, class Map>
struct AxiBench {
  using Drive = Behind<Map>;
  Top dut;
  typename Top::Out out;
  bool fault_pin = false;

  AxiAnswers clock(const AxiLite::In& axi) {
    typename Top::In in;
    in.axi = axi;
    Drive::pins(in, out, fault_pin);
    out = dut.tick(in);
    return out.axi;
  }
  void wait(int clocks) {
    for (int i = 0; i < clocks; ++i) clock({});
  }
  bool write(int address, std::uint32_t data) { return master_.write(address, data).okay; }
  std::uint32_t read(int address) { return master_.read(address).data; }
  bool any_gate() const { return !(out.gates == Gates{}); }
  void start() {
    for (const auto& [address, value] : Drive::config()) EXPECT_TRUE(write(address, value));
    write(kControl, 3);
  }
  bool gates_move(int clocks = Drive::kMoves) {
    bool moved = false;
    for (int i = 0; i < clocks; ++i) {
      clock({});
      moved = moved || any_gate();
    }
    return moved;
  }

 private:
  std::function<AxiAnswers(const AxiLite::In&)> step_ = [this](const AxiLite::In& axi) { return clock(axi); };
  AxiMaster<decltype(step_)> master_{step_};
};

// Channels begin and wait at random and independently; every answer is the one that the order of
// acceptance demands, and while it waits for its host it stands still.
template <class Top, class Map>
void random_axi_traffic(int clocks, std::uint64_t seed, std::optional<int> lie_at = {}) {
  std::mt19937_64 random(seed);
  const auto chance = [&](int percent) { return int(random() % 100) < percent; };
  const auto address = [&] {
    return chance(10) ? int(random() % 4096) : chance(20) ? kLock : int(random() % 64) * 4;
  };
  Top dut;
  MapModel<Map> model;
  AxiLite::In in;
  AxiAnswers before;
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
      if (Behind<Map>::expires(int(in.awaddr.raw()) & ~3)) in.awaddr = kLock;
    }
    if (!in.wvalid && chance(30)) {
      in.wvalid = true;
      in.wdata = chance(30) ? kLockKey : std::uint32_t(random());
      in.wstrb = chance(60) ? 15 : int(random() % 16);
    }
    // Run stays low: this is the traffic of an idle drive.
    if (runs(4 * int((in.awaddr >> 2).raw()))) in.wdata = in.wdata & ~UInt<32>(2);
    if (!in.arvalid && chance(30)) {
      in.arvalid = true;
      in.araddr = address();
    }
    in.bready = chance(40);
    in.rready = chance(40);
    typename Top::In pins;
    pins.clock_khz = kClockKhz;
    pins.axi = in;
    auto out = dut.tick(pins).axi;
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

template <class Top, class Map>
void a_dropped_answer_is_noticed() {
  testing::TestPartResultArray results;
  {
    testing::ScopedFakeTestPartResultReporter reporter(
        testing::ScopedFakeTestPartResultReporter::INTERCEPT_ONLY_CURRENT_THREAD, &results);
    random_axi_traffic<Top, Map>(2000, 1, 1000);
  }
  EXPECT_GT(results.size(), 0);
}

template <class Top, class Map>
void the_host_turns_the_bridge_on_and_off() {
  AxiBench<Top, Map> bench;
  EXPECT_FALSE(bench.gates_move());
  bench.start();
  EXPECT_TRUE(bench.gates_move());
  EXPECT_FALSE(bench.read(kStatus) & 1u << field("STATUS", "stopped").lsb);
  bench.write(kControl, 1);
  bench.wait(10);
  EXPECT_FALSE(bench.gates_move());
}

template <class Top, class Map>
void the_bridges_config_is_refused_while_it_runs() {
  constexpr std::uint32_t bits = mask_of(field<Map>("PWM", "period"));
  AxiBench<Top, Map> bench;
  bench.start();
  bench.wait(100);
  EXPECT_FALSE(bench.write(kPwm, 1000));
  EXPECT_EQ(bench.read(kPwm) & bits, std::uint32_t(Behind<Map>::kPeriod));
  bench.write(kControl, 1);
  bench.wait(10);
  EXPECT_TRUE(bench.write(kPwm, 1000));
  EXPECT_EQ(bench.read(kPwm) & bits, 1000u);
}

template <class Top, class Map>
void a_fault_pin_is_an_interrupt_and_a_fault_until_cleared() {
  AxiBench<Top, Map> bench;
  bench.write(address_of(index_of("INTERRUPT_ENABLE")), 1);
  bench.start();
  EXPECT_TRUE(bench.gates_move());
  bench.fault_pin = true;
  bench.wait(3);
  bench.clock({});
  EXPECT_FALSE(bench.any_gate());
  bench.fault_pin = false;
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

template <class Top, class Map>
void a_host_that_falls_silent_turns_the_bridge_off() {
  constexpr int tick = Behind<Map>::kTick;
  AxiBench<Top, Map> bench;
  bench.write(kLock, kLockKey);
  EXPECT_TRUE(bench.write(address_of(index_of("WATCHDOG")), 10));
  bench.start();
  for (int beat = 0; beat < 20; ++beat) {
    EXPECT_TRUE(bench.gates_move(std::max(5 * tick, Behind<Map>::kMoves / 2)) || beat == 0);
    bench.write(address_of(index_of("HEARTBEAT")), 1);
  }
  bench.wait(11 * tick + tick / 2);  // and a tick until the first
  EXPECT_FALSE(bench.gates_move());
  EXPECT_EQ(bench.read(kFault) & 2, 2u);
}

}  // namespace steplock
