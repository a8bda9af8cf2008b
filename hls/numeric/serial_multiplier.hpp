// Serial multiplier: a signed number times an unsigned one, one bit of `b` per clock, one adder.
//
//     product = a * b       for each bit of b from below:  P <- (P + (bit ? a : 0)) / 2
//
// The half that each step drops is a bit of the product; it moves into the place that the used bit of
// `b` leaves free.  `a` is not copied, which saves its register: hold it until `done`.  `b` is taken
// with `start`.  A start while busy drops the work in flight.
//
//     latency      WB + 1 clocks from `start` to `done`
//     throughput   one product per WB + 1 clocks: the next start may come with `done`
//     registers    2 WA + WB bits and a counter
//     longest path one adder of WA + 1 bits
//
// Doc: docs/blocks/serial_multiplier.md   Test: tests/hls/serial_multiplier_test.cpp

#pragma once

#include "hls/numeric/bits.hpp"

namespace steplock {

template <int WA, int WB>
class SerialMultiplier {
  static_assert(WA >= 2 && WB >= 2 && WB <= 63 && WA + WB <= 64);

 public:
  struct In {
    bool start = false;  // takes b, begins with a
    Int<WA> a = 0;       // hold from start to done
    UInt<WB> b = 0;      // needed in the clock of start alone
  };

  struct Out {
    Int<WA + WB> product = 0;  // valid from done to the next start
    bool done = false;         // one clock
    bool busy = false;         // from the clock after start to the one before done
  };

  Out tick(const In& in) {
    const Out out{.product = (Int<WA + WB>(high_) << WB) | Int<WA + WB>(low_),
                  .done = done_,
                  .busy = left_ != 0};
    // The addend of the next clock, so that an adder and nothing else lies between registers.
    const bool next_bit = in.start ? in.b.bit(0) : low_.bit(1);
    const auto sum = high_ + addend_;
    done_ = !in.start && left_ == 1;
    if (in.start) {
      high_ = 0;
      low_ = in.b;
      left_ = WB;
    } else if (left_ != 0) {
      high_ = wrap<Int<WA>>(sum >> 1);
      low_ = (low_ >> 1) | (UInt<WB>(sum.bit(0)) << (WB - 1));
      left_ = wrap<Left>(left_ - 1);
    }
    addend_ = next_bit ? in.a : Int<WA>(0);
    return out;
  }

  bool operator==(const SerialMultiplier&) const = default;

 private:
  using Left = UInt<(WB >= 32 ? 6 : WB >= 16 ? 5 : WB >= 8 ? 4 : WB >= 4 ? 3 : 2)>;

  Int<WA> high_ = 0;    // the product so far, its upper bits
  UInt<WB> low_ = 0;    // above: its lower bits; below: the bits of b still to come
  Int<WA> addend_ = 0;  // a, or 0 where the bit of b is 0
  Left left_ = 0;       // clocks
  bool done_ = false;   // the product is complete
};

}  // namespace steplock
