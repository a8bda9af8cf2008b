// Test blocks: helpers, references, lambdas, choices between objects, inheritance.

#pragma once

#include "hls/numeric/bits.hpp"

#include <array>

namespace steplock::test {

struct Pair {
  UInt<9> low = 0;
  Int<7> high = 0;
};

template <class T>
void exchange(T& a, T& b) {
  const T old = a;
  a = b;
  b = old;
}

constexpr Pair made(UInt<9> low, Int<7> high) {
  Pair pair;
  pair.low = low;
  pair.high = high;
  return pair;
}

class Counting {
 protected:
  UInt<6> count_ = 3;
};

class Calls : Counting {
 public:
  struct In {
    bool swap = false, first = false, write = false;
    UInt<9> low = 0;
    Int<7> high = 0;
    UInt<2> at = 0;
    template <class F>
    void each(F f) { f(swap), f(first), f(write), f(low), f(high), f(at); }
  };
  struct Out {
    UInt<9> low = 0;
    Int<7> high = 0;
    UInt<10> sum = 0, total = 0;
    UInt<6> count = 0;
    template <class F>
    void each(F f) { f(low), f(high), f(sum), f(total), f(count); }
  };

  Out tick(const In& in) {
    if (in.swap) exchange(a_, b_);
    Pair& chosen = in.first ? a_ : b_;
    if (in.write) chosen = made(in.low, in.high);
    else chosen.low = wrap<UInt<9>>(chosen.low + 1);
    const Pair& read = in.first ? b_ : a_;

    UInt<10> total = 0;
    const auto add = [&total](UInt<9> x) { total = wrap<UInt<10>>(total + x); };
    add(a_.low);
    add(b_.low);
    for (const auto x : more_) add(x);
    put(more_, in.at, in.low);

    (in.swap ? count_ : other_) = wrap<UInt<6>>(count_ + UInt<2>(2));
    return {read.low, read.high, a_.low + b_.low, total, count_ ^ other_};
  }

 private:
  static void put(std::array<UInt<9>, 3>& where, UInt<2> at, UInt<9> what) {
    if (at.raw() < where.size()) where[at.raw()] = what;
  }

  Pair a_ = made(1, 2);
  Pair b_ = {};
  std::array<UInt<9>, 3> more_ = {7, 8, 9};
  UInt<6> other_ = 0;
};

}  // namespace steplock::test
