#include "hls/numeric/bits.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <type_traits>

namespace steplock {
namespace {

template <class T>
constexpr long long number(T x) { return static_cast<long long>(x.raw()); }

// Every pair of values of two small types, against the integers of the host.
template <class A, class B>
void check_every_pair() {
  for (long long i = number(A::min()); i <= number(A::max()); ++i) {
    for (long long j = number(B::min()); j <= number(B::max()); ++j) {
      const A a = A::of(i);
      const B b = B::of(j);
      ASSERT_EQ(number(a + b), i + j);
      ASSERT_EQ(number(a - b), i - j);
      ASSERT_EQ(number(a * b), i * j);
      ASSERT_EQ(a == b, i == j);
      ASSERT_EQ(a != b, i != j);
      ASSERT_EQ(a < b, i < j);
      ASSERT_EQ(a <= b, i <= j);
      ASSERT_EQ(a > b, i > j);
      ASSERT_EQ(a >= b, i >= j);
    }
  }
}

TEST(Bits, SumsDifferencesProductsAndComparisonsOfSmallTypesAreThoseOfIntegers) {
  check_every_pair<UInt<4>, UInt<4>>();
  check_every_pair<UInt<3>, UInt<5>>();
  check_every_pair<Int<4>, Int<4>>();
  check_every_pair<Int<3>, Int<6>>();
  check_every_pair<UInt<4>, Int<4>>();
  check_every_pair<Int<5>, UInt<3>>();
  check_every_pair<Int<2>, UInt<6>>();
  check_every_pair<UInt<1>, Int<7>>();
}

// The widths that the header promises are part of the contract: they become wires.
static_assert(std::is_same_v<decltype(UInt<8>() + UInt<5>()), UInt<9>>);
static_assert(std::is_same_v<decltype(UInt<8>() + Int<5>()), Int<10>>);
static_assert(std::is_same_v<decltype(UInt<8>() - UInt<8>()), Int<9>>);
static_assert(std::is_same_v<decltype(Int<8>() - UInt<8>()), Int<10>>);
static_assert(std::is_same_v<decltype(UInt<8>() * Int<5>()), Int<13>>);
static_assert(std::is_same_v<decltype(UInt<8>() << 3), UInt<8>>);
static_assert(std::is_same_v<decltype(UInt<8>() + 1), UInt<9>>);
static_assert(std::is_same_v<decltype(Int<8>() * 3), Int<16>>);
static_assert(std::is_same_v<decltype(-UInt<8>()), Int<9>>);
static_assert(std::is_same_v<decltype(UInt<8>().slice<6, 2>()), UInt<5>>);

// What loses value does not convert by itself.
static_assert(std::is_convertible_v<UInt<8>, UInt<9>>);
static_assert(std::is_convertible_v<UInt<8>, Int<9>>);
static_assert(!std::is_convertible_v<UInt<8>, Int<8>>);
static_assert(!std::is_convertible_v<Int<8>, UInt<20>>);
static_assert(!std::is_convertible_v<UInt<9>, UInt<8>>);

TEST(Bits, TheEndsOfTheWidestTypesAreReached) {
  EXPECT_EQ(UInt<128>::max() >> 127, UInt<128>(1));
  EXPECT_TRUE(Int<128>::min().negative());
  EXPECT_FALSE(Int<128>::max().negative());
  EXPECT_EQ(wrap<Int<128>>(UInt<128>::max()), Int<128>(-1));
  // (2^64 - 1)^2 = 2^128 - 2^65 + 1
  EXPECT_EQ(UInt<64>::max() * UInt<64>::max(), (UInt<128>::max() << 65) | UInt<128>(1));
}

TEST(Bits, ALiteralWraps) {
  EXPECT_EQ(UInt<4>(17), UInt<4>(1));
  EXPECT_EQ(UInt<4>(-1), UInt<4>::max());
  EXPECT_EQ(Int<4>(8), Int<4>::min());
}

TEST(Bits, WrapDropsTheUpperBitsAndSaturateStopsAtTheEnds) {
  for (int i = -300; i <= 300; ++i) {
    const Int<12> x = i;
    EXPECT_EQ(number(wrap<Int<6>>(x)), ((i % 64) + 96) % 64 - 32);
    EXPECT_EQ(number(wrap<UInt<6>>(x)), ((i % 64) + 64) % 64);
    EXPECT_EQ(number(saturate<Int<6>>(x)), i < -32 ? -32 : i > 31 ? 31 : i);
    EXPECT_EQ(number(saturate<UInt<6>>(x)), i < 0 ? 0 : i > 63 ? 63 : i);
  }
}

TEST(Bits, ShiftsKeepTheWidthAndTheSign) {
  EXPECT_EQ(UInt<8>(0xC1) << 1, UInt<8>(0x82));
  EXPECT_EQ(UInt<8>(0xC1) >> 1, UInt<8>(0x60));
  EXPECT_EQ(Int<8>(-63) << 2, Int<8>(4));
  EXPECT_EQ(Int<8>(-63) >> 1, Int<8>(-32));
}

TEST(Bits, SlicesAndBitsReadTheirPlaces) {
  const UInt<12> x = 0xABC;
  EXPECT_EQ((x.slice<11, 8>()), UInt<4>(0xA));
  EXPECT_EQ((x.slice<7, 4>()), UInt<4>(0xB));
  EXPECT_EQ((x.slice<11, 0>()), x);
  for (int i = 0; i < 12; ++i) EXPECT_EQ(x.bit(i), (0xABC >> i & 1) != 0);
  EXPECT_TRUE((Int<12>(-1).slice<11, 11>()) == 1);
}

TEST(Bits, LogicWorksBitByBit) {
  const UInt<8> a = 0b11001010, b = 0b10100110;
  EXPECT_EQ(a & b, UInt<8>(0b10000010));
  EXPECT_EQ(a | b, UInt<8>(0b11101110));
  EXPECT_EQ(a ^ b, UInt<8>(0b01101100));
  EXPECT_EQ(~a, UInt<8>(0b00110101));
  EXPECT_EQ(~Int<8>(5), Int<8>(-6));
}

TEST(Bits, AComplementIsComparedWithAsItsNumber) {
  for (int a = 0; a < 16; ++a) {
    for (int b = 0; b < 16; ++b) EXPECT_EQ(at_least(UInt<4>(a), ~UInt<4>(b)), a >= b) << a << ' ' << b;
  }
}

TEST(Bits, OffsetNumbersAreInTheOrderOfSignedOnes) {
  for (int a = -8; a < 8; ++a) EXPECT_EQ(offset(Int<4>(a)), UInt<4>(a + 8));
}

TEST(Bits, EverythingWorksAtCompileTime) {
  constexpr auto sum = UInt<8>(200) + UInt<8>(100);
  static_assert(sum == 300);
  static_assert(saturate<UInt<8>>(sum) == 255);
  static_assert(wrap<UInt<8>>(sum) == 44);
  static_assert(-UInt<8>(200) == -200);
  SUCCEED();
}

}  // namespace
}  // namespace steplock
