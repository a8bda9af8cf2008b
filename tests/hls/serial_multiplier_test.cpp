#include "hls/numeric/serial_multiplier.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstdint>

namespace steplock {
namespace {

struct Result {
  std::int64_t product;
  int clocks;  // from start to done
  int busy;    // of these
};

template <int WA, int WB>
Result multiply(SerialMultiplier<WA, WB>& dut, std::int64_t a, std::uint64_t b) {
  dut.tick({.start = true, .a = a, .b = b});
  int busy = 0;
  for (int clocks = 1; clocks <= 2 * WB + 2; ++clocks) {
    // b is garbage after the start: the block must not look at it again.
    const auto out = dut.tick({.a = a, .b = ~b});
    busy += out.busy;
    if (out.done) return {std::int64_t(out.product.raw()), clocks, busy};
  }
  return {0, -1, busy};
}

TEST(SerialMultiplier, EveryProductOfFiveBitsByFourIsExact) {
  SerialMultiplier<5, 4> dut;
  for (int a = -16; a < 16; ++a) {
    for (int b = 0; b < 16; ++b) {
      ASSERT_EQ(multiply(dut, a, b).product, a * b) << a << " * " << b;
    }
  }
}

// Rounded down, for every shift, and as many clocks later.
RC_GTEST_PROP(SerialMultiplier, ShiftDropsTheProductsLastBits, ()) {
  const std::int64_t a = *rc::gen::inRange(-(1 << 26), 1 << 26);
  const std::int64_t b = *rc::gen::inRange(0, 1 << 16);
  const int shift = *rc::gen::inRange(0, 16);
  SerialMultiplier<27, 16> dut;
  dut.tick({.start = true, .a = a, .b = b, .shift = shift});
  int clocks = 0;
  SerialMultiplier<27, 16>::Out out;
  while (!out.done && ++clocks < 100) out = dut.tick({.a = a, .b = ~b, .shift = shift});
  RC_ASSERT(clocks == 17 + shift);
  RC_ASSERT(std::int64_t(out.product.raw()) == (a * b) >> shift);
}

// At any place of a product, also among the clocks that drop its last bits.
RC_GTEST_PROP(SerialMultiplier, SkippingQuietClocksEqualsTickingThem, ()) {
  const std::int64_t a = *rc::gen::inRange<std::int64_t>(-(std::int64_t{1} << 33), std::int64_t{1} << 33);
  const std::int64_t b = *rc::gen::inRange(0, 1 << 22);
  const int shift = *rc::gen::inRange(0, 16);
  SerialMultiplier<34, 22> ticking;
  ticking.tick({.start = true, .a = a, .b = b, .shift = shift});
  for (int before = *rc::gen::inRange(0, 40); before > 0; --before) ticking.tick({.a = a, .shift = shift});
  SerialMultiplier<34, 22> skipping = ticking;
  const auto quiet = static_cast<int>(skipping.quiet());
  RC_ASSERT(quiet < 22);
  const int clocks = *rc::gen::inRange(0, quiet + 1);
  if (clocks == 0) return;
  skipping.skip(a, static_cast<std::uint64_t>(clocks));
  for (int k = 0; k < clocks; ++k) RC_ASSERT(!ticking.tick({.a = a, .shift = shift}).done);
  RC_ASSERT(skipping == ticking);
}

TEST(SerialMultiplier, TheEndsOfTheRangeDoNotOverflow) {
  SerialMultiplier<34, 26> dut;
  const std::int64_t most = (std::int64_t{1} << 33) - 1;
  const std::uint64_t all = (1u << 26) - 1;
  EXPECT_EQ(multiply(dut, most, all).product, most * std::int64_t(all));
  EXPECT_EQ(multiply(dut, -most - 1, all).product, (-most - 1) * std::int64_t(all));
  EXPECT_EQ(multiply(dut, -1, 1).product, -1);
}

TEST(SerialMultiplier, TakesOneClockPerBitOfBAndOneMore) {
  SerialMultiplier<17, 16> dut;
  const auto result = multiply(dut, 3, 5);
  EXPECT_EQ(result.clocks, 17);
  EXPECT_EQ(result.busy, 16);
  SerialMultiplier<20, 26> longer;
  EXPECT_EQ(multiply(longer, 3, 5).clocks, 27);
}

RC_GTEST_PROP(SerialMultiplier, EndsOneClockBeforeDone, ()) {
  SerialMultiplier<5, 4> dut;
  bool due = false;
  int products = 0;
  for (int i = 0; i < 1000; ++i) {
    const bool start = *rc::gen::resize(100, rc::gen::inRange(0, 8)) == 0;
    const auto out = dut.tick({.start = start, .a = 3, .b = 5, .shift = i / 250});
    RC_ASSERT(out.done == due);
    due = out.ends && !start;
    products += out.done;
  }
  RC_ASSERT(products > 10);
}

TEST(SerialMultiplier, DoneLastsOneClockAndTheProductStays) {
  SerialMultiplier<9, 8> dut;
  multiply(dut, -100, 200);
  for (int i = 0; i < 100; ++i) {
    const auto out = dut.tick({.a = i, .b = i});
    ASSERT_FALSE(out.done);
    ASSERT_FALSE(out.busy);
    ASSERT_EQ(out.product, Int<17>(-20000));
  }
}

TEST(SerialMultiplier, ASecondStartTogetherWithDoneIsTaken) {
  SerialMultiplier<9, 8> dut;
  dut.tick({.start = true, .a = 7, .b = 11});
  for (int i = 0; i < 8; ++i) dut.tick({.a = 7});
  const auto out = dut.tick({.start = true, .a = -7, .b = 13});
  ASSERT_TRUE(out.done);
  EXPECT_EQ(out.product, Int<17>(77));
  for (int i = 0; i < 8; ++i) ASSERT_FALSE(dut.tick({.a = -7}).done);
  const auto second = dut.tick({});
  EXPECT_TRUE(second.done);
  EXPECT_EQ(second.product, Int<17>(-91));
}

// Whatever was in flight leaves no trace in the next product.
RC_GTEST_PROP(SerialMultiplier, ARestartForgetsTheWorkInFlight, ()) {
  const auto dropped = *rc::gen::inRange(0, 20);
  const auto a = *rc::gen::inRange(-(1 << 23), 1 << 23);
  const auto b = *rc::gen::inRange(0, 1 << 16);
  SerialMultiplier<24, 16> dut;
  dut.tick({.start = true, .a = *rc::gen::inRange(-(1 << 23), 1 << 23), .b = 0xFFFF});
  for (int i = 0; i < dropped; ++i) dut.tick({.a = 12345});
  const auto result = multiply(dut, a, b);
  RC_ASSERT(result.product == std::int64_t{a} * b);
  RC_ASSERT(result.clocks == 17);
}

}  // namespace
}  // namespace steplock
