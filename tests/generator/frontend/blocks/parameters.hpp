// Test blocks: parts that may be left out, by the parent's own parameter and by a constant.

#pragma once

#include "hls/numeric/bits.hpp"
#include "hls/numeric/parameter.hpp"

namespace steplock::test {

class Counted {
 public:
  struct In {
    Parameter<true> counts;
    Parameter<false> doubles;  // two for each event
    bool event = false;
    template <class F>
    void each(F f) { f(counts), f(doubles), f(event); }
  };
  struct Out {
    UInt<8> count = 0;
    template <class F>
    void each(F f) { f(count); }
  };
  Out tick(const In& in) {
    const Out out{count_};
    if (!in.counts) {
      count_ = 0;
    } else if (in.event) {
      count_ = wrap<UInt<8>>(count_ + (in.doubles ? UInt<2>(2) : UInt<2>(1)));
    }
    return out;
  }

 private:
  UInt<8> count_ = 0;
};

class PartedCounters {
 public:
  struct Parts {
    Parameter<true> first;  // the first counter
    template <class F>
    void each(F f) { f(first); }
  };
  struct In {
    Parts with;
    bool event = false;
    template <class F>
    void each(F f) { with.each(f), f(event); }
  };
  struct Out {
    UInt<8> first = 0;
    UInt<8> second = 0;
    bool both = false;
    template <class F>
    void each(F f) { f(first), f(second), f(both); }
  };
  Out tick(const In& in) {
    const auto first = first_.tick({.counts = in.with.first, .event = in.event});
    const auto second = second_.tick({.counts = true, .doubles = true, .event = in.event});
    return {first.count, second.count, in.with.first && in.event};
  }

 private:
  Counted first_, second_;
};

// Somebody's own class of that name is numbers like any other.
template <int Start>
struct OwnParameter {
  template <int Value>
  struct Parameter {
    UInt<8> value = Value;
  };
  struct In {
    Parameter<Start> gain;
    template <class F>
    void each(F f) { f(gain.value); }
  };
  struct Out {
    UInt<8> sum = 0;
    template <class F>
    void each(F f) { f(sum); }
  };
  Out tick(const In& in) {
    const Out out{sum_};
    sum_ = wrap<UInt<8>>(sum_ + in.gain.value);
    return out;
  }

 private:
  UInt<8> sum_ = 0;
};

}  // namespace steplock::test
