// What a host of SPI sees, of any drive: random frames, some of them cut, against a model of the map made of its
// table; and the C driver over it, which turns a bridge on and off, clears a fault and falls silent.
//
//     Top, Map    SixStepSpi, SixStep, or SinusoidalSpi, Sinusoidal
#pragma once

#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "rtl/host/steplock_spi.h"
#include "tests/hls/map_model.hpp"
#include "tests/hls/spi_host.hpp"

namespace steplock {

// `lie`: the answer that is told wrong, so that the caller sees the test fail.
template <class Top, class Map>
void random_frames(int frames, std::uint64_t seed, int lie = -1) {
  std::mt19937_64 random(seed);
  const auto chance = [&](int percent) { return int(random() % 100) < percent; };
  Top top;
  const auto line = [&](const Spi::Pins& pins) {
    typename Top::In in;
    in.clock_khz = kClockKhz;
    in.spi = pins;
    return top.tick(in).spi.miso;
  };
  MapModel<Map> model;
  line({});
  int errors = 0;
  for (int i = 0; i < frames; ++i) {
    const int address = chance(10) ? int(random() % 4096) : chance(20) ? kLock : int(random() % 64) * 4;
    const int home = address & ~3;
    const double half = 4 + 0.01 * double(random() % 300);
    std::uint32_t data = chance(30) ? kLockKey : std::uint32_t(random());
    // Run stays low and no watchdog expires: this is the traffic of an idle drive.
    if (runs(home)) data &= ~2U;
    const bool write = chance(50) && !Behind<Map>::expires(home);
    if (chance(20)) {
      spi_frame(line, half, address | (write ? 0x8000 : 0), data, int(random() % 48));
      continue;
    }
    SpiAnswer answer = write ? spi_write(line, half, address, data) : spi_read(line, half, address);
    if (i >= lie && lie >= 0) answer.status ^= 4, lie = -1;
    if (write) {
      const bool okay = model.write(home, data, ~0U);
      ASSERT_EQ(answer.status, okay ? 0x5a : 0x5e) << "frame " << i << " to " << address;
    } else {
      const auto word = model.read(home);
      ASSERT_EQ(answer.status, word ? 0x5a : 0x5e) << "frame " << i << " from " << address;
      ASSERT_EQ(answer.data, word.value_or(0)) << "frame " << i << " from " << address;
    }
    errors += answer.status == 0x5e;
  }
  EXPECT_GT(errors, frames / 20);
}

template <class Top, class Map>
void a_wrong_status_is_noticed() {
  testing::TestPartResultArray results;
  {
    testing::ScopedFakeTestPartResultReporter reporter(
        testing::ScopedFakeTestPartResultReporter::INTERCEPT_ONLY_CURRENT_THREAD, &results);
    random_frames<Top, Map>(200, 1, 100);
  }
  EXPECT_GT(results.size(), 0);
}

// A drive, its pins and a processor's SPI port.
template <class Top, class Map>
class SpiBench {
 public:
  using Drive = Behind<Map>;

  SpiBench() { clock({}); }

  bool gates_move(int clocks = Drive::kMoves) {
    bool moved = false;
    for (int i = 0; i < clocks; ++i) {
      clock({});
      moved = moved || !(out.gates == Gates{});
    }
    return moved;
  }
  steplock_bus bus() { return steplock_over_spi(&spi_); }
  steplock_result init() {
    const steplock_bus over = bus();
    std::vector<steplock_word> config;
    for (const auto& [address, value] : Drive::config()) config.push_back({std::uint32_t(address), value});
    return steplock_init(&over, config.data(), config.size());
  }

  typename Top::In in;
  typename Top::Out out;
  bool fault_pin = false;

 private:
  bool clock(const Spi::Pins& pins) {
    in.spi = pins;
    Drive::pins(in, out, fault_pin);
    out = top_.tick(in);
    EXPECT_EQ(out.spi.selected, selects_[1]);
    selects_ = {!pins.cs_n, selects_[0]};
    return out.spi.miso;
  }
  // Bytes to bits.
  static int transfer(void* bench, const std::uint8_t* out, std::uint8_t* in, std::size_t bytes) {
    std::uint64_t frame = 0;
    for (std::size_t i = 0; i < bytes; ++i) frame = frame << 8 | out[i];
    const auto line = [&](const Spi::Pins& pins) { return static_cast<SpiBench*>(bench)->clock(pins); };
    const auto back = spi_frame(line, 4.2, int(frame >> 40), std::uint32_t(frame >> 8));
    for (std::size_t i = 0; i < bytes; ++i) in[i] = std::uint8_t(back >> (8 * (bytes - 1 - i)));
    return 0;
  }

  Top top_;
  std::array<bool, 2> selects_{};  // the host, in the clock before and in the one before that
  steplock_spi spi_ = {transfer, this};
};

template <class Top, class Map>
void the_c_driver_turns_the_bridge_on_and_off_and_clears_a_fault() {
  SpiBench<Top, Map> b;
  const steplock_bus bus = b.bus();
  ASSERT_EQ(b.init(), STEPLOCK_OK);
  EXPECT_EQ(steplock_enable_interrupts(&bus, STEPLOCK_INTERRUPT_FAULT_MASK), STEPLOCK_OK);
  EXPECT_FALSE(b.gates_move());
  ASSERT_EQ(steplock_start(&bus, 0), STEPLOCK_OK);
  EXPECT_TRUE(b.gates_move());
  EXPECT_EQ(b.init(), STEPLOCK_NOT_STOPPED);
  EXPECT_EQ(bus.write(bus.context, kPwm, 1000), 1) << "refused while it runs";

  b.fault_pin = true;
  b.gates_move(3);
  EXPECT_FALSE(b.gates_move(1000));
  EXPECT_EQ(steplock_clear_fault(&bus), STEPLOCK_FAULT_LATCHED) << "the pin is still up";
  b.fault_pin = false;
  b.gates_move(5);
  EXPECT_TRUE(b.out.interrupt && b.out.fault);
  EXPECT_EQ(steplock_clear_fault(&bus), STEPLOCK_OK);
  EXPECT_FALSE(b.out.fault);
  std::uint32_t value = 0;
  EXPECT_EQ(steplock_take_interrupts(&bus, &value), STEPLOCK_OK);
  EXPECT_EQ(value & STEPLOCK_INTERRUPT_FAULT_MASK, STEPLOCK_INTERRUPT_FAULT_MASK);
  EXPECT_FALSE(b.out.interrupt);
  EXPECT_EQ(bus.read(bus.context, 0x800, &value), 1) << "a hole";
}

template <class Top, class Map>
void a_c_driver_that_falls_silent_turns_the_bridge_off() {
  constexpr int tick = Behind<Map>::kTick;
  SpiBench<Top, Map> b;
  const steplock_bus bus = b.bus();
  ASSERT_EQ(b.init(), STEPLOCK_OK);
  ASSERT_EQ(steplock_set_watchdog(&bus, 20), STEPLOCK_OK);
  ASSERT_EQ(steplock_start(&bus, 0), STEPLOCK_OK);
  for (int beat = 0; beat < 10; ++beat) {
    EXPECT_EQ(steplock_heartbeat(&bus), STEPLOCK_OK);
    EXPECT_TRUE(b.gates_move(10 * tick));
  }
  b.gates_move(11 * tick);  // and a tick until the first
  EXPECT_FALSE(b.gates_move());
  steplock_status status;
  ASSERT_EQ(steplock_get_status(&bus, &status), STEPLOCK_OK);
  EXPECT_TRUE(status.watchdog);
}

}  // namespace steplock
