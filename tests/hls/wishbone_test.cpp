#include "hls/bus/wishbone.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <vector>

namespace steplock {
namespace {

TEST(Wishbone, AWriteIsAskedForOnceWithItsAddressDataAndBytes) {
  Wishbone dut;
  const Wishbone::In in{.cyc = true, .stb = true, .we = true, .adr = 0x0a4, .dat = 0x12345678, .sel = 5};
  const auto first = dut.tick(in);
  EXPECT_TRUE(!first.ack && first.stall);
  EXPECT_EQ(first.request,
            (BusRequest{.write = true, .index = 0x29, .data = 0x12345678, .strobes = 5}));
  const auto second = dut.tick(in);
  EXPECT_TRUE(second.ack && !second.stall);
  EXPECT_FALSE(second.request.write || second.request.read);
  EXPECT_FALSE(dut.tick({}).ack);
}

TEST(Wishbone, NothingIsAskedWithoutCycAndStb) {
  for (const bool cyc : {false, true}) {
    Wishbone dut;
    for (int clock = 0; clock < 20; ++clock) {
      const auto out = dut.tick({.cyc = cyc, .stb = !cyc, .we = clock % 2 == 0});
      EXPECT_FALSE(out.ack || out.request.write || out.request.read);
    }
  }
}

TEST(Wishbone, CyclesFollowEachOtherEveryThreeClocks) {
  Wishbone dut;
  int asked = 0, answered = 0;
  for (int clock = 0; clock < 300; ++clock) {
    const auto out = dut.tick({.cyc = true, .stb = true, .we = clock / 3 % 2 == 0});
    asked += out.request.write + out.request.read;
    answered += out.ack;
  }
  EXPECT_EQ(asked, 100);
  EXPECT_EQ(answered, 100);
}

struct Registers {
  bool write_error = false, read_error = false;
  UInt<32> data = 0;
};

// One of both, and neither without an answer of the bus; the error is that of the transfer's own direction.
TEST(Wishbone, AnAnswerIsAnAckOrAnErr) {
  for (int bits = 0; bits < 16; ++bits) {
    const bool acks = (bits & 1) != 0, we = (bits & 2) != 0;
    const Registers drive{.write_error = (bits & 4) != 0, .read_error = (bits & 8) != 0, .data = 0x12345678};
    const WishboneAnswers out = wishbone_answers({.ack = acks, .stall = we, .request = {}}, we, drive);
    const bool error = we ? drive.write_error : drive.read_error;
    EXPECT_EQ(out.ack, acks && !error) << bits;
    EXPECT_EQ(out.err, acks && error) << bits;
    EXPECT_EQ(out.stall, we);
    EXPECT_EQ(out.dat, drive.data);
  }
}

// Standard hosts hold until ack; pipelined ones go on when stall is low: both get one answer for each
// transfer, however they pause.
RC_GTEST_PROP(Wishbone, EveryTransferHasOneAnswer, ()) {
  const auto pauses = *rc::gen::container<std::vector<std::uint8_t>>(
      500, rc::gen::inRange<std::uint8_t>(0, 3));
  for (const bool pipelined : {false, true}) {
    Wishbone dut;
    int answers = 0;
    for (std::size_t k = 0; k < pauses.size(); ++k) {
      for (int i = 0; i < pauses[k]; ++i) {
        const auto out = dut.tick({.cyc = pipelined, .adr = 4});
        RC_ASSERT(!out.ack && !out.request.read && !out.request.write);
      }
      const Wishbone::In in{.cyc = true, .stb = true, .we = k % 3 == 0, .adr = UInt<12>::of(4 * int(k))};
      bool over = false;
      int requests = 0;
      for (int clock = 0; !over; ++clock) {
        RC_ASSERT(clock < 3);
        const auto out = dut.tick(in);
        answers += out.ack;
        requests += out.request.read + out.request.write;
        over = pipelined ? !out.stall : out.ack;
      }
      RC_ASSERT(requests == 1);
    }
    RC_ASSERT(answers == int(pauses.size()));
  }
}

}  // namespace
}  // namespace steplock
