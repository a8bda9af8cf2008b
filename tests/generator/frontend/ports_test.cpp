// The printed ..._ports.hpp headers, against structs of the types that Verilator would give.

#include <gtest/gtest.h>

#include <array>
#include <set>
#include <string>

#include "tests/generator/frontend/blocks/arrays.hpp"
#include "tests/generator/frontend/blocks/control.hpp"
#include "tests/generator/frontend/blocks/numbers.hpp"
#include "tests/generator/ports/history_ports.hpp"
#include "tests/generator/ports/plain_ports.hpp"
#include "tests/generator/ports/state_machine_ports.hpp"
#include "tests/generator/ports/wide_ports.hpp"

namespace {

using namespace steplock;

template <std::size_t N>
struct VlWide {  // as Verilator's: words of 32 bits, the lowest first
  std::uint32_t words[N] = {};
  std::uint32_t& operator[](std::size_t i) { return words[i]; }
  const std::uint32_t& operator[](std::size_t i) const { return words[i]; }
};

struct WideRtl {
  std::uint64_t a_i = 0, b_i = 0, c_i = 0, d_i = 0;
  VlWide<4> e_i;
  VlWide<3> sum_o;
  VlWide<4> product_o, square_o, xored_o, slow_o;
  std::uint64_t odd_o = 0;
  std::uint8_t less_o = 0;
};

TEST(Ports, SignedNumbersArriveAsTheLowerBitsOfTwosComplement) {
  struct {
    std::uint8_t a_i = 0, b_i = 0;
    std::uint16_t c_i = 0;
    std::uint32_t d_i = 0;
    std::uint64_t e_i = 0;
    std::uint8_t f0_i = 0, f1_i = 0;
  } rtl;
  const test::Plain::In in{.a = -2, .b = 200, .c = -300, .d = 7, .e = -1, .f0 = true};
  ports::plain::drive_ports(rtl, in);
  EXPECT_EQ(rtl.a_i, 0xfe);
  EXPECT_EQ(rtl.b_i, 200);
  EXPECT_EQ(rtl.c_i, 0xfed4);
  EXPECT_EQ(rtl.d_i, 7U);
  EXPECT_EQ(rtl.e_i, ~std::uint64_t{0});
  EXPECT_EQ(rtl.f0_i, 1);
  EXPECT_EQ(rtl.f1_i, 0);
}

TEST(Ports, WideNumbersFillWordsFromBelow) {
  WideRtl rtl;
  test::Wide::In in;
  in.e = UInt<128>(1) << 100;
  ports::wide::drive_ports(rtl, in);
  EXPECT_EQ(rtl.e_i[0], 0U);
  EXPECT_EQ(rtl.e_i[3], 16U);
}

TEST(Ports, TheFirstPortThatDiffersIsNamed) {
  WideRtl rtl;
  test::Wide::Out out;
  EXPECT_EQ(ports::wide::differs(rtl, out), nullptr);
  rtl.less_o = 1;
  EXPECT_STREQ(ports::wide::differs(rtl, out), "less_o");
  rtl.sum_o[2] = 1;  // bit 64 of a number of 65
  EXPECT_STREQ(ports::wide::differs(rtl, out), "sum_o");
  out.sum = Int<65>::min();
  out.less = true;
  EXPECT_EQ(ports::wide::differs(rtl, out), nullptr);
}

struct Counting {
  ports::Word bits(int width) { return ports::masked(next_++, width); }
  ports::Word next_ = 0;
};

TEST(Ports, RandomInputsReachEveryMemberAndStayWithinEnumerators) {
  Counting stimulus;
  test::History::In history;
  ports::history::randomise(history, stimulus);
  EXPECT_EQ(history.write, UInt<3>(1));
  EXPECT_EQ(history.gains[2], UInt<4>(9));

  std::set<test::Phase6> seen;
  for (int i = 0; i < 64; ++i) {
    test::StateMachine::In in;
    ports::state_machine::randomise(in, stimulus);
    seen.insert(in.wish);
  }
  for (const auto phase : seen) {
    EXPECT_TRUE(phase <= test::Phase6::kRun || phase == test::Phase6::kBrake);
  }
  EXPECT_GT(seen.size(), 2U);
}

}  // namespace
