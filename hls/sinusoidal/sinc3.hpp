// Sinc3 filter of one window: three windows' worth of a modulator's bits to one number.
//
//     value = sum w(k) bit(k),  k = 0 .. 3 M - 1,  M = 2^Log2
//     w     the convolution of three boxcars of M: sinc^3, symmetric around k = (3 M - 3) / 2; the
//           last two bits have no weight
//
// Three integrators that begin at 0 with the window, and their third difference taken as
// I(3 M) - 3 I(2 M) + 3 I(M), in arithmetic modulo 2^(3 Log2 + 1), which holds the result exactly.
// Half of the bits set is 0.  Of a second-order modulator's noise, white in its quantiser, a
// variance of 2 / M^5 of full scale squared remains.
//
//     latency      1 clock from the last bit to done, which is up for one clock; value stays
//     registers    4 (3 Log2 + 1) + Log2 + 3 bits     multipliers  none
//
// Doc: docs/blocks/sinc3.md   Test: tests/hls/sinc3_test.cpp

#pragma once

#include "hls/numeric/bits.hpp"

namespace steplock {

template <int Log2 = 6>
class Sinc3 {
  static_assert(Log2 >= 2 && Log2 <= 10);
  static constexpr int kBits = 3 * Log2;

 public:
  struct In {
    bool start = false;  // a window begins; a bit of this clock is not in it
    bool valid = false;  // there is a bit
    bool bit = false;
  };

  struct Out {
    bool busy = false;     // within a window
    bool done = false;     // one clock: the value is new
    Int<kBits> value = 0;  // s0.(kBits - 1), full scale of the modulator
  };

  Out tick(const In& in) {
    const auto half = Sum::of(Sum(1).raw() << (kBits - 1));
    // All bits set is one more than the format holds.
    const auto centred = Int<kBits + 1>::of((difference_ - half).raw());
    const Out out{.busy = third_ != 0, .done = done_, .value = saturate<Int<kBits>>(centred)};

    const Sum sum = wrap<Sum>(third_integral_ + second_integral_);
    const Sum thrice = wrap<Sum>(sum + (sum << 1));
    done_ = false;
    if (in.start) {
      third_ = 1;
      bits_ = 0;
      first_integral_ = 0;
      second_integral_ = 0;
      third_integral_ = 0;
    } else if (in.valid && out.busy) {
      third_integral_ = sum;
      second_integral_ = wrap<Sum>(second_integral_ + first_integral_);
      first_integral_ = wrap<Sum>(first_integral_ + UInt<1>(in.bit ? 1 : 0));
      if (bits_ == UInt<Log2>::max()) {
        difference_ = third_ == 1   ? thrice
                      : third_ == 2 ? wrap<Sum>(difference_ - thrice)
                                    : wrap<Sum>(difference_ + sum);
        done_ = third_ == 3;
        third_ = wrap<UInt<2>>(third_ + 1);
      }
      bits_ = wrap<UInt<Log2>>(bits_ + 1);
    }
    return out;
  }

 private:
  using Sum = UInt<kBits + 1>;

  UInt<2> third_ = 0;  // of the window, 1 to 3; 0: no window
  UInt<Log2> bits_ = 0;
  Sum first_integral_ = 0;
  Sum second_integral_ = 0;
  Sum third_integral_ = 0;
  Sum difference_ = 0;
  bool done_ = false;
};

}  // namespace steplock
