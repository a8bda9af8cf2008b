// Serial multiplier: a signed number times an unsigned one, one bit of `b` per clock, one adder.
//
//     product = a * b >> shift     for each bit of b from below:  P <- (P + (bit ? a : 0)) / 2
//
// The half that each step drops is a bit of the product; it moves into the place that the used bit of
// `b` leaves free.  `a` is not copied, which saves its register: hold it until `done`.  `b` is taken
// with `start`.  A start while busy drops the work in flight.  `shift` goes on with bits of 0, which is
// a barrel shifter for the price of its clocks.
//
//     latency      WB + shift + 1 clocks from `start` to `done`
//     throughput   one product in that time: the next start may come with `done`
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
    UInt<4> shift = 0;   // bits to drop from the product's end; hold from start to done
  };

  struct Out {
    Int<WA + WB> product = 0;  // valid from done to the next start
    bool done = false;         // one clock
    bool busy = false;         // from the clock after start to the one before done
    bool ends = false;         // done comes in the next clock, unless a start drops it
  };

  Out tick(const In& in) {
    const bool drops = last_ && !dropping_ && in.shift != 0;
    const bool ends = last_ && !drops;
    const Out out{.product = (Int<WA + WB>(high_) << WB) | Int<WA + WB>(low_),
                  .done = done_,
                  .busy = left_ != 0,
                  .ends = ends};
    const auto sum = high_ + addend_;
    done_ = !in.start && ends;
    // The addend is that of the next clock, so that an adder and nothing else lies between registers.
    if (in.start) {
      high_ = 0;
      low_ = in.b;
      left_ = WB;
      dropping_ = false;
      addend_ = in.b.bit(0) ? in.a : Int<WA>(0);
      last_ = false;
    } else if (left_ != 0) {
      addend_ = low_.bit(1) && !last_ && !dropping_ ? in.a : Int<WA>(0);
      high_ = wrap<Int<WA>>(sum >> 1);
      low_ = (low_ >> 1) | (UInt<WB>(sum.bit(0)) << (WB - 1));
      last_ = drops ? in.shift == 1 : left_ == 2;
      left_ = drops ? Left(in.shift) : wrap<Left>(left_ - 1);
      dropping_ = dropping_ || drops;
    }
    return out;
  }

  // Quiet clocks (docs/theory.md): until this block does more than shift and add, and that many at
  // once.  The addends of n clocks are `a` times the n bits of b that go out meanwhile.
  std::uint64_t quiet() const { return left_ < 2 ? 0 : left_.raw() - 1; }
  void skip(Int<WA> a, std::uint64_t clocks) {
    const auto n = static_cast<int>(clocks);
    const std::uint64_t low = low_.raw(), place = std::uint64_t{1} << n;
    const auto used = static_cast<std::int64_t>(dropping_ ? 0 : low & (place - 2));
    const std::int64_t sum = high_.raw() + addend_.raw() + a.raw() * used;
    addend_ = !dropping_ && (low & place) != 0 ? a : Int<WA>(0);
    high_ = Int<WA>::of(sum >> n);
    low_ = UInt<WB>::of(low >> n | (static_cast<std::uint64_t>(sum) & (place - 1)) << (WB - n));
    left_ = Left::of(left_.raw() - clocks);
    last_ = left_ == 1;
  }
  bool operator==(const SerialMultiplier&) const = default;

 private:
  using Left = UInt<(WB >= 32 ? 6 : WB >= 16 ? 5 : 4)>;  // room for shift as well

  Int<WA> high_ = 0;    // the product so far, its upper bits
  UInt<WB> low_ = 0;    // above: its lower bits; below: the bits of b still to come
  Int<WA> addend_ = 0;  // a, or 0 where the bit of b is 0
  Left left_ = 0;       // clocks
  bool last_ = false;   // of them 1
  bool dropping_ = false;  // b is used up; the clocks that are left shift the product
  bool done_ = false;   // the product is complete
};

}  // namespace steplock
