// Test block: names that C++ gives to values, and that the netlist shall keep.

#pragma once

#include "hls/numeric/bits.hpp"
#include "tests/generator/frontend/blocks/named_law.hpp"

namespace steplock::test {

// Two bits that are one member.
class Chosen {
 public:
  UInt<2> bits = 0;
};

class Named {
 public:
  struct In {
    bool go = false, hold = false;
    Int<8> x = 0, gain = 0;
    template <class F>
    void each(F f) { f(go), f(hold), f(x), f(gain); }
  };
  struct Out {
    Int<12> y = 0, z = 0;
    UInt<4> count = 0;
    template <class F>
    void each(F f) { f(y), f(z), f(count); }
  };

  Out tick(const In& in) {
    const bool starts = in.go && !in.hold;  // a bool, which clang keeps in a byte
    const auto twice = [](bool yes) { return yes ? UInt<4>(2) : UInt<4>(0); };
    if (starts) count_ = wrap<UInt<4>>(count_ + twice(y_ == 3 || in.x == 5));
    if (starts || in.x == 1) chosen_.bits = wrap<UInt<2>>(chosen_.bits + 1);
    y_ = law_.corrected(in.x, in.gain);
    return {.y = wrap<Int<12>>(y_ ^ law_.corrected(in.gain, limit(in))),
            .z = starts ? Int<12>(1) : y_,
            .count = wrap<UInt<4>>(count_ + chosen_.bits)};
  }

 private:
  Int<8> limit(const In& in) const { return in.x > in.gain ? in.gain : in.x; }

  Law law_;
  Chosen chosen_;   
  Int<12> y_ = 0;
  UInt<4> count_ = 0;
};

}  // namespace steplock::test
