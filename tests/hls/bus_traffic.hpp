// Random traffic on a bus that has one transfer under way at a time: every answer is the map's, it comes once
// and in time, and nothing comes unasked.
//
//     Bus    struct { using Top, Map; static void idle(Top::In&), show(Top::In&, const Transfer&, int phase);
//                     static Answer answer(const Top::Out&); static constexpr int kPhases, kClocks; }
//
// `phase` counts the clocks of a transfer up to kPhases - 1 and stays there until the answer.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>

#include "hls/bus/bus.hpp"
#include "tests/hls/map_model.hpp"

namespace steplock {

struct Transfer {
  bool write = false;
  int address = 0;
  std::uint32_t data = 0;
  int strobes = 15;
};

struct Answer {
  bool done = false, error = false;
  std::uint32_t data = 0;
};

// One transfer, with `pins()` before every clock; `clocks` says how many it took.
template <class Bus, class Pins>
Answer transfer(typename Bus::Top& top, typename Bus::Top::In& in, typename Bus::Top::Out& out, const Transfer& t,
                const Pins& pins, int* clocks = nullptr) {
  Answer answer;
  int clock = 0;
  for (; !answer.done && clock < 100; ++clock) {
    pins();
    Bus::show(in, t, std::min(clock, Bus::kPhases - 1));
    out = top.tick(in);
    answer = Bus::answer(out);
  }
  EXPECT_TRUE(answer.done);
  Bus::idle(in);
  if (clocks != nullptr) *clocks = clock;
  return answer;
}

// `lie`: the answer that is told wrong, so that the caller sees the test fail.
template <class Bus>
void random_bus_traffic(int transfers, std::uint64_t seed, int lie = -1) {
  std::mt19937_64 random(seed);
  const auto chance = [&](int percent) { return int(random() % 100) < percent; };
  typename Bus::Top top;
  typename Bus::Top::In in;
  in.clock_khz = kClockKhz;
  typename Bus::Top::Out out;
  MapModel<typename Bus::Map> model;
  int errors = 0;
  for (int i = 0; i < transfers; ++i) {
    for (int idle = int(random() % 4); idle > 0; --idle) {
      ASSERT_FALSE(Bus::answer(top.tick(in)).done) << "nobody asked";
    }
    Transfer t{.write = chance(50),
               .address = chance(10) ? int(random() % 4096) : chance(20) ? kLock : int(random() % 64) * 4,
               .data = chance(30) ? kLockKey : std::uint32_t(random()),
               .strobes = chance(60) ? 15 : int(random() % 16)};
    const int home = t.address & ~3;
    // Run stays low: this is the traffic of an idle drive.
    if (runs(home)) t.data &= ~2U;
    if (Behind<typename Bus::Map>::expires(home)) t.write = false;
    int clocks = 0;
    Answer answer = transfer<Bus>(top, in, out, t, [] {}, &clocks);
    if (i == lie) answer.error = !answer.error;
    ASSERT_LE(clocks, Bus::kClocks) << "transfer " << i;
    if (t.write) {
      const bool okay = model.write(home, t.data, std::uint32_t(byte_mask(t.strobes).raw()));
      ASSERT_EQ(answer.error, !okay) << "transfer " << i << " to " << t.address;
    } else {
      const auto data = model.read(home);
      ASSERT_EQ(answer.error, !data.has_value()) << "transfer " << i << " from " << t.address;
      ASSERT_EQ(answer.data, data.value_or(0)) << "transfer " << i << " from " << t.address;
    }
    errors += answer.error;
  }
  EXPECT_GT(errors, transfers / 20);
}

// The host turns the bridge on and off, and a fault pin needs its one.
template <class Bus>
void start_fault_and_stop() {
  using Drive = Behind<typename Bus::Map>;
  typename Bus::Top top;
  typename Bus::Top::In in;
  typename Bus::Top::Out out;
  bool fault = false;
  const auto pins = [&] { Drive::pins(in, out, fault); };
  const auto write = [&](int address, std::uint32_t data) {
    return !transfer<Bus>(top, in, out, {.write = true, .address = address, .data = data}, pins).error;
  };
  const auto read = [&](int address) { return transfer<Bus>(top, in, out, {.address = address}, pins).data; };
  const auto gates_move = [&](int clocks) {
    bool moved = false;
    for (int i = 0; i < clocks; ++i) {
      pins();
      out = top.tick(in);
      moved = moved || !(out.gates == Gates{});
    }
    return moved;
  };
  for (const auto& [address, value] : Drive::config()) EXPECT_TRUE(write(address, value));
  EXPECT_TRUE(write(address_of(index_of("INTERRUPT_ENABLE")), 1));
  EXPECT_FALSE(gates_move(Drive::kMoves));
  EXPECT_TRUE(write(kControl, 3));
  EXPECT_TRUE(gates_move(Drive::kMoves));
  EXPECT_FALSE(write(kPwm, 1000)) << "it runs";

  fault = true;
  gates_move(3);
  EXPECT_FALSE(gates_move(1000));
  fault = false;
  gates_move(5);
  EXPECT_TRUE(out.interrupt && out.fault);
  EXPECT_EQ(read(kFault), 0x11u) << "fault pin";
  EXPECT_TRUE(write(kControl, 1));
  EXPECT_TRUE(write(kFault, 1));
  EXPECT_EQ(read(kFault), 0x10u);
  gates_move(1);
  EXPECT_FALSE(out.fault);
}

}  // namespace steplock
