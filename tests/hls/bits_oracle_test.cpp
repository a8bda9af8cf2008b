// Bits against SystemC: sc_bigint for exact arithmetic, sc_fixed for wrapping and saturation.
#define SC_INCLUDE_FX
#define SC_DISABLE_API_VERSION_CHECK  // Debian builds it as C++17; the number types are headers
#include "hls/numeric/bits.hpp"

#include <gtest/gtest.h>

#include <random>
#include <systemc>

// SystemC's library brings a main() that wants this one; the tests have their own.
int sc_main(int, char**) { return 0; }

namespace steplock {
namespace {

using Big = sc_dt::sc_bigint<272>;  // wider than every result here

template <int W, bool S>
Big big(Bits<W, S> x) {
  Big b = x.negative() ? -1 : 0;
  for (int i = 0; i < W; ++i) b[i] = x.bit(i);
  return b;
}

// Ends, neighbours of powers of two, and anything.
template <class T>
T corner_or_any(std::mt19937_64& random) {
  const auto any = wrap<T>((UInt<128>(random()) << 64) | UInt<64>(random()));
  switch (random() % 6) {
    case 0: return T::max();
    case 1: return T::min();
    case 2: return T::of(T(1).raw() << int(random() % T::width));
    case 3: return T::of(-T(1).raw());
    default: return any;
  }
}

template <class A, class B>
void check_arithmetic() {
  std::mt19937_64 random(1);
  for (int i = 0; i < 2000; ++i) {
    const A a = corner_or_any<A>(random);
    const B b = corner_or_any<B>(random);
    const Big x = big(a), y = big(b);
    ASSERT_EQ(big(a + b), x + y);
    ASSERT_EQ(big(a - b), x - y);
    if constexpr (A::width + B::width <= 128) { ASSERT_EQ(big(a * b), x * y); }
    ASSERT_EQ(a < b, x < y);
    ASSERT_EQ(a == b, x == y);
    ASSERT_EQ(a >= b, x >= y);
    ASSERT_EQ(big(-a), -x);
    const int n = int(random() % A::width);
    ASSERT_EQ(big(a >> n), x >> n);
  }
}

TEST(BitsOracle, SumsDifferencesAndProductsAreThoseOfSystemC) {
  check_arithmetic<UInt<1>, UInt<9>>();
  check_arithmetic<UInt<14>, Int<17>>();
  check_arithmetic<Int<26>, Int<31>>();
  check_arithmetic<UInt<31>, UInt<32>>();
  check_arithmetic<UInt<32>, Int<32>>();
  check_arithmetic<Int<33>, UInt<31>>();
  check_arithmetic<Int<37>, UInt<26>>();
  check_arithmetic<UInt<63>, UInt<64>>();
  check_arithmetic<Int<64>, Int<64>>();
  check_arithmetic<Int<65>, UInt<63>>();
  check_arithmetic<UInt<64>, Int<33>>();
  check_arithmetic<Int<100>, UInt<28>>();
  check_arithmetic<UInt<125>, Int<126>>();
}

template <class To, class From>
void check_narrowing() {
  constexpr int W = To::width;
  using Wrap = std::conditional_t<To::is_signed, sc_dt::sc_fixed<W, W, sc_dt::SC_TRN, sc_dt::SC_WRAP>,
                                  sc_dt::sc_ufixed<W, W, sc_dt::SC_TRN, sc_dt::SC_WRAP>>;
  using Saturate = std::conditional_t<To::is_signed, sc_dt::sc_fixed<W, W, sc_dt::SC_TRN, sc_dt::SC_SAT>,
                                      sc_dt::sc_ufixed<W, W, sc_dt::SC_TRN, sc_dt::SC_SAT>>;
  std::mt19937_64 random(2);
  for (int i = 0; i < 2000; ++i) {
    const From x = corner_or_any<From>(random);
    ASSERT_EQ(sc_dt::sc_fix(big(wrap<To>(x)), 272, 272), Wrap(big(x)));
    ASSERT_EQ(sc_dt::sc_fix(big(saturate<To>(x)), 272, 272), Saturate(big(x)));
  }
}

TEST(BitsOracle, WrapIsScWrapAndSaturateIsScSat) {
  check_narrowing<UInt<8>, UInt<14>>();
  check_narrowing<Int<8>, Int<14>>();
  check_narrowing<UInt<16>, Int<26>>();
  check_narrowing<Int<16>, UInt<26>>();
  check_narrowing<Int<32>, Int<33>>();
  check_narrowing<UInt<32>, Int<37>>();
  check_narrowing<Int<37>, Int<63>>();
  check_narrowing<UInt<64>, Int<65>>();
  check_narrowing<Int<64>, UInt<64>>();
  check_narrowing<Int<65>, Int<128>>();
  check_narrowing<UInt<100>, Int<128>>();
  // Wider than the source: nothing may change but what the sign forbids.
  check_narrowing<Int<20>, UInt<14>>();
  check_narrowing<UInt<20>, Int<14>>();
}

// sc_fixed<W, I>: the same two words for numbers with a fraction, truncated as a shift truncates.
TEST(BitsOracle, AShiftRightIsScTrn) {
  std::mt19937_64 random(3);
  for (int i = 0; i < 2000; ++i) {
    const Int<24> x = corner_or_any<Int<24>>(random);
    const sc_dt::sc_fixed<24, 4> fraction = sc_dt::sc_fixed<44, 24>(big(x)) >> 20;
    const sc_dt::sc_fixed<16, 4, sc_dt::SC_TRN, sc_dt::SC_WRAP> cut = fraction;
    ASSERT_EQ(sc_dt::sc_fix(big(wrap<Int<16>>(x >> 8)), 44, 44) >> 12, cut);
  }
}

}  // namespace
}  // namespace steplock
