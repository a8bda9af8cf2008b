// A block whose sample takes several clocks: its arithmetic is a program on one datapath, with one multiplier, one
// adder and its numbers in block RAM.
//
//     using Loop = Scheduled<Control, Budget{.width = 24, .second_width = 17, .clocks = 300}>;
//
// The block says what one sample does, in one call of its tick; the generator makes the program and prints a module
// with the block's ports and these:
//
//     start    begins a sample; ignored while busy
//     busy     from the clock after the start to the one before done; a start may come with done
//     done     one clock, `clocks` after the start: the results are new, and stay until the next
//     missed   one clock, the one after a start that was ignored
//
// The class below is what the module does in every clock, bit by bit; it is not how.  `clocks` is not free: hlsgen finds
// the fewest, and says so if the source says something else.
//
// The caller holds the inputs from the start to done: the program reads each when it needs it.  A caller that does not
// gets a sample of old and new numbers.
//
// What a loop waits for need not wait for the rest of its sample: outputs in a member `early` of Out are new `early` clocks
// after the start, and the program makes them first.
//
// Doc: docs/generator.md   Test: tests/hls/scheduled_test.cpp, tests/generator/machine_test.cpp

#pragma once

#include "hls/numeric/bits.hpp"

namespace steplock {

struct Budget {
  int width = 16;         // bits of the multiplier's first factor, signed; wider ones take turns
  int second_width = 16;  // of its second
  int clocks = 2;         // from start to done
  int early = 0;          // from start to the outputs in `early`; 0: it has none
};

template <class Block, Budget budget>
class Scheduled {
  static_assert(budget.width >= 4 && budget.width <= 64, "factors of 4 to 64 bits");
  static_assert(budget.second_width >= 4 && budget.second_width <= 64, "factors of 4 to 64 bits");
  static_assert(budget.clocks >= 2 && budget.clocks <= 4095, "2 to 4095 clocks");
  static_assert(budget.early >= 0 && budget.early <= budget.clocks, "early, not late");

 public:
  struct In : Block::In {
    bool start = false;  // begins a sample, unless busy
  };

  struct Out : Block::Out {
    bool done = false;    // one clock: the results are new
    bool busy = false;    // a start would be ignored
    bool missed = false;  // one clock: a start was ignored
  };

  static constexpr int kClocks = budget.clocks;  // from start to done
  static constexpr int kEarly = budget.early;    // from start to the outputs in `early`

  Out tick(const In& in) {
    const Out out = shown_;
    shown_.done = left_ == 1;
    shown_.missed = in.start && left_ != 0;
    if constexpr (kEarly != 0) {
      if (left_ == kClocks - kEarly + 1) shown_.early = Block(block_).tick(sample_).early;
    }
    if (left_ == 1) static_cast<typename Block::Out&>(shown_) = block_.tick(sample_);
    if (left_ != 0) {
      left_ = wrap<Left>(left_ - 1);
    } else if (in.start) {
      sample_ = in;
      left_ = kClocks - 1;
    }
    shown_.busy = left_ != 0;
    return out;
  }

  // Quiet clocks (docs/theory.md): until this block does more than count, and that many at once.
  std::uint64_t quiet() const {
    if (left_ == 0) return ~std::uint64_t{0};
    constexpr int kEvent = kEarly == 0 ? 0 : kClocks - kEarly + 1;  // the other one is at 1
    return static_cast<std::uint64_t>(left_ >= kEvent && kEvent > 1 ? left_.raw() - kEvent : left_.raw() - 1);
  }
  void skip(std::uint64_t clocks) {
    if (left_ != 0) left_ = Left::of(static_cast<std::uint64_t>(left_.raw()) - clocks);
  }

 private:
  using Left = UInt<12>;

  Block block_;
  typename Block::In sample_;
  Out shown_;
  Left left_ = 0;  // clocks until the results are new
};

}  // namespace steplock
