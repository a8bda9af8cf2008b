// Serial multiplier: signed a times unsigned b, one bit of b per clock.
//
//     product = a * b        exact, WA + WB bits
//
// Shift and add: the upper half holds the partial sum, the lower half the bits of b still to come, so
// one adder of WA + 1 bits and one register do the whole product.  It takes the place of a DSP block
// where a result is wanted once in a commutation step or in a millisecond.
//
//     latency      WB + 1 clocks from start to done; product holds until the next start
//     throughput   a start while busy drops the work in flight and begins anew
//     registers    2 WA + WB + 2 + log2 WB bits     multipliers  none
//
// Doc: docs/blocks/serial_multiplier.md   Test: tests/hls/serial_multiplier_test.cpp

#pragma once

#include "hls/numeric/bits.hpp"

namespace steplock {

template <int WA, int WB>
class SerialMultiplier {
 public:
  struct In {
    bool start = false;  // takes a and b
    Int<WA> a = 0;       // any signed format
    UInt<WB> b = 0;      // any unsigned format
  };

  struct Out {
    Int<WA + WB> product = 0;  // valid from done to the next start
    bool done = false;         // one clock
    bool busy = false;
  };

  Out tick(const In& in) {
    const bool busy = remaining_ != 0;
    const Out out{.product = product(), .done = done_, .busy = busy};
    done_ = remaining_ == 1 && !in.start;
    if (in.start) {
      a_ = in.a;
      high_ = 0;
      low_ = in.b;
      remaining_ = WB;
    } else if (busy) {
      // high_ is below |a| / 1, so that high_ + a fits one bit more than a.
      const Int<WA + 1> sum = low_.bit(0) ? wrap<Int<WA + 1>>(high_ + a_) : Int<WA + 1>(high_);
      low_ = (low_ >> 1) | (UInt<WB>::of(sum.bit(0) ? 1 : 0) << (WB - 1));
      high_ = wrap<Int<WA>>(sum >> 1);
      remaining_ = wrap<UInt<kCount>>(remaining_ - 1);
    }
    return out;
  }

 private:
  static constexpr int kCount = WB < 16 ? 4 : WB < 32 ? 5 : 6;

  Int<WA + WB> product() const {
    return (Int<WA + WB>(high_) << WB) | wrap<Int<WA + WB>>(low_);
  }

  Int<WA> a_ = 0;
  Int<WA> high_ = 0;           // partial sum above the bits of b
  UInt<WB> low_ = 0;           // bits of b still to come, then of the product
  UInt<kCount> remaining_ = 0;  // clocks until done
  bool done_ = false;
};

}  // namespace steplock
