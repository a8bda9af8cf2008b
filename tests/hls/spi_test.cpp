// Frames bit by bit, at any phase and ratio of sclk to the clock; frames that are cut; lines that stand still.
#include "hls/bus/spi.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstdint>
#include <random>
#include <vector>

#include "tests/hls/spi_host.hpp"

namespace steplock {
namespace {

// The slave and registers that answer in the clock after the request: each word is its index times 3.
struct Bench {
  Spi::Out clock(const Spi::Pins& pins) {
    const auto out = dut.tick({.pins = pins, .reply = {.bit = bit, .error = error}});
    bit = (data >> int(out.place.raw()) & 1) != 0;
    error = out.writing ? write_error : read_error;
    const BusRequest& r = out.request;
    if (r.read) data = ones ^ 3 * std::uint32_t(r.index.raw()), read_error = r.index == 0x3ff;
    if (r.write) write_error = r.index == 0x3ff;
    if (r.read || r.write) requests.push_back(r);
    return out;
  }
  bool operator()(const Spi::Pins& pins) { return clock(pins).miso; }

  Spi dut;
  std::vector<BusRequest> requests;
  std::uint32_t data = 0, ones = 0;
  bool bit = false, error = false, read_error = false, write_error = false;
};

TEST(Spi, AWriteIsAskedForOnceWithItsAddressAndData) {
  Bench b;
  const auto answer = spi_write(b, 4, 0x0a4, 0x12345678);
  ASSERT_EQ(b.requests.size(), 1u);
  EXPECT_EQ(b.requests[0],
            (BusRequest{.write = true, .index = 0x29, .data = 0x12345678, .strobes = 15}));
  EXPECT_EQ(answer.status, 0x5a);
}

TEST(Spi, AReadShowsTheAnswerAndAHoleItsMark) {
  Bench b;
  for (int index = 0; index < 1024; index += 11) {
    const auto answer = spi_read(b, 4, 4 * index);
    EXPECT_EQ(answer.status, index == 1023 ? 0x5e : 0x5a);
    EXPECT_EQ(answer.data, 3u * unsigned(index));
  }
  EXPECT_EQ(spi_read(b, 4, 0xffc).status, 0x5e);
  EXPECT_EQ(spi_write(b, 4, 0xffc, 0).status, 0x5e);
  EXPECT_EQ(spi_write(b, 4, 0x000, 0).status, 0x5a);
}

// The first bit of the data is one of them.
TEST(Spi, AReadShowsEveryBitOfTheAnswer) {
  Bench b;
  b.ones = ~0u;
  for (const int index : {0, 1, 0x155, 0x2aa}) EXPECT_EQ(spi_read(b, 4, 4 * index).data, ~(3u * unsigned(index)));
}

// Mode 0: the host may take a bit as long as sclk is high.
TEST(Spi, MisoMovesWhileSclkIsLowAndIsLowOutsideOfStatusAndData) {
  struct Watched {
    bool operator()(const Spi::Pins& pins) {
      const bool now = bench.clock(pins).miso;
      if (now != miso && !pins.cs_n) high_moves += pins.sclk;
      if (pins.sclk && !was_high) ++bit;
      if (now && (bit <= 16 || bit > 56)) ++stray;
      miso = now, was_high = pins.sclk;
      return now;
    }
    Bench bench;
    bool miso = false, was_high = false;
    int bit = 0, high_moves = 0, stray = 0;
  };
  for (const int head : {0x0554, 0x8554}) {
    Watched w;
    w.bench.ones = ~0u;
    spi_frame(w, 9, head, 0xffffffff, 56 + 64);
    EXPECT_EQ(w.high_moves, 0);
    EXPECT_EQ(w.stray, 0);
    EXPECT_EQ(w.bench.requests.size(), 1u);
  }
}

// Phases are times of the host's own clock: sclk's halves are 4 to 12.99 clocks.
RC_GTEST_PROP(Spi, AnySlowEnoughClockAtAnyPhaseIsRead, ()) {
  const double half = 0.01 * *rc::gen::inRange(400, 1300);
  const int address = 4 * *rc::gen::inRange(0, 1023);
  const auto data = *rc::gen::arbitrary<std::uint32_t>();
  Bench b;
  b.clock({});
  RC_ASSERT(spi_write(b, half, address, data).status == 0x5a);
  RC_ASSERT(b.requests.size() == 1u && b.requests[0].data == data && b.requests[0].write);
  const auto answer = spi_read(b, half, address);
  RC_ASSERT(answer.status == 0x5a && answer.data == 3u * unsigned(address / 4));
}

TEST(Spi, ATooFastClockIsNoticedByTheHost) {
  Bench b;
  int wrong = 0;
  for (int index = 1; index < 100; ++index) {
    const auto answer = spi_read(b, 1.7, 4 * index);
    wrong += answer.status != 0x5a || answer.data != 3u * unsigned(index);
  }
  EXPECT_GT(wrong, 90);
}

TEST(Spi, AFrameThatIsCutBeforeItsLastDataBitWritesNothing) {
  for (int bits = 0; bits < 48; ++bits) {
    Bench b;
    spi_frame(b, 4, 0x80a4, 0xdeadbeef, bits);
    EXPECT_TRUE(b.requests.empty()) << bits;
    EXPECT_EQ(spi_write(b, 4, 0x10, 7).status, 0x5a);
    ASSERT_EQ(b.requests.size(), 1u) << bits;
    EXPECT_EQ(b.requests[0].index, 4);
    EXPECT_EQ(b.requests[0].data, 7);
  }
}

TEST(Spi, WhatComesAfterAFrameIsIgnored) {
  for (const int head : {0x80a4, 0x00a4}) {
    Bench b;
    spi_frame(b, 4, head, 0x55555555, 56 + 200);
    EXPECT_EQ(b.requests.size(), 1u);
  }
}

TEST(Spi, NothingIsAskedWithoutSelect) {
  std::mt19937 any(1);
  Bench b;
  for (int clock = 0; clock < 100'000; ++clock) {
    const auto out = b.clock({.cs_n = true, .sclk = any() % 2 == 0, .mosi = any() % 2 == 0});
    ASSERT_FALSE(out.selected || out.miso);
  }
  EXPECT_TRUE(b.requests.empty());
}

}  // namespace
}  // namespace steplock
