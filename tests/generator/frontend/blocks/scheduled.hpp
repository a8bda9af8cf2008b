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

// With registers that hold the inputs of a sample, and its ports one by one, those of the schedule behind the block's.
template <class Block, int width, int second_width, int clocks>
class Held {
  using Schedule = Scheduled<Block, Budget{.width = width, .second_width = second_width, .clocks = clocks}>;

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
    typename Schedule::In given;
    static_cast<typename Block::In&>(given) = sample_;
    given.start = start_;
    Out out;
    static_cast<typename Schedule::Out&>(out) = schedule_.tick(given);
    start_ = in.start && !out.busy && !start_;
    if (start_) sample_ = in;
    return out;
  }

 private:
  Schedule schedule_;
  typename Block::In sample_;
  bool start_ = false;
};
using HeldFilter = Held<Filter, 25, 16, 17>;
using HeldCascade = Held<Cascade, 18, 18, 66>;

}  // namespace steplock::test
