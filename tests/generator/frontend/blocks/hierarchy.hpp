// Test blocks: blocks within blocks, by member and by array, chained within one clock.

#pragma once

#include "hls/numeric/bits.hpp"
#include "tests/generator/frontend/blocks/accumulator.hpp"

#include <array>

namespace steplock::test {

template <int W>
class Delay {
 public:
  struct In {
    UInt<W> value = 0;
    bool bypass = false;
    template <class F>
    void each(F f) { f(value), f(bypass); }
  };
  struct Out {
    UInt<W> value = 0;
    template <class F>
    void each(F f) { f(value); }
  };
  Out tick(const In& in) {
    const Out out{in.bypass ? in.value : kept_};  // a path from input to output within the clock
    kept_ = in.value;
    return out;
  }

 private:
  UInt<W> kept_ = 1;
};

class Middle {
 public:
  struct In {
    UInt<8> value = 0;
    UInt<3> bypass = 0;
    template <class F>
    void each(F f) { f(value), f(bypass); }
  };
  struct Out {
    UInt<8> value = 0;
    UInt<9> sum = 0;
    template <class F>
    void each(F f) { f(value), f(sum); }
  };
  Out tick(const In& in) {
    UInt<8> value = in.value;
    UInt<9> sum = 0;
    for (int i = 0; i < 3; ++i) {
      value = chain_[i].tick({value, in.bypass.bit(i)}).value;
      sum = wrap<UInt<9>>(sum + value);
    }
    return {value, sum};
  }

 private:
  std::array<Delay<8>, 3> chain_;
};

class Hierarchy {
 public:
  struct In {
    bool enable = false;
    Middle::In middle;
    Int<12> step = 0;
    template <class F>
    void each(F f) { f(enable), middle.each(f), f(step); }
  };
  struct Out {
    Middle::Out middle;
    UInt<12> phase = 0;
    UInt<8> held = 0;
    template <class F>
    void each(F f) { middle.each(f), f(phase), f(held); }
  };
  Out tick(const In& in) {
    Out out;
    const auto phase = accumulator_.tick(
        {.enable = in.enable, .load = held_ == 7, .angle = UInt<12>(held_), .step = in.step});
    const auto doubled = twice_.tick({.value = wrap<UInt<8>>(phase.phase), .bypass = phase.wraps});
    auto middle = in.middle;
    middle.value = middle.value ^ doubled.value;
    out.middle = middle_.tick(middle);
    if (in.enable) held_ = out.middle.value;
    out.phase = phase.phase;
    out.held = held_;
    return out;
  }

 private:
  Delay<8> twice_;
  Middle middle_;
  PhaseAccumulator<12> accumulator_;
  UInt<8> held_ = 0;
};

}  // namespace steplock::test
