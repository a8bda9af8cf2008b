// A block whose sample takes several clocks: its arithmetic shares the multipliers of a budget.
//
//     using CurrentLoop = Scheduled<CurrentControl, Budget{.multipliers = 1, .clocks = 24}>;
//
// The block says what one sample does, in one call of its tick; the generator spreads it over
// `clocks` clocks and prints a module with the block's ports and these:
//
//     start    begins a sample; ignored while busy
//     busy     from the clock after the start to the one before done; a start may come with done
//     done     one clock, `clocks` after the start: the results are new, and stay until the next
//     missed   one clock, the one after a start that was ignored
//
// The class below is what the module does in every clock, bit by bit; it is not how.  `clocks` is
// not free: hlsgen finds the fewest that the budget allows, and says so if the source says
// something else.
//
// Inputs are taken with the start, in registers where they are still needed later.  With
// Inputs::kHeld the caller holds them from the start to done instead, which costs nothing: outputs
// of other scheduled blocks, settings.  A caller that does not, gets a sample of old and new
// numbers.
//
// With Form::kProgram the sample becomes a program on one datapath with its numbers in block RAM: more
// clocks, far fewer logic cells.  Its inputs have to be held.
//
// What a loop waits for need not wait for the rest of its sample: outputs in a member `early` of a
// program's Out are new `early` clocks after the start, and the program makes them first.
//
// Doc: docs/generator.md   Test: tests/hls/scheduled_test.cpp, tests/generator/schedule_test.cpp

#pragma once

#include "hls/numeric/bits.hpp"

namespace steplock {

enum class Inputs : std::uint8_t { kTaken, kHeld };
enum class Form : std::uint8_t { kSpread, kProgram };

struct Budget {
  int multipliers = 1;
  int width = 16;         // bits of a multiplier's first factor, signed; wider ones take turns
  int second_width = 16;  // of its second
  int clocks = 2;         // from start to done
  int levels = 12;        // look-up tables in a row; 8 bits of a carry count as one
  Inputs inputs = Inputs::kTaken;
  Form form = Form::kSpread;
  int early = 0;          // of a program: from start to the outputs in `early`; 0: it has none
};

template <class Block, Budget budget>
class Scheduled {
  static_assert(budget.multipliers >= 1 && budget.multipliers <= 16, "1 to 16 multipliers");
  static_assert(budget.width >= 4 && budget.width <= 64, "factors of 4 to 64 bits");
  static_assert(budget.second_width >= 4 && budget.second_width <= 64, "factors of 4 to 64 bits");
  static_assert(budget.clocks >= 2 && budget.clocks <= 4095, "2 to 4095 clocks");
  static_assert(budget.early == 0 || budget.form == Form::kProgram, "early outputs of a program");
  static_assert(budget.early >= 0 && budget.early <= budget.clocks, "early, not late");
  static_assert(budget.levels >= 3 && budget.levels <= 100, "3 to 100 levels");

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
  static constexpr bool kInputsAreHeld = budget.inputs == Inputs::kHeld;

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
