#include "hls/bus/apb.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <vector>

namespace steplock {
namespace {

TEST(Apb, AWriteIsAskedForOnceWithItsAddressDataAndBytes) {
  Apb dut;
  Apb::In in{.psel = true, .pwrite = true, .paddr = 0x0a4, .pwdata = 0x12345678, .pstrb = 5};
  const auto setup = dut.tick(in);
  EXPECT_FALSE(setup.pready || setup.request.write || setup.request.read);
  in.penable = true;
  const auto first = dut.tick(in);
  EXPECT_FALSE(first.pready);
  EXPECT_EQ(first.request,
            (BusRequest{.write = true, .index = 0x29, .data = 0x12345678, .strobes = 5}));
  const auto second = dut.tick(in);
  EXPECT_TRUE(second.pready);
  EXPECT_FALSE(second.request.write || second.request.read);
  EXPECT_FALSE(dut.tick({}).pready);
}

TEST(Apb, NothingIsAskedWithoutPselAndPenable) {
  for (const bool psel : {false, true}) {
    Apb dut;
    for (int clock = 0; clock < 20; ++clock) {
      const auto out = dut.tick({.psel = psel, .penable = !psel, .pwrite = clock % 2 == 0});
      EXPECT_FALSE(out.pready || out.request.write || out.request.read);
    }
  }
}

struct Registers {
  bool write_error = false, read_error = false;
  UInt<32> data = 0;
};

TEST(Apb, AnErrorIsToldWithTheAnswerAlone) {
  for (int bits = 0; bits < 16; ++bits) {
    const bool ready = (bits & 1) != 0, write = (bits & 2) != 0;
    const Registers drive{.write_error = (bits & 4) != 0, .read_error = (bits & 8) != 0, .data = 0x12345678};
    const ApbAnswers out = apb_answers({.pready = ready, .request = {}}, write, drive);
    EXPECT_EQ(out.pready, ready) << bits;
    EXPECT_EQ(out.pslverr, ready && (write ? drive.write_error : drive.read_error)) << bits;
    EXPECT_EQ(out.prdata, drive.data);
  }
}

// A host that keeps psel between transfers, and one that does not, get one answer for each.
RC_GTEST_PROP(Apb, EveryTransferHasOneAnswer, ()) {
  const auto pauses = *rc::gen::container<std::vector<std::uint8_t>>(
      500, rc::gen::inRange<std::uint8_t>(0, 3));
  Apb dut;
  for (std::size_t k = 0; k < pauses.size(); ++k) {
    for (int i = 0; i < pauses[k]; ++i) RC_ASSERT(!dut.tick({}).pready);
    Apb::In in{.psel = true, .pwrite = k % 3 == 0, .paddr = UInt<12>::of(4 * int(k))};
    int requests = 0, answers = 0;
    for (int clock = 0; clock < 3; ++clock) {
      in.penable = clock > 0;
      const auto out = dut.tick(in);
      requests += out.request.read + out.request.write;
      answers += out.pready;
      RC_ASSERT(out.pready == (clock == 2));
    }
    RC_ASSERT(requests == 1 && answers == 1);
  }
}

}  // namespace
}  // namespace steplock
