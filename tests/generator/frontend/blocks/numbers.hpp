// Test blocks: arithmetic of all widths and signs.

#pragma once

#include "hls/numeric/bits.hpp"

namespace steplock::test {

class Arithmetic {
 public:
  struct In {
    Int<16> a = 0, b = 0;
    UInt<13> u = 0;
    UInt<4> n = 0;
    template <class F>
    void each(F f) { f(a), f(b), f(u), f(n); }
  };
  struct Out {
    Int<16> sum = 0, difference = 0, scaled = 0, larger = 0, magnitude = 0;
    Int<32> product = 0;
    Int<29> mixed = 0;
    UInt<16> left = 0, right = 0, remainder = 0;
    Int<16> quotient = 0, arithmetic_right = 0, rest = 0;
    bool less = false, mixed_less = false;
    template <class F>
    void each(F f) {
      f(sum), f(difference), f(scaled), f(larger), f(magnitude), f(product), f(mixed), f(left);
      f(right), f(remainder), f(quotient), f(arithmetic_right), f(rest), f(less), f(mixed_less);
    }
  };

  Out tick(const In& in) {
    Out out;
    out.sum = saturate<Int<16>>(in.a + in.b);
    out.difference = saturate<Int<16>>(in.a - in.b);
    accumulator_ = saturate<Int<20>>(accumulator_ + in.a);
    out.scaled = wrap<Int<16>>(accumulator_ >> 4);
    out.larger = in.a > in.b ? in.a : in.b;
    out.magnitude = saturate<Int<16>>(in.a < 0 ? -in.a : Int<17>(in.a));
    out.product = in.a * in.b;
    out.mixed = in.a * in.u;
    out.left = wrap<UInt<16>>(UInt<16>(in.u) << in.n.raw());
    out.right = UInt<16>(in.u) >> in.n.raw();
    out.arithmetic_right = in.a >> in.n.raw();
    out.remainder = in.u.raw() % 8;
    out.quotient = static_cast<int>(in.a.raw()) / 16;
    out.rest = static_cast<int>(in.a.raw()) % 32;
    out.less = in.a < in.b;
    out.mixed_less = in.a < in.u;
    return out;
  }

 private:
  Int<20> accumulator_ = -3;
};

class Wide {
 public:
  struct In {
    Int<64> a = 0, b = 0;
    UInt<64> c = 0;
    UInt<33> d = 0;
    UInt<128> e = 0;
    template <class F>
    void each(F f) { f(a), f(b), f(c), f(d), f(e); }
  };
  struct Out {
    Int<65> sum = 0;
    Int<128> product = 0;
    UInt<128> square = 0, xored = 0;
    UInt<97> slow = 0;
    UInt<34> odd = 0;
    bool less = false;
    template <class F>
    void each(F f) { f(sum), f(product), f(square), f(xored), f(slow), f(odd), f(less); }
  };

  Out tick(const In& in) {
    Out out;
    out.sum = in.a + in.b;
    out.product = in.a * in.b;
    out.square = in.c * in.c;
    out.xored = in.e ^ (in.e << 17) ^ (in.e >> 100);
    slow_ = wrap<UInt<97>>(slow_ + in.d * in.c);
    out.slow = slow_;
    out.odd = in.d + UInt<33>(last_);
    last_ = in.d;
    out.less = in.e < UInt<128>(in.c);
    return out;
  }

 private:
  UInt<97> slow_ = 1;
  UInt<33> last_ = 0;
};

// Plain C++ integers, with the promotions and conversions of the language.
class Plain {
 public:
  struct In {
    std::int8_t a = 0;
    std::uint8_t b = 0;
    std::int16_t c = 0;
    std::uint32_t d = 0;
    std::int64_t e = 0;
    bool f0 = false, f1 = false;
    template <class F>
    void each(F f) { f(a), f(b), f(c), f(d), f(e), f(f0), f(f1); }
  };
  struct Out {
    int sum = 0;
    std::uint8_t wrapped = 0;
    std::int64_t wide = 0;
    std::uint32_t rotated = 0, swapped = 0, reversed = 0;
    std::uint16_t flags = 0;
    bool odd = false;
    template <class F>
    void each(F f) { f(sum), f(wrapped), f(wide), f(rotated), f(swapped), f(reversed), f(flags), f(odd); }
  };

  Out tick(const In& in) {
    Out out;
    out.sum = in.a * in.b - (in.c << 3) + in.f0;
    out.wrapped = static_cast<std::uint8_t>(in.a + in.b + in.f1);
    out.wide = in.e * 5 - in.d + (in.e >> 7);
    const unsigned n = in.b & 31;
    out.rotated = in.d << n | in.d >> ((32 - n) & 31);
    out.swapped = in.d >> 24 | (in.d >> 8 & 0xff00) | (in.d << 8 & 0xff0000) | in.d << 24;
    for (int i = 0; i < 32; ++i) out.reversed |= (in.d >> i & 1) << (31 - i);
    out.flags = static_cast<std::uint16_t>(in.f0 + in.f1 * 2 + (in.a > in.c) * 4 +
                                           (in.b > in.d) * 8 + (in.e < 0 || in.f0) * 16);
    int parity = 0;
    for (unsigned x = in.d; x != 0; x >>= 1) parity += x & 1;
    out.odd = parity % 2 != 0;
    counter_ += static_cast<std::uint16_t>(in.b);
    out.sum ^= counter_;
    return out;
  }

 private:
  std::uint16_t counter_ = 65000;
};

}  // namespace steplock::test
