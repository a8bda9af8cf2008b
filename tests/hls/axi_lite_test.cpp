#include "hls/bus/axi_lite.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <string>
#include <vector>

namespace steplock {
namespace {

TEST(AxiLite, NeitherAddressNorDataIsTakenAlone) {
  for (const bool address : {false, true}) {
    AxiLite dut;
    for (int clock = 0; clock < 20; ++clock) {
      const auto out = dut.tick({.awvalid = address, .wvalid = !address});
      EXPECT_FALSE(out.awready || out.wready || out.bvalid || out.request.write);
    }
  }
}

TEST(AxiLite, AWriteIsAskedForOnceWithItsAddressDataAndStrobes) {
  AxiLite dut;
  const AxiLite::In in{.awvalid = true, .awaddr = 0x0a4, .wvalid = true, .wdata = 0x12345678,
                       .wstrb = 5};
  EXPECT_FALSE(dut.tick(in).request.write);
  const auto taken = dut.tick(in);
  EXPECT_TRUE(taken.awready && taken.wready);
  EXPECT_EQ(taken.request,
            (BusRequest{.write = true, .index = 0x29, .data = 0x12345678, .strobes = 5}));
  for (int clock = 0; clock < 5; ++clock) {
    const auto out = dut.tick({});
    EXPECT_TRUE(out.bvalid) << "waits for bready";
    EXPECT_FALSE(out.request.write || out.awready);
  }
  dut.tick({.bready = true});
  EXPECT_FALSE(dut.tick({}).bvalid);
}

TEST(AxiLite, AnUntakenWriteResponseDoesNotHoldUpReads) {
  AxiLite dut;
  const AxiLite::In write{.awvalid = true, .wvalid = true};
  dut.tick(write);
  dut.tick(write);
  int reads = 0;
  for (int clock = 0; clock < 30; ++clock) {
    const auto out = dut.tick({.arvalid = true, .rready = true});
    EXPECT_TRUE(out.bvalid);
    reads += out.request.read;
  }
  EXPECT_EQ(reads, 10);  // one per 3 clocks
}

TEST(AxiLite, ReadsAndWritesTakeTurns) {
  AxiLite dut;
  int reads = 0, writes = 0;
  for (int clock = 0; clock < 3000; ++clock) {
    const auto out = dut.tick(
        {.awvalid = true, .wvalid = true, .bready = true, .arvalid = true, .rready = true});
    reads += out.request.read;
    writes += out.request.write;
    EXPECT_FALSE(out.request.read && out.request.write);
  }
  EXPECT_EQ(reads, writes);
  EXPECT_EQ(reads, 1000);
}

// Of two that come at once the one goes first whose kind was not the last.
TEST(AxiLite, AfterAWriteTheReadGoesFirstAndAfterAReadTheWrite) {
  AxiLite dut;
  // What is asked for, in the order in which it is taken.
  const auto taken = [&](bool write, bool read) {
    std::string order;
    for (int clock = 0; clock < 12; ++clock) {
      const auto out = dut.tick({.awvalid = write, .wvalid = write, .bready = true, .arvalid = read, .rready = true});
      if (out.request.write) order += 'w', write = false;
      if (out.request.read) order += 'r', read = false;
    }
    return order;
  };
  for (int round = 0; round < 3; ++round) {
    EXPECT_EQ(taken(true, false), "w");
    EXPECT_EQ(taken(true, true), "rw");
    EXPECT_EQ(taken(true, true), "rw") << "the write was the last again";
    EXPECT_EQ(taken(false, true), "r");
    EXPECT_EQ(taken(true, true), "wr");
  }
}

// A host that keeps its valid up until ready, as the protocol asks, gets one answer for each
// transfer, never more nor less, however it delays anything.
RC_GTEST_PROP(AxiLite, EveryTransferHasOneAnswer, ()) {
  const auto pins = *rc::gen::container<std::vector<std::uint8_t>>(
      2000, rc::gen::inRange<std::uint8_t>(0, 32));
  AxiLite dut;
  AxiLite::In in;
  int writes = 0, answered = 0, reads = 0, read_answers = 0;
  for (const int p : pins) {
    in.awvalid = in.awvalid || p % 2 == 1;
    in.wvalid = in.wvalid || p / 2 % 2 == 1;
    in.arvalid = in.arvalid || p / 4 % 2 == 1;
    in.bready = p / 8 % 2 == 1;
    in.rready = p / 16 % 2 == 1;
    const auto out = dut.tick(in);
    RC_ASSERT(out.awready == out.wready);
    RC_ASSERT(out.request.write == (out.awready && in.awvalid));
    RC_ASSERT(out.request.read == (out.arready && in.arvalid));
    RC_ASSERT(out.bvalid == (writes > answered));
    RC_ASSERT(out.rvalid == (reads > read_answers));
    answered += out.bvalid && in.bready;
    read_answers += out.rvalid && in.rready;
    writes += out.request.write;
    reads += out.request.read;
    if (out.awready) in.awvalid = in.wvalid = false;
    if (out.arready) in.arvalid = false;
  }
}

}  // namespace
}  // namespace steplock
