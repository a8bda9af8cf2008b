// Blocks under a schedule.

#pragma once

#include <array>

#include "hls/numeric/scheduled.hpp"

namespace steplock::test {

// Products of several widths, state that is read before and after it changes, an output that is
// state.
class Filter {
 public:
  struct In {
    Int<16> x = 0;
    Int<16> a = 0;
    Int<16> b = 0;
    bool reverse = false;
    template <class F>
    void each(F f) {
      f(x), f(a), f(b), f(reverse);
    }
  };
  struct Out {
    Int<16> y = 0;
    Int<24> sum = 5;
    template <class F>
    void each(F f) {
      f(y), f(sum);
    }
  };
  Out tick(const In& in) {
    const auto fresh = in.reverse ? -in.x : Int<17>(in.x);
    const auto filtered = (fresh * in.a + last_ * in.b + Int<40>(sum_) * in.a) >> 14;
    last_ = in.x;
    sum_ = saturate<Int<24>>(sum_ + filtered);
    return {.y = saturate<Int<16>>(filtered), .sum = sum_};
  }

 private:
  Int<16> last_ = 3;
  Int<24> sum_ = 5;
};

// A block of blocks, whose registers become the schedule's.
class Cascade {
 public:
  struct In {
    Int<16> x = 0;
    Int<16> a = 0;
    template <class F>
    void each(F f) {
      f(x), f(a);
    }
  };
  struct Out {
    Int<16> y = -3;
    template <class F>
    void each(F f) {
      f(y);
    }
  };
  Out tick(const In& in) {
    const auto first = filters_[0].tick({.x = in.x, .a = in.a, .b = 9000});
    const auto second = filters_[1].tick({.x = first.y, .a = in.a, .b = -800, .reverse = true});
    if (second.y > 1000) ++count_;
    return {wrap<Int<16>>(second.y - count_)};
  }

 private:
  std::array<Filter, 2> filters_;
  std::int8_t count_ = 100;
};

using ScheduledFilter =
    Scheduled<Filter, Budget{.width = 25, .second_width = 16, .clocks = 6}>;
using ScheduledCascade =
    Scheduled<Cascade, Budget{.multipliers = 2, .width = 18, .second_width = 18, .clocks = 9}>;

// Its ports one by one, those of the schedule behind the block's.
template <class Schedule>
class Ported {
 public:
  struct In : Schedule::In {
    template <class F>
    void each(F f) {
      Schedule::In::each(f);
      f(this->start);
    }
  };
  struct Out : Schedule::Out {
    template <class F>
    void each(F f) {
      Schedule::Out::each(f);
      f(this->done), f(this->busy), f(this->missed);
    }
  };
  Out tick(const In& in) {
    Out out;
    static_cast<typename Schedule::Out&>(out) = schedule_.tick(in);
    return out;
  }

 private:
  Schedule schedule_;
};

// A schedule within an ordinary block: started every 16 clocks, its outputs read in every clock.
class Sampled {
 public:
  struct In {
    Int<16> x = 0;
    Int<16> a = 0;
    template <class F>
    void each(F f) {
      f(x), f(a);
    }
  };
  struct Out {
    Int<17> y = 0;
    bool late = false;
    template <class F>
    void each(F f) {
      f(y), f(late);
    }
  };
  Out tick(const In& in) {
    ScheduledFilter::In sample;
    sample.x = in.x;
    sample.a = in.a;
    sample.start = clock_ == 0;
    const auto out = filter_.tick(sample);
    if (out.done) results_ = wrap<Int<17>>(results_ + out.y);
    clock_ = wrap<UInt<4>>(clock_ + 1);
    return {.y = results_, .late = out.missed};
  }

 private:
  ScheduledFilter filter_;
  UInt<4> clock_ = 0;
  Int<17> results_ = 0;
};

}  // namespace steplock::test
